//! CRC-32/ISO-HDLC, the one checksum of the protocol.
//!
//! Packets and frames share it, so that a device carries a single table of
//! 1 KiB in flash, or with the feature `small` one of 64 bytes. It is the CRC
//! of zlib, PNG and Ethernet.

#[cfg(not(feature = "small"))]
mod whole {
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
}

/// By half bytes. (Without a table of its own, the library's code for any
/// width of polynomial takes as much flash as its table.)
#[cfg(any(feature = "small", test))]
mod halves {
    /// The polynomial, lowest bit first.
    const POLYNOMIAL: u32 = 0xEDB8_8320;

    /// What four bits that leave come to.
    static TABLE: [u32; 16] = table();

    // At compile time, where a mistake is an error.
    #[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)]
    const fn table() -> [u32; 16] {
        let mut table = [0; 16];
        let mut bits: u32 = 0;
        while bits < 16 {
            let mut value = bits;
            let mut bit = 0;
            while bit < 4 {
                value = (value >> 1) ^ (POLYNOMIAL & 0u32.wrapping_sub(value & 1));
                bit += 1;
            }
            table[bits as usize] = value;
            bits += 1;
        }
        table
    }

    /// Checksum of one packet's bytes.
    pub(crate) fn packet_checksum(bytes: &[u8]) -> u32 {
        let mut checksum = FrameChecksum::new();
        checksum.update(bytes);
        checksum.value()
    }

    /// Running checksum over all pixel bytes of a frame, in raster order.
    #[derive(Clone)]
    pub struct FrameChecksum(u32);

    impl FrameChecksum {
        /// The checksum of nothing.
        pub fn new() -> Self {
            Self(u32::MAX)
        }

        /// Takes in the next pixel bytes.
        #[inline(never)]
        pub fn update(&mut self, pixels: &[u8]) {
            for byte in pixels {
                self.0 ^= u32::from(*byte);
                for _ in 0..2 {
                    let out = TABLE.get((self.0 & 15) as usize).copied();
                    self.0 = (self.0 >> 4) ^ out.unwrap_or_default();
                }
            }
        }

        /// The checksum of all that was taken in; Python's `zlib.crc32` gives the same.
        pub fn value(&self) -> u32 {
            !self.0
        }
    }
}

#[cfg(feature = "small")]
pub use halves::FrameChecksum;
#[cfg(feature = "small")]
pub(crate) use halves::packet_checksum;
#[cfg(not(feature = "small"))]
pub use whole::FrameChecksum;
#[cfg(not(feature = "small"))]
pub(crate) use whole::packet_checksum;

impl Default for FrameChecksum {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(all(test, not(feature = "small")))]
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)]
mod tests {
    #[test]
    fn by_half_bytes_as_by_the_library() {
        let mut bytes = [0; 300];
        for (i, byte) in bytes.iter_mut().enumerate() {
            *byte = (i * i + 7 * i) as u8;
        }
        for length in 0..bytes.len() {
            let part = &bytes[..length];
            assert_eq!(
                super::halves::packet_checksum(part),
                super::packet_checksum(part)
            );
        }
    }
}
