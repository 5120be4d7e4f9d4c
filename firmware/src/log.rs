//! Log lines, which leave between the rows.

use heapless::Vec;
use microbrdf_link::MAX_LOG;

/// Where log lines wait: they must not come in the middle of another packet.
pub trait LogSource {
    /// Whether anything is ever logged: what sends it is left out if not.
    const KEEPS: bool = true;

    /// Takes out what has gathered since the last call; empty if nothing has.
    fn take(&mut self) -> Vec<u8, MAX_LOG>;

    /// All rows of frame `number` are sent, its end is not: the last moment to
    /// log something about it.
    fn frame_ends(&mut self, number: u16) {
        let _ = number;
    }
}

/// No log.
pub struct NoLog;

impl LogSource for NoLog {
    const KEEPS: bool = false;

    fn take(&mut self) -> Vec<u8, MAX_LOG> {
        Vec::new()
    }
}
