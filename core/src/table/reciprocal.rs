//! Quotients of two cosines, without a division.

/// Cells in [1/4, 1] of a cosine with 14 fraction bits.
const FIRST: u32 = 32;
const LAST: u32 = 128;
/// Bits of the position within a cell.
const CELL_BITS: u32 = 7;
/// Cosines below 1/4 are scaled up, two bits at a time.
const LEAST: u32 = FIRST << CELL_BITS;
/// The reciprocal's scale: 2²⁸ / c, with 16 bits.
const SCALE_BITS: u32 = 28;

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

/// 2²⁸/c at a knot, less half of the chord's error to either side.
const fn lowered(knot: u32) -> u32 {
    let c = (knot << CELL_BITS) as u64;
    let width = 1u64 << CELL_BITS;
    // width²/8 · (2/c³) · 2²⁸ / 2.
    let sag = ((width * width) << (SCALE_BITS - 3)) / (c * c * c);
    let value = ((1u64 << SCALE_BITS) + c / 2) / c - sag;
    if value < 0xFFFF { value as u32 } else { 0xFFFF }
}

/// a / b with 20 fraction bits for 0 ≤ `a` < `b`, cosines with 14 fraction
/// bits; within 1.4e-4 of its value + 2⁻²⁰, tested for every pair of
/// arguments in `table::reciprocal::tests`. A `b` above 1 counts as 1.
///
/// 384 bytes of table.
#[inline]
pub(crate) fn quotient(mut a: u32, mut b: u32) -> u32 {
    while b < LEAST {
        if b == 0 {
            return 0;
        }
        a <<= 2;
        b <<= 2;
    }
    let Some(&cell) = CELLS.get((b >> CELL_BITS).wrapping_sub(FIRST) as usize) else {
        return if a < 1 << 14 { a << 6 } else { 1 << 20 };
    };
    let fall = (cell & 0xFFFF) * (b % (1 << CELL_BITS));
    let reciprocal = (cell >> 16) - (fall >> CELL_BITS);
    // Rounding up may pass 1 where a is just below b.
    ((a * reciprocal) >> (SCALE_BITS - 20)).min(1 << 20)
}

#[cfg(test)]
mod tests {
    use super::quotient;

    #[test]
    fn every_pair_is_within_the_bound() {
        let mut worst = 0.0f64;
        for b in 1..=1u32 << 14 {
            assert_eq!(quotient(0, b), 0);
            let one = 1_048_576.0 / f64::from(b);
            for a in 1..b {
                let exact = f64::from(a) * one;
                let found = quotient(a, b);
                assert!(found <= 1 << 20, "{a}/{b}");
                worst = worst.max(((f64::from(found) - exact).abs() - 1.0) / exact);
            }
        }
        assert!((1e-4..=1.4e-4).contains(&worst), "{worst:e}");
    }

    #[test]
    fn a_divisor_above_one_counts_as_one() {
        assert_eq!(quotient(1 << 13, 20_000), 1 << 19);
        assert_eq!(quotient(19_000, 20_000), 1 << 20);
        assert_eq!(quotient(0, 0), 0);
    }
}
