//! The kinds of packet: what each means and how its body is laid out.

mod end;
mod fault;
mod header;
mod pixels;

pub use end::EndOfFrame;
pub use fault::{Fault, FaultCode};
pub use header::{Header, HeaderError};
pub use pixels::Pixels;

/// What a packet is: the first byte of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Kind {
    /// A frame begins, or goes on: [`Header`].
    Header = 1,
    /// Pixels of one row: [`Pixels`].
    Pixels = 2,
    /// The frame is over: [`EndOfFrame`].
    End = 3,
    /// The device failed: [`Fault`].
    Fault = 4,
    /// Bytes of a log, passed on unread.
    Log = 5,
}

impl Kind {
    /// The kind with this code; `None` if this version knows no such kind.
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            1 => Some(Self::Header),
            2 => Some(Self::Pixels),
            3 => Some(Self::End),
            4 => Some(Self::Fault),
            5 => Some(Self::Log),
            _ => None,
        }
    }

    /// The code that stands for this kind.
    pub const fn code(self) -> u8 {
        self as u8
    }
}
