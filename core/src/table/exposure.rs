//! A gain, folded into what a share is multiplied by: linear light of 16 bits
//! from one product of 32.

use super::ENTRY_BITS;
use crate::error::ParameterError;

/// Bits of a factor, and of the share that it is multiplied by: a word that is
/// not negative holds the product.
pub(super) const FACTOR_BITS: u32 = 12;
const SHARE_BITS: u32 = WORD_BITS - FACTOR_BITS;
pub(super) const WORD_BITS: u32 = 31;
/// Half a step of a factor, in the word that holds one at its upper end.
const HALF: u32 = 1 << (WORD_BITS - FACTOR_BITS - 1);
/// Fraction bits of a gain times a reflectance: 32 and 15.
pub(super) const PRODUCT_BITS: u32 = 32 + 15;
/// Fraction bits of a share, which are a lobe's own, and of what comes out.
const UNIT_BITS: u32 = ENTRY_BITS;
const LIGHT_BITS: u32 = 16;
/// The most bits of headroom that a limited share may leave: a factor of 128
/// between the channels.
const HEADROOM: i32 = 8;

const GAIN_RANGE: ParameterError = ParameterError::new(
    "gain",
    "below 256, or such that no channel is 128 times as bright as another",
);

/// From a share and a factor to linear light. Beyond K = 1000 a step of a share,
/// 2⁻²⁵, is more than half of one of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Exposure {
    /// The share beyond which every channel is white.
    limit: u32,
    /// From a share's fraction bits to those of the product: one is 0.
    right: u32,
    left: u32,
    /// From the product to linear light.
    down: u32,
    /// What factors are multiples of, as a power of two.
    exponent: i32,
}

impl Exposure {
    /// For factors between `least` and `greatest` with [`PRODUCT_BITS`]; what
    /// is 0 everywhere is in neither.
    ///
    /// # Errors
    /// Factors with which a share that makes one channel 256 leaves another
    /// below 1.
    pub(super) const fn new(least: u128, greatest: u128) -> Result<Self, ParameterError> {
        // The greatest is at most 2^exponent and above half of it.
        let bits = 128 - greatest.saturating_sub(1).leading_zeros();
        let exponent = bits as i32 - PRODUCT_BITS as i32;
        // Where a share is limited the brightest channel has at least half of
        // 2^headroom, and so the darkest at least 1.
        // Eight times white need no limit.
        let mut headroom = 3;
        while headroom < HEADROOM && least.saturating_mul(1 << (headroom - 1)) < greatest {
            headroom += 1;
        }
        if exponent > HEADROOM && least.saturating_mul(1 << (HEADROOM - 1)) < greatest {
            return Err(GAIN_RANGE);
        }
        let up = if exponent > headroom {
            (exponent - headroom) as u32
        } else {
            0
        };
        let excess = UNIT_BITS - SHARE_BITS;
        let down = (WORD_BITS - LIGHT_BITS) as i32 - exponent + up as i32;
        Ok(Self {
            limit: match up {
                0 => u32::MAX,
                1..UNIT_BITS => 1 << (UNIT_BITS - up),
                _ => 1,
            },
            right: excess.saturating_sub(up),
            left: if up < UNIT_BITS {
                up.saturating_sub(excess)
            } else {
                SHARE_BITS
            },
            // Beyond that everything is less than a step.
            down: if down < 32 { down as u32 } else { 31 },
            exponent,
        })
    }

    /// A factor at the upper end of a word, with half a step more: cut off, it
    /// is rounded. `product` has [`PRODUCT_BITS`].
    pub(super) const fn word(&self, product: u128) -> i32 {
        let places = PRODUCT_BITS as i32 + self.exponent - WORD_BITS as i32;
        let word = if places >= 0 {
            product >> places
        } else {
            product << -places
        };
        // The greatest is at most 2³¹; below it by two steps rounding can't wrap.
        let greatest = (i32::MAX - 2 * HALF as i32) as u128;
        let word = if word < greatest { word } else { greatest };
        (word as u32 + HALF) as i32
    }

    /// A share, at most 1, with a lobe table's fraction bits, as it is
    /// multiplied.
    #[inline(always)]
    pub(super) fn share(&self, share: u32) -> i32 {
        let share = share.min(self.limit);
        ((share >> (self.right % 32)) << (self.left % 32)) as i32
    }

    /// A factor times such a share: linear light, at most its greatest value.
    #[inline(always)]
    pub(super) fn light(&self, factor: i32, share: i32) -> u16 {
        let light = factor.wrapping_mul(share) >> (self.down % 32);
        if cfg!(saturates) {
            light.clamp(0, 0xFFFF) as u16
        } else {
            // It is not negative, which only the builder of the factors knows.
            (light as u32).min(0xFFFF) as u16
        }
    }
}

/// A word's factor.
#[inline(always)]
pub(super) const fn factor(word: i32) -> i32 {
    word >> (WORD_BITS - FACTOR_BITS)
}
