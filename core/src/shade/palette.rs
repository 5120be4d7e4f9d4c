//! A light's whole range in a display's codes, tabulated: for a material and
//! a light without colours of their own that vary, one look-up a pixel.

use super::linear::{LINEAR_ONE, Linear};

/// Cells below 1/16, each 2⁻¹¹ wide; above it 2⁻⁸.
const DARK_CELLS: u32 = 1 << 7;
const DARK_SHIFT: u32 = 24 - 11;
const LIGHT_SHIFT: u32 = 24 - 8;
/// Cells that a light one's index passes over.
const SKIPPED: u32 = DARK_CELLS - (1 << 4);
/// Number of entries; the last holds 1.0.
const CELLS: usize = (SKIPPED + (1 << 8)) as usize + 1;

/// RGB565 codes of one tint from black to full, 738 bytes.
///
/// The entry of a cell is the code of its middle, so that each channel is at
/// most one of its 32 or 64 levels off; tested for every input in
/// `tests/tests/srgb.rs`. It is built by integers: the same on every host and
/// device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette565 {
    codes: [u16; CELLS],
}

impl Palette565 {
    /// The palette of a `tint`: red, green and blue at full light, linear with
    /// 24 fraction bits; above 1.0 they are clamped.
    #[must_use]
    pub const fn new(tint: [u32; 3]) -> Self {
        let [r, g, b] = Linear::from_raw(tint[0], tint[1], tint[2]).to_raw();
        let mut codes = [0; CELLS];
        let mut cell = 0;
        while cell < CELLS {
            let middle = middle(cell as u32);
            let light = if middle < LINEAR_ONE {
                middle
            } else {
                LINEAR_ONE
            };
            codes[cell] = Linear::from_raw(part(r, light), part(g, light), part(b, light)).rgb565();
            cell += 1;
        }
        Self { codes }
    }

    /// The code at `light`, linear with 24 fraction bits; above 1.0 it is the
    /// tint's own.
    #[inline]
    #[must_use]
    pub fn at(&self, light: u32) -> u16 {
        let light = if light < LINEAR_ONE {
            light
        } else {
            LINEAR_ONE
        };
        let cell = if light < DARK_CELLS << DARK_SHIFT {
            light >> DARK_SHIFT
        } else {
            (light >> LIGHT_SHIFT) + SKIPPED
        };
        *self
            .codes
            .get(cell as usize)
            .unwrap_or(&self.codes[CELLS - 1])
    }

    /// The code at light of 16 bits, as [`ExposedCurve`] gives it: cells are no
    /// finer than its steps.
    ///
    /// [`ExposedCurve`]: crate::table::ExposedCurve
    #[inline]
    #[must_use]
    pub fn at_short(&self, light: u16) -> u16 {
        self.codes[cell(u32::from(light))]
    }
}

/// The middle of a cell, 24 fraction bits.
const fn middle(cell: u32) -> u32 {
    if cell < DARK_CELLS {
        (2 * cell + 1) << (DARK_SHIFT - 1)
    } else {
        (2 * (cell - SKIPPED) + 1) << (LIGHT_SHIFT - 1)
    }
}

/// The cell of a number from 0 to 1 with 16 fraction bits.
#[inline(always)]
fn cell(number: u32) -> usize {
    let cell = if number < DARK_CELLS << (DARK_SHIFT - 8) {
        number >> (DARK_SHIFT - 8)
    } else {
        (number >> (LIGHT_SHIFT - 8)) + SKIPPED
    };
    cell as usize
}

/// `channel` · `light`.
const fn part(channel: u32, light: u32) -> u32 {
    ((channel as u64 * light as u64) >> 24) as u32
}
