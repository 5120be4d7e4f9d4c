//! Displays of sixteen greys.

use super::dither::threshold;
use super::srgb::srgb8;

/// The level 0 … 15 of a panel pixel at (`x`, `y`) for a luminance with 24
/// fraction bits.
///
/// The panel's levels are taken as evenly spaced in sRGB code (a gamma of
/// about 2.2), 17 codes apart. Between two levels a dither fixed to the
/// screen decides; `docs/dither.md` compares it with [`grey16_nearest`].
#[must_use]
#[inline]
pub fn grey16(luminance: u32, x: usize, y: usize) -> u8 {
    let code = u32::from(srgb8(luminance));
    // floor(code/17 + threshold/32), as integers.
    ((code * 32 + 17 * threshold(x, y)) / (17 * 32)).min(15) as u8
}

/// The level nearest to the luminance's sRGB code: without a dither.
#[must_use]
#[inline]
pub fn grey16_nearest(luminance: u32) -> u8 {
    // round(code/17) by a multiply and a shift; the last level ends at 255.
    (((u32::from(srgb8(luminance)) + 8) * 241) >> 12) as u8
}

#[cfg(test)]
mod tests {
    use super::grey16_nearest;
    use crate::shade::srgb8;

    #[test]
    fn the_nearest_level_is_the_nearest() {
        for luminance in (0..=1 << 24).step_by(97) {
            let code = u32::from(srgb8(luminance));
            let nearest = (2 * code + 17) / 34;
            assert_eq!(u32::from(grey16_nearest(luminance)), nearest, "code {code}");
        }
    }
}
