//! Light of 16 bits to 8-bit sRGB: a shift and a look-up.

use super::srgb::{LINEAR_BITS, code_from};

/// Bits of a cell's number.
const CELL_BITS: u32 = 14;
const SHIFT: u32 = u16::BITS - CELL_BITS;
const CELLS: usize = 1 << CELL_BITS;

/// The code of the middle of each cell.
static CODES: [u8; CELLS] = codes();

const fn codes() -> [u8; CELLS] {
    let mut table = [0; CELLS];
    let mut cell = 0;
    let mut code = 0;
    while cell < CELLS {
        let middle = (2 * cell as u32 + 1) << (LINEAR_BITS - CELL_BITS - 1);
        code = code_from(code, middle);
        table[cell] = code;
        cell += 1;
    }
    table
}

/// The sRGB code (IEC 61966-2-1) of linear light of 16 bits, `light`/2¹⁶ to
/// (`light` + 1)/2¹⁶: within 0.60 LSB of every value that it stands for.
///
/// Tested for every input in `tests/tests/srgb.rs`. 16 KiB of table: where
/// flash is dearer than cycles, [`srgb8_quick`](super::srgb8_quick) takes a
/// third of it.
#[inline]
#[must_use]
pub fn srgb8_direct(light: u16) -> u8 {
    CODES[usize::from(light >> SHIFT)]
}
