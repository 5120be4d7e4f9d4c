//! From a packet's body to bytes on the wire: checksum, COBS, delimiters.

use crate::bounded::{Bounded, Full};
use crate::checksum::packet_checksum;
use crate::format::{MAX_PACKET, MAX_WIRE};

/// The byte that separates packets and occurs nowhere else on the wire.
pub(crate) const DELIMITER: u8 = 0;

/// The bytes of one packet as they go over the wire.
pub type WirePacket = Bounded<MAX_WIRE>;

/// Bytes of a packet but for its checksum, at most.
const MAX_BODY: usize = MAX_PACKET - 4;

/// A packet under construction, in the one buffer in which it is also framed:
/// the smallest boards have no RAM for a second.
#[derive(Clone)]
pub(crate) struct Body(WirePacket);

/// Where a body begins, behind a delimiter and the place of a code byte.
const START: usize = 2;

impl Body {
    /// An empty one.
    pub(crate) fn new() -> Self {
        let mut wire = WirePacket::new();
        // Never full: the buffer is longer.
        let _ = wire.extend(&[DELIMITER; START]);
        Self(wire)
    }

    /// What was put in.
    pub(crate) fn as_slice(&self) -> &[u8] {
        self.0.as_slice().get(START..).unwrap_or_default()
    }

    /// Appends all of `more`, if a packet may be so long; else it is unchanged.
    pub(crate) fn extend(&mut self, more: &[u8]) -> Result<(), Full> {
        if self.as_slice().len().saturating_add(more.len()) > MAX_BODY {
            return Err(Full);
        }
        self.0.extend(more)
    }

    /// Appends one byte.
    pub(crate) fn push(&mut self, byte: u8) -> Result<(), Full> {
        self.extend(&[byte])
    }

    /// Ends the packet: appends its checksum, encodes both with COBS in place,
    /// and hands the bytes for the wire to `send`; then it is empty again.
    pub(crate) fn send<T>(
        &mut self,
        fresh_start: bool,
        send: impl FnOnce(&[u8]) -> T,
    ) -> Result<T, Full> {
        let checksum = packet_checksum(self.as_slice());
        self.0.extend(&checksum.to_le_bytes())?;
        stuff(self.0.as_mut_slice().get_mut(START - 1..).ok_or(Full)?);
        self.0.push(DELIMITER)?;
        let first = if fresh_start { 0 } else { 1 };
        let sent = send(self.0.as_slice().get(first..).ok_or(Full)?);
        self.0.clear();
        self.0.extend(&[DELIMITER; START])?;
        Ok(sent)
    }
}

/// Frames a packet: appends its checksum, encodes both with COBS and ends them
/// with a delimiter.
///
/// `body` is the kind and what belongs to it, at most [`MAX_PACKET`] − 4 bytes.
/// With `fresh_start` a delimiter is sent ahead too, which ends whatever the
/// line carried before: noise, or a packet that a fault cut off.
///
/// # Errors
/// [`Full`] if the body is too long.
pub fn encode_packet(body: &[u8], fresh_start: bool) -> Result<WirePacket, Full> {
    let mut packet = Body::new();
    packet.extend(body)?;
    let mut wire = WirePacket::new();
    packet.send(fresh_start, |bytes| wire.extend(bytes))??;
    Ok(wire)
}

/// COBS in place, for at most 254 bytes behind the first: each zero, and the
/// first byte, becomes the distance to the next zero, or to the end.
///
/// The library encodes from one buffer to another, for which the smallest
/// boards have no RAM; `tests::in_place_is_as_the_library` compares the two.
fn stuff(bytes: &mut [u8]) {
    let mut distance: u8 = 1;
    let mut rest = bytes.iter_mut().rev().peekable();
    while let Some(byte) = rest.next() {
        if *byte == 0 || rest.peek().is_none() {
            *byte = distance;
            distance = 1;
        } else {
            distance = distance.wrapping_add(1);
        }
    }
}

#[cfg(test)]
#[allow(
    clippy::arithmetic_side_effects,
    clippy::indexing_slicing,
    clippy::unwrap_used
)]
mod tests {
    use super::{Body, encode_packet, stuff};

    #[test]
    fn in_place_is_as_the_library() {
        for length in 0..=254usize {
            for every in [1, 2, 3, 7, 100, 253, 254, 300] {
                let mut message = [0u8; 255];
                for (i, byte) in message.iter_mut().enumerate().skip(1) {
                    *byte = if i % every == 0 {
                        0
                    } else {
                        1 + (i % 255) as u8
                    };
                }
                let mut encoded = [0; 300];
                let wanted = cobs::encode(&message[1..=length], &mut encoded);
                let found = &mut message[..=length];
                stuff(found);
                assert_eq!(
                    *found,
                    encoded[..wanted],
                    "{length} bytes, zero every {every}"
                );
            }
        }
    }

    #[test]
    fn a_body_that_is_too_long_is_refused() {
        assert!(encode_packet(&[1; 250], true).is_ok());
        assert!(encode_packet(&[1; 251], false).is_err());
        assert_eq!(Body::new().extend(&[0; 250]), Ok(()));
    }
}
