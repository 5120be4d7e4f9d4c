//! From bytes on the wire to checked packets.

use cobs::{DecodeResult, DecoderState};

use crate::bounded::Bounded;
use crate::checksum::packet_checksum;
use crate::format::MAX_PACKET;

/// Bytes of the checksum that ends a packet.
const CHECKSUM: usize = 4;

/// A packet whose checksum is right, and of which nothing else is known yet.
///
/// [`Packet::parse`](crate::Packet::parse) gives its meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawPacket<'a> {
    /// First byte of the body; see [`Kind`](crate::Kind).
    pub kind: u8,
    /// What follows it, without the checksum.
    pub payload: &'a [u8],
}

/// Cuts a stream of bytes into packets.
///
/// It holds one packet and no more, and after any damage is right again from
/// the next delimiter on.
pub struct Deframer {
    cobs: DecoderState,
    packet: Bounded<MAX_PACKET>,
    too_long: bool,
}

impl Deframer {
    /// A deframer at the start of a stream.
    pub const fn new() -> Self {
        Self {
            cobs: DecoderState::Idle,
            packet: Bounded::new(),
            too_long: false,
        }
    }

    /// Takes in one byte. `None` means that more are needed; empty packets
    /// (two delimiters in a row) are passed over.
    pub fn push(&mut self, byte: u8) -> Option<Result<RawPacket<'_>, DeframeError>> {
        match self.cobs.feed(byte) {
            Ok(DecodeResult::NoData) => None,
            Ok(DecodeResult::DataStart) => {
                self.packet.clear();
                self.too_long = false;
                None
            }
            Ok(DecodeResult::DataContinue(decoded)) => {
                self.too_long |= self.packet.push(decoded).is_err();
                None
            }
            Ok(DecodeResult::DataComplete) if self.too_long => Some(Err(DeframeError::TooLong)),
            Ok(DecodeResult::DataComplete) => Some(check(self.packet.as_slice())),
            Err(_) => Some(Err(DeframeError::Cobs)),
        }
    }
}

impl Default for Deframer {
    fn default() -> Self {
        Self::new()
    }
}

/// Tells a packet's body from its checksum, and whether they agree.
fn check(packet: &[u8]) -> Result<RawPacket<'_>, DeframeError> {
    let (body, sum) = packet
        .split_last_chunk::<CHECKSUM>()
        .ok_or(DeframeError::TooShort)?;
    let (&kind, payload) = body.split_first().ok_or(DeframeError::TooShort)?;
    if packet_checksum(body) != u32::from_le_bytes(*sum) {
        return Err(DeframeError::Checksum);
    }
    Ok(RawPacket { kind, payload })
}

/// Why what stood between two delimiters is no packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DeframeError {
    /// A COBS code byte points past the delimiter.
    #[error("not COBS")]
    Cobs,
    /// Longer than any packet of the protocol.
    #[error("longer than {MAX_PACKET} bytes")]
    TooLong,
    /// Too short for a kind and a checksum.
    #[error("shorter than 5 bytes")]
    TooShort,
    /// The checksum does not agree with the bytes.
    #[error("wrong checksum")]
    Checksum,
}
