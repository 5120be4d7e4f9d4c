//! Quotients of two cosines, without a division.

use crate::arithmetic::short::{leading_zeros, product_down, scale_by_half};

/// Cells in [1/2, 1) of a divisor of 16 bits.
const FIRST: u32 = 64;
const LAST: u32 = 128;
/// Bits of the position within a cell.
const CELL_BITS: u32 = 9;
/// The reciprocal's scale: 2³¹/c, with 16 bits.
const SCALE_BITS: u32 = 31;

/// Value at the left end of a cell, and its fall over the cell in the lower
/// half.
static CELLS: [u32; (LAST - FIRST) as usize] = cells();

const fn cells() -> [u32; (LAST - FIRST) as usize] {
    let mut table = [0; (LAST - FIRST) as usize];
    let mut cell = FIRST;
    while cell < LAST {
        let left = lowered(cell);
        table[(cell - FIRST) as usize] = (left << 16) | (left - lowered(cell + 1));
        cell += 1;
    }
    table
}

/// 2³¹/c at a knot, less the chord's error: a chord is nowhere above the
/// curve, so that no quotient passes 1.
const fn lowered(knot: u32) -> u32 {
    let c = (knot << CELL_BITS) as u64;
    let width = 1u64 << CELL_BITS;
    // width²/8 · (2/c³) · 2³¹, and four steps for what is rounded.
    let sag = ((width * width) << (SCALE_BITS - 2)) / (c * c * c) + 4;
    ((1u64 << SCALE_BITS) / c - sag) as u32
}

/// A quotient of two cosines, as what a share is multiplied with one after the
/// other: however small it is, no digits are lost that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio15 {
    /// With the divisor's highest bit, which it is less than, at 30.
    dividend: u32,
    /// 2³¹ over the divisor's upper 16 bits.
    reciprocal: u32,
}

impl Ratio15 {
    /// a / b for 0 ≤ `a` < `b`, cosines with 30 fraction bits; below 1, and within
    /// 1.6e-4 of its value: `table::reciprocal::tests`.
    ///
    /// 256 bytes of table.
    #[inline]
    pub(crate) fn new(a: u32, b: u32) -> Self {
        // What a dividend of few digits has none of in its lower half is not multiplied:
        // a shift to the right would move them there.
        let room = leading_zeros(b).wrapping_sub(1) % 32;
        let (a, b) = (a << room, b << room);
        let cell = CELLS[(b >> (CELL_BITS + 15)) as usize % CELLS.len()];
        let within = (b >> 15) % (1 << CELL_BITS);
        Self {
            dividend: a,
            reciprocal: (cell >> 16) - (((cell & 0xFFFF) * within) >> CELL_BITS),
        }
    }

    /// As [`Self::new`], in one look-up: within 2.8e-4 of its value, so that it may
    /// be above 1, too.
    ///
    /// 4 KiB of table.
    #[inline(always)]
    pub(crate) fn direct(a: u32, b: u32) -> Self {
        let room = leading_zeros(b) % 32;
        let (a, b) = (a << room, b << room);
        let cell = (b >> (31 - DIRECT_BITS)) as usize % DIRECT.len();
        Self {
            dividend: a >> 1,
            reciprocal: u32::from(DIRECT[cell]),
        }
    }

    /// The quotient's part of a `share` of at most 2³¹, cut off within four steps.
    #[inline]
    pub(crate) fn of(self, share: u32) -> u32 {
        let part = product_down::<32>(share, self.dividend);
        scale_by_half(part << 2, self.reciprocal)
    }
}

/// Bits of a cell's number where each has one value.
const DIRECT_BITS: u32 = 11;

/// 2³¹/c at each cell's middle.
static DIRECT: [u16; 1 << DIRECT_BITS] = {
    let mut table = [0; 1 << DIRECT_BITS];
    let mut cell = 0;
    while cell < 1usize << DIRECT_BITS {
        let twice = (2 << DIRECT_BITS) + 2 * cell as u64 + 1;
        table[cell] = ((1 << (SCALE_BITS + DIRECT_BITS - 14)) / twice) as u16;
        cell += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::Ratio15;

    const ONE: u32 = 1 << 31;

    /// How far a quotient is off, in its value beyond four steps.
    fn relative_error(a: u32, b: u32) -> f64 {
        let found = f64::from(Ratio15::new(a, b).of(ONE));
        let exact = f64::from(a) / f64::from(b) * f64::from(ONE);
        assert!(found < f64::from(ONE), "{a}/{b}: {found}");
        ((exact - found).abs() - 4.0) / exact
    }

    #[test]
    fn every_pair_of_14_bits_is_within_the_bound() {
        let mut worst = 0.0f64;
        for b in 1..=1u32 << 14 {
            for a in 1..b {
                worst = worst.max(relative_error(a << 16, b << 16));
            }
        }
        assert!((5e-5..=1.6e-4).contains(&worst), "{worst:e}");
    }

    #[test]
    fn one_look_up_is_within_its_bound() {
        let (mut worst, mut random) = (0.0f64, 1u32);
        for i in 0..1u32 << 21 {
            random = random.wrapping_mul(0x9E37_79B1).wrapping_add(i);
            let b = (random >> (2 + i % 12)).max(2);
            for a in [1, b / 100, b / 3, b - 1] {
                let found = f64::from(Ratio15::direct(a.max(1), b).of(ONE));
                let exact = f64::from(a.max(1)) / f64::from(b) * f64::from(ONE);
                worst = worst.max(((exact - found).abs() - 4.0) / exact);
            }
        }
        assert!((2e-4..=2.8e-4).contains(&worst), "{worst:e}");
    }

    #[test]
    fn cosines_of_30_bits_are_within_the_bound() {
        let mut random = 1u64;
        let mut draw = || {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (random >> 34) as u32
        };
        let mut worst = 0.0f64;
        for _ in 0..1 << 20 {
            let b = (draw() >> (draw() % 30)).max(2);
            let a = draw() % (b - 1) + 1;
            worst = worst
                .max(relative_error(a, b))
                .max(relative_error(b - 1, b));
            worst = worst.max(relative_error((a >> (draw() % 30)).max(1), b));
        }
        assert!((5e-5..=1.6e-4).contains(&worst), "{worst:e}");
    }
}
