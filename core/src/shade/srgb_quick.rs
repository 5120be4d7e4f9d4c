//! Linear light to 8-bit sRGB in one look-up: a tenth of a code less exact
//! than [`srgb8`](super::srgb8), and quicker.

use super::srgb::{LINEAR_BITS, code_from};

/// Cells below 1/16, each 2⁻¹⁴ wide; above it 2⁻¹².
const DARK_CELLS: u32 = 1 << 10;
const DARK_SHIFT: u32 = LINEAR_BITS - 14;
const LIGHT_SHIFT: u32 = LINEAR_BITS - 12;
/// Cells that a light one's index passes over.
const SKIPPED: u32 = DARK_CELLS - (1 << 8);
/// The last cell holds 1.0.
const CELLS: usize = (SKIPPED + (1 << 12)) as usize + 1;

/// The code of the middle of each cell.
static CODES: [u8; CELLS] = codes();

const fn codes() -> [u8; CELLS] {
    let mut table = [0; CELLS];
    let mut cell = 0;
    let mut code = 0;
    while cell < CELLS {
        let index = cell as u32;
        let middle = if index < DARK_CELLS {
            (2 * index + 1) << (DARK_SHIFT - 1)
        } else {
            (2 * (index - SKIPPED) + 1) << (LIGHT_SHIFT - 1)
        };
        code = code_from(code, middle);
        table[cell] = code;
        cell += 1;
    }
    table
}

/// The sRGB code (IEC 61966-2-1) of linear light with 24 fraction bits, within
/// 0.60 LSB; values above 1.0 get 255.
///
/// Tested for every input in `tests/tests/srgb.rs`. 4865 bytes of table.
#[inline]
#[must_use]
pub fn srgb8_quick(linear: u32) -> u8 {
    let cell = if linear < DARK_CELLS << DARK_SHIFT {
        linear >> DARK_SHIFT
    } else {
        (linear >> LIGHT_SHIFT) + SKIPPED
    };
    *CODES.get(cell as usize).unwrap_or(&255)
}
