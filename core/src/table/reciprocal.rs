//! Quotients of two cosines, without a division.

use crate::arithmetic::short::room;

/// Cells in [1/2, 1) of a divisor of 16 bits.
const FIRST: u32 = 64;
const LAST: u32 = 128;
/// Bits of the position within a cell.
const CELL_BITS: u32 = 9;
/// The reciprocal's scale: 2³¹/c, with 16 bits.
const SCALE_BITS: u32 = 31;
/// Fraction bits of a quotient.
const QUOTIENT_BITS: u32 = 16;

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
    // width²/8 · (2/c³) · 2³¹, and two steps for what is rounded down.
    let sag = ((width * width) << (SCALE_BITS - 2)) / (c * c * c) + 2;
    ((1u64 << SCALE_BITS) / c - sag) as u32
}

/// a / b with 16 fraction bits for 0 < `a` < `b`, cosines with 30 fraction
/// bits; at most 1. Its error is at most 1.2e-4 of its value + 4e-5 (+ 1e-5 for
/// cosines of 14 bits);
/// `table::reciprocal::tests`.
///
/// 256 bytes of table.
#[inline]
pub(crate) fn quotient(a: u32, b: u32) -> u32 {
    let room = room(b) % 32;
    // The divisor then has 16 bits.
    let (a, b) = ((a << room) >> 15, (b << room) >> 15);
    let Some(&cell) = CELLS.get((b >> CELL_BITS).wrapping_sub(FIRST) as usize) else {
        // A divisor of 0, or far above 1.
        return 0;
    };
    let fall = (cell & 0xFFFF) * (b % (1 << CELL_BITS));
    let reciprocal = (cell >> 16) - (fall >> CELL_BITS);
    const DROP: u32 = SCALE_BITS - QUOTIENT_BITS;
    (a * reciprocal + (1 << (DROP - 1))) >> DROP
}

#[cfg(test)]
mod tests {
    use super::quotient;

    const ONE: f64 = 65_536.0;

    /// How far a quotient is off, in its value beyond 4e-5.
    fn relative_error(a: u32, b: u32, step: f64) -> f64 {
        let found = quotient(a, b);
        assert!(found <= 1 << 16, "{a}/{b}");
        let exact = f64::from(a) / f64::from(b) * ONE;
        ((f64::from(found) - exact).abs() - step * ONE) / exact
    }

    #[test]
    fn every_pair_of_14_bits_is_within_the_bound() {
        let mut worst = 0.0f64;
        for b in 1..=1u32 << 14 {
            for a in 1..b {
                worst = worst.max(relative_error(a << 16, b << 16, 1e-5));
            }
        }
        assert!((5e-5..=1.2e-4).contains(&worst), "{worst:e}");
    }

    #[test]
    fn cosines_of_30_bits_are_within_the_bound() {
        let mut random = 1u64;
        let mut draw = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (random >> 34) as u32
        };
        for _ in 0..1 << 20 {
            let b = (draw() >> (draw() % 30)).max(2);
            let a = draw() % (b - 1) + 1;
            assert!(relative_error(a, b, 4e-5) <= 1.2e-4, "{a}/{b}");
            assert!(relative_error(b - 1, b, 4e-5) <= 1.2e-4, "{b} - 1");
        }
    }

    #[test]
    fn what_is_no_quotient_of_cosines_is_finite() {
        assert_eq!(quotient(0, 0), 0);
        assert_eq!(quotient(1, u32::MAX), 0);
        assert!(quotient(1 << 30, (1 << 31) - 1) <= 1 << 16);
    }
}
