//! From a packet's body to bytes on the wire: checksum, COBS, delimiters.

use crate::bounded::{Bounded, Full};
use crate::checksum::packet_checksum;
use crate::format::{MAX_PACKET, MAX_WIRE};

/// The byte that separates packets and occurs nowhere else on the wire.
pub(crate) const DELIMITER: u8 = 0;

/// The bytes of one packet as they go over the wire.
pub type WirePacket = Bounded<MAX_WIRE>;

/// A packet under construction, without its checksum.
pub(crate) type Body = Bounded<{ MAX_PACKET - 4 }>;

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
    let mut packet = Bounded::<MAX_PACKET>::new();
    packet.extend(body)?;
    packet.extend(&packet_checksum(body).to_le_bytes())?;

    let mut wire = WirePacket::new();
    if fresh_start {
        wire.push(DELIMITER)?;
    }
    let mut encoded = [0; MAX_PACKET + 1];
    let length = cobs::try_encode(packet.as_slice(), &mut encoded).map_err(|_| Full)?;
    wire.extend(encoded.get(..length).ok_or(Full)?)?;
    wire.push(DELIMITER)?;
    Ok(wire)
}
