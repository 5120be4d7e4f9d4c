//! CRC-32/ISO-HDLC, the one checksum of the protocol.
//!
//! Packets and frames share it, so that a device carries a single table of
//! 1 KiB in flash. It is the CRC of zlib, PNG and Ethernet.

use crc::{CRC_32_ISO_HDLC, Crc, Digest, Table};

static CRC32: Crc<u32, Table<1>> = Crc::<u32, Table<1>>::new(&CRC_32_ISO_HDLC);

/// Checksum of one packet's bytes.
pub(crate) fn packet_checksum(bytes: &[u8]) -> u32 {
    CRC32.checksum(bytes)
}

/// Running checksum over all pixel bytes of a frame, in raster order.
#[derive(Clone)]
pub struct FrameChecksum(Digest<'static, u32, Table<1>>);

impl FrameChecksum {
    /// The checksum of nothing.
    pub fn new() -> Self {
        Self(CRC32.digest())
    }

    /// Takes in the next pixel bytes.
    pub fn update(&mut self, pixels: &[u8]) {
        self.0.update(pixels);
    }

    /// The checksum of all that was taken in; Python's `zlib.crc32` gives the same.
    pub fn value(&self) -> u32 {
        self.0.clone().finalize()
    }
}

impl Default for FrameChecksum {
    fn default() -> Self {
        Self::new()
    }
}
