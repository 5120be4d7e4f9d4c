//! The serial line as the application sees it: a queue that an interrupt empties.

use core::convert::Infallible;

use embedded_io::{ErrorType, Write};
use heapless::spsc::Producer;

/// The other end of the queue.
pub trait Drain {
    /// Makes the transmit interrupt run soon. It is called after each write, and
    /// again and again by a writer that waits: so a lost interrupt of the
    /// UART's own delays bytes, but never strands them.
    fn wake(&mut self);

    /// Whether the UART has sent all that it was given.
    fn is_idle(&mut self) -> bool;
}

/// The writing end of a queue of bytes; whatever empties it runs at the same time.
///
/// A write returns as soon as its bytes are in the queue. While that is full it
/// waits: no byte is ever lost.
pub struct QueuedSerial<'q, D> {
    queue: Producer<'q, u8>,
    drain: D,
}

impl<'q, D: Drain> QueuedSerial<'q, D> {
    /// The writing end of `queue`, which `drain` empties.
    pub fn new(queue: Producer<'q, u8>, drain: D) -> Self {
        Self { queue, drain }
    }

    fn enqueue(&mut self, bytes: &[u8]) -> usize {
        bytes
            .iter()
            .take_while(|&&byte| self.queue.enqueue(byte).is_ok())
            .count()
    }
}

impl<D> ErrorType for QueuedSerial<'_, D> {
    type Error = Infallible;
}

impl<D: Drain> Write for QueuedSerial<'_, D> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        loop {
            let taken = self.enqueue(bytes);
            self.drain.wake();
            if taken > 0 || bytes.is_empty() {
                return Ok(taken);
            }
        }
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while !self.queue.is_empty() || !self.drain.is_idle() {
            self.drain.wake();
        }
        Ok(())
    }
}
