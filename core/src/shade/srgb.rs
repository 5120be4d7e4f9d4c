//! Linear light to 8-bit sRGB, exactly rounded.
//!
//! The linear value chooses a cell that holds at most one of the 255
//! thresholds between codes; one comparison settles the code. The result is
//! the correctly rounded encoding of the 24-bit value: 0.50 LSB.

use crate::table::integer::{ONE, exp_neg, neg_ln_one_minus, round_to, times};

/// Fraction bits of linear light.
pub(super) const LINEAR_BITS: u32 = 24;
/// Cells below 1/16, each 2⁻¹² wide; then 2⁻¹⁰ below 1/4; then 2⁻⁸.
const DARK_CELLS: usize = 256;
const MIDDLE_CELLS: usize = 192;
const LIGHT_CELLS: usize = 192;
const CELLS: usize = DARK_CELLS + MIDDLE_CELLS + LIGHT_CELLS;

/// `THRESHOLDS[c]` is the least linear value whose code is above `c`; no
/// value passes the last.
static THRESHOLDS: [u32; 256] = thresholds();
/// Code at the left end of each cell.
static STARTS: [u8; CELLS] = starts();

/// The code of a linear value for tables that are built upwards: `code` is
/// that of a lower one.
pub(super) const fn code_from(mut code: u8, linear: u32) -> u8 {
    while code < 255 && linear >= THRESHOLDS[code as usize] {
        code += 1;
    }
    code
}

/// The sRGB code (IEC 61966-2-1) of linear light with 24 fraction bits.
///
/// Exactly rounded for every input, tested exhaustively in
/// `tests/tests/srgb.rs`; values above 1.0 get 255. 1664 bytes of tables; with
/// the feature `small` it is [`srgb8_bisected`].
#[inline]
#[must_use]
pub const fn srgb8(linear: u32) -> u8 {
    if cfg!(feature = "small") {
        return srgb8_bisected(linear);
    }
    let cell = if linear < 1 << (LINEAR_BITS - 4) {
        linear >> (LINEAR_BITS - 12)
    } else if linear < 1 << (LINEAR_BITS - 2) {
        (linear >> (LINEAR_BITS - 10)) + (DARK_CELLS - 64) as u32
    } else {
        (linear >> (LINEAR_BITS - 8)) + (DARK_CELLS + MIDDLE_CELLS - 64) as u32
    };
    if cell as usize >= CELLS {
        return 255;
    }
    let start = STARTS[cell as usize];
    // A threshold at the left end is already counted in `start`, so `start`
    // is 255 only where no threshold follows.
    start + (linear >= THRESHOLDS[start as usize]) as u8
}

/// As [`srgb8`], with eight comparisons in place of two: 1024 bytes of tables.
/// Every input is tested in `tests/tests/srgb.rs`.
#[inline]
#[must_use]
pub const fn srgb8_bisected(linear: u32) -> u8 {
    let mut code: u8 = 0;
    let mut step = 128;
    while step > 0 {
        let middle = code | step;
        if linear >= THRESHOLDS[(middle - 1) as usize] {
            code = middle;
        }
        step /= 2;
    }
    code
}

/// ((v + 0.055)/1.055)^2.4 or v/12.92 for v = (2 code + 1)/510, rounded up to
/// 24 bits: the linear value at which the code changes.
const fn thresholds() -> [u32; 256] {
    let mut table = [u32::MAX; 256];
    let mut code = 0;
    while code < 255 {
        let encoded = 2 * code as u128 + 1;
        // v ≤ 0.04045 means encoded ≤ 20.6.
        let linear = if encoded <= 20 {
            (encoded << 64) * 100 / (510 * 1292)
        } else {
            // (encoded/510 + 0.055)/1.055 as a fraction of 64 bits.
            let base = ((encoded * 1000 + 28_050) << 64) / (510 * 1055);
            // 2.4 with 32 fraction bits.
            exp_neg(times(10_307_921_510, neg_ln_one_minus((ONE - base) as u64)))
        };
        let step = 1 << (64 - LINEAR_BITS);
        table[code] = round_to(linear + step / 2 - 1, LINEAR_BITS);
        code += 1;
    }
    table
}

const fn starts() -> [u8; CELLS] {
    let thresholds = thresholds();
    let mut table = [0; CELLS];
    let mut cell = 0;
    let mut code: u8 = 0;
    while cell < CELLS {
        let left = if cell < DARK_CELLS {
            cell << (LINEAR_BITS - 12)
        } else if cell < DARK_CELLS + MIDDLE_CELLS {
            (cell - (DARK_CELLS - 64)) << (LINEAR_BITS - 10)
        } else {
            (cell - (DARK_CELLS + MIDDLE_CELLS - 64)) << (LINEAR_BITS - 8)
        };
        while code < 255 && left as u32 >= thresholds[code as usize] {
            code += 1;
        }
        table[cell] = code;
        cell += 1;
    }
    table
}
