//! Results as bytes.

use crc::{CRC_64_XZ, Crc, Digest, Table};
use fixed::types::{U1F31, U32F32, U64F64};
use microbrdf::Rgb;

/// CRC-64/XZ over results.
pub struct Checksum(Digest<'static, u64, Table<1>>);

static CRC: Crc<u64, Table<1>> = Crc::<u64, Table<1>>::new(&CRC_64_XZ);

impl Checksum {
    /// That of nothing.
    #[must_use]
    #[expect(
        clippy::new_without_default,
        reason = "a digest of nothing is no default"
    )]
    pub fn new() -> Self {
        Self(CRC.digest())
    }

    /// Takes in one result.
    pub fn feed(&mut self, result: impl Raw) {
        result.bytes(&mut |bytes| self.0.update(bytes));
    }

    /// Takes in three channels.
    pub fn feed_rgb<T: Raw>(&mut self, result: Rgb<T>) {
        for channel in result.to_array() {
            self.feed(channel);
        }
    }

    /// The checksum of all that was taken in.
    #[must_use]
    pub fn value(self) -> u64 {
        self.0.finalize()
    }
}

/// A number as it is represented, least significant byte first.
pub trait Raw: Copy {
    /// Hands over its bytes.
    fn bytes(&self, sink: &mut dyn FnMut(&[u8]));
}

macro_rules! raw {
    ($($type:ty: $number:ident => $bits:expr;)+) => {$(
        impl Raw for $type {
            fn bytes(&self, sink: &mut dyn FnMut(&[u8])) {
                let $number = *self;
                sink(&$bits.to_le_bytes());
            }
        }
    )+};
}

raw! {
    f32: number => number.to_bits();
    U1F31: number => number.to_bits();
    U32F32: number => number.to_bits();
    U64F64: number => number.to_bits();
    u32: number => number;
}
