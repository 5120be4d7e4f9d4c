//! What a step of z² holds.

use super::wide::clamp;

/// Fraction bits of an offset over the cutoff's.
pub(super) const OFFSET_BITS: u32 = 12;
/// Those of it that a pixel does not look at.
pub(super) const WAY_BITS: u32 = 16;
/// Fraction bits of a slope.
pub(super) const SLOPE_BITS: u32 = 8;

/// Four cutoffs, farther than which none is told from another: within the
/// lobe's reach, whose pixels are less than two from its middle, they are beyond
/// the lobe.
pub(super) const FAR: i64 = 4 << (OFFSET_BITS + WAY_BITS);

/// d's part along z, in cutoffs with 28 fraction bits, rounded so that its lower
/// half is a slope: 2sinθ · cutoff/z with its sign changed, 8 fraction bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word(i32);

impl Word {
    /// A word beyond any lobe.
    pub(super) const BEYOND: Self = Self::new(FAR, 0);

    /// For both as they are, the slope not negative; those that 16 bits do not
    /// hold are within 2e-4 radii of the sphere's edge.
    pub(super) const fn new(offset: i64, slope: i64) -> Self {
        let slope = -clamp(slope, 0, i16::MAX as i64) as i16;
        let lower = slope as u16 as i64;
        let offset = clamp(offset, -FAR, FAR);
        let upper = (offset - lower + (1 << (WAY_BITS - 1))) >> WAY_BITS;
        Self((upper << WAY_BITS | lower) as i32)
    }

    #[inline(always)]
    pub(super) const fn offset(self) -> i32 {
        self.0
    }

    /// Not positive.
    #[inline(always)]
    pub(super) const fn slope(self) -> i32 {
        self.0 as i16 as i32
    }
}

#[cfg(test)]
mod tests {
    use super::Word;

    #[test]
    fn a_word_is_within_half_a_step_of_its_offset() {
        for slope in [0, 1, 0x3FFF, 0x7FFF, 0x8000, 1 << 40] {
            for offset in (-(1 << 30)..=1i64 << 30).step_by(0xFFF1) {
                let word = Word::new(offset, slope);
                assert!((i64::from(word.offset()) - offset).abs() <= 1 << 15);
                assert_eq!(i64::from(word.slope()), -slope.min(0x7FFF));
            }
        }
        assert!(Word::new(i64::MAX / 2, 0) == Word::BEYOND);
    }
}
