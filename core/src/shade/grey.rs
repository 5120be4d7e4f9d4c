//! Displays of sixteen greys.

use super::srgb::srgb8;

/// Thresholds of a 4 x 4 ordered dither (Bayer), in sixteenths of a step.
const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The level 0 … 15 of a panel pixel at (`x`, `y`) for a luminance with 24
/// fraction bits.
///
/// The panel's levels are taken as evenly spaced in sRGB code (a gamma of
/// about 2.2), 17 codes apart. Between two levels a dither fixed to the
/// screen decides, so that a smooth ramp has no flat run longer than a cell.
#[must_use]
#[inline]
pub fn grey16(luminance: u32, x: usize, y: usize) -> u8 {
    let code = u32::from(srgb8(luminance));
    let threshold = u32::from(BAYER[y % 4][x % 4]);
    // floor(code/17 + (threshold + 1/2)/16), as integers.
    ((code * 32 + 17 * (2 * threshold + 1)) / (17 * 32)).min(15) as u8
}
