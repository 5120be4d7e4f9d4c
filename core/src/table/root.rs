//! Square root in 32-bit steps.

use crate::arithmetic::short::leading_zeros;

/// Cells of a mantissa below 1; those below 1/4 are 0's alone.
const CELL_COUNT: usize = 128;
const FIRST: usize = CELL_COUNT / 4;
/// Bits of the position within a cell that are used, of 25.
const POSITION_BITS: u32 = 12;

/// Root at the left end of a cell with 16 bits, and its rise over the cell in
/// the lower half.
static CELLS: [u32; CELL_COUNT] = cells();

const fn cells() -> [u32; CELL_COUNT] {
    let mut table = [0; CELL_COUNT];
    let mut cell = FIRST;
    while cell < CELL_COUNT {
        let left = root_of(cell);
        table[cell] = (left << 16) | (root_of(cell + 1) - left);
        cell += 1;
    }
    table
}

/// √(knot/128) with 16 fraction bits, at most 2¹⁶ − 1.
const fn root_of(knot: usize) -> u32 {
    // 2 · √ in one more bit, rounded.
    let root = (((knot as u64) << 27).isqrt() as u32).div_ceil(2);
    if root < 0xFFFF { root } else { 0xFFFF }
}

/// √q with 15 fraction bits for an integer `q` below 2³¹; within 4e-5 of its
/// value and a step, `table::root::tests`.
///
/// 512 bytes of table.
#[inline]
pub(crate) fn root(q: u32) -> u32 {
    // An even shift, so that half of it is the root's.
    let half = leading_zeros(q) / 2 % 16;
    let mantissa = q << (2 * half);
    let cell = CELLS[(mantissa >> 25) as usize];
    let within = (mantissa >> (25 - POSITION_BITS)) % (1 << POSITION_BITS);
    let root = ((cell >> 16) << POSITION_BITS) + (cell & 0xFFFF) * within;
    // 28 bits, scaled to 31, then back.
    (root << 3) >> half
}

#[cfg(test)]
mod tests {
    use super::root;

    /// Every mantissa in its 17 upper bits, in every octave.
    #[test]
    fn within_its_bound() {
        assert_eq!(root(0), 0);
        let mut worst = 0.0f64;
        let mut check = |q: u32| {
            let exact = f64::from(q).sqrt() * 32_768.0;
            worst = worst.max(((f64::from(root(q)) - exact).abs() - 1.0) / exact);
        };
        for mantissa in 1 << 16..1u32 << 17 {
            for shift in 0..15 {
                check(mantissa << shift >> 1);
            }
        }
        for q in 1..1u32 << 16 {
            check(q);
        }
        assert!((3e-5..=4e-5).contains(&worst), "{worst:e}");
    }
}
