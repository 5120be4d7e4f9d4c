//! The kinds of packet: what each means and how its body is laid out.

mod end;
mod fault;
mod fields;
mod header;
mod pixels;

use crate::deframe::RawPacket;
use crate::format::PROTOCOL_VERSION;

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

    /// What messages call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Header => "header",
            Self::Pixels => "pixels",
            Self::End => "end of frame",
            Self::Fault => "fault",
            Self::Log => "log",
        }
    }

    /// The code that stands for this kind.
    pub const fn code(self) -> u8 {
        self as u8
    }
}

/// A packet with its checked meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Packet<'a> {
    /// A frame begins, or goes on.
    Header(Header<'a>),
    /// Pixels of one row.
    Pixels(Pixels<'a>),
    /// The frame is over.
    End(EndOfFrame),
    /// The device failed.
    Fault(Fault<'a>),
    /// Bytes of a log.
    Log(&'a [u8]),
}

impl<'a> Packet<'a> {
    /// Checks everything about a packet that can be checked without knowing
    /// the frame it belongs to.
    ///
    /// # Errors
    /// [`PacketError`] says what is wrong.
    pub fn parse(raw: RawPacket<'a>) -> Result<Self, PacketError> {
        let kind = Kind::from_code(raw.kind).ok_or(PacketError::UnknownKind { code: raw.kind })?;
        let malformed = PacketError::Layout {
            kind: kind.name(),
            length: raw.payload.len(),
        };
        match kind {
            Kind::Header => Header::parse(raw.payload).map(Self::Header),
            Kind::Pixels => Pixels::parse(raw.payload)
                .map(Self::Pixels)
                .ok_or(malformed),
            Kind::End => EndOfFrame::parse(raw.payload)
                .map(Self::End)
                .ok_or(malformed),
            Kind::Fault => Fault::parse(raw.payload).map(Self::Fault).ok_or(malformed),
            Kind::Log => Ok(Self::Log(raw.payload)),
        }
    }
}

/// Why a packet with a right checksum makes no sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PacketError {
    /// A kind that this version does not know; to be passed over.
    #[error("unknown kind {code}")]
    UnknownKind {
        /// The first byte of the packet.
        code: u8,
    },
    /// A header of another protocol version.
    #[error(
        "the sender speaks version {version} of the protocol, this side version {PROTOCOL_VERSION}"
    )]
    Version {
        /// The sender's version.
        version: u8,
    },
    /// Too short or too long for its kind.
    #[error(
        "a {kind} packet cannot have a payload of {length} bytes, or its fields disagree with that"
    )]
    Layout {
        /// Name of the kind.
        kind: &'static str,
        /// Bytes after the kind.
        length: usize,
    },
    /// No such pixel format.
    #[error("unknown pixel format {code}")]
    PixelFormat {
        /// The code in the header.
        code: u8,
    },
    /// Flags that this version does not know.
    #[error("unknown flags {flags:#04x}")]
    Flags {
        /// The flags byte of the header.
        flags: u8,
    },
    /// A field of the header is out of range.
    #[error("header: {0}")]
    Header(HeaderError),
}
