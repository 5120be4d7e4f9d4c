//! The wire format between a shading microcontroller and its receiver.
//!
//! This crate moves pictures as bytes; it knows nothing of how they are shaded.
//! `docs/wire-format.md` specifies what goes over the wire, with example bytes
//! that this crate's tests read from there.
//!
//! * To send: [`FrameWriter`] over any [`embedded_io::Write`]; in a panic or
//!   fault handler [`send_fault`].
//! * To receive: [`Reassembler`], fed with whatever bytes come in. Beneath it
//!   lie [`Deframer`] (bytes to packets) and [`Packet::parse`] (the checked
//!   meaning of a packet).
//! * To test: [`FaultInjector`], a sink that damages what passes through it.
//!
//! Nothing here allocates or panics, and every buffer has a fixed size. One
//! packet is at most [`MAX_PACKET`] bytes, so a sender needs about half a
//! kilobyte of RAM, whatever the size of the picture.
//!
//! ```
//! use microbrdf_link::{Event, FrameWriter, Header, PixelFormat, Reassembler};
//!
//! let header = Header {
//!     board: "bench",
//!     scene: "two pixels",
//!     ..Header::new(2, 1, PixelFormat::Srgb8)
//! };
//! let mut writer = FrameWriter::begin(Vec::new(), &header)?;
//! writer.row(0, &[255, 0, 0, 0, 0, 255])?;
//! let wire = writer.end()?;
//!
//! let (mut pixels, mut present) = ([0; 64], [0; 8]);
//! let mut whole = false;
//! Reassembler::new(&mut pixels, &mut present).feed(&wire, |event| {
//!     if let Event::FrameEnds(report, picture) = event {
//!         assert_eq!(picture.bytes(), [255, 0, 0, 0, 0, 255]);
//!         whole = report.is_whole();
//!     }
//! });
//! assert!(whole);
//! # Ok::<(), microbrdf_link::SendError<core::convert::Infallible>>(())
//! ```
#![no_std]
#![deny(
    clippy::arithmetic_side_effects,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unreachable,
    clippy::unwrap_used
)]

mod bounded;
mod checksum;
mod deframe;
mod format;
mod injector;
mod packet;
mod picture;
mod reassemble;
mod send;
mod wire;

pub use bounded::{Bounded, Full};
pub use checksum::FrameChecksum;
pub use deframe::{DeframeError, Deframer, RawPacket};
pub use format::{
    MAX_CHUNK, MAX_COMPILER, MAX_FAULT_TEXT, MAX_LOG, MAX_NAME, MAX_PACKET, MAX_WIRE,
    PROTOCOL_VERSION, PixelFormat,
};
pub use injector::{Damage, FaultInjector, Faults};
pub use packet::{
    EndOfFrame, Fault, FaultCode, Header, HeaderError, Kind, Packet, PacketError, Pixels,
};
pub use picture::Picture;
pub use reassemble::{Event, FrameReport, Reassembler, ReceiveError, Statistics, Stopped};
pub use send::{FrameWriter, SendError, max_row_wire_bytes, send_fault, send_fault_text, send_log};
pub use wire::{WirePacket, encode_packet};
