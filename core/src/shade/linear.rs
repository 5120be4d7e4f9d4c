//! What a pixel holds before it is encoded.

use super::dither::{level, threshold};
use super::srgb::srgb8;

/// 1.0 in the components of [`Linear`].
pub const LINEAR_ONE: u32 = 1 << 24;

/// Linear-light RGB of a pixel: exposure applied, 24 fraction bits, clamped
/// to [0, 1]. Primaries and white are sRGB's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Linear {
    r: u32,
    g: u32,
    b: u32,
}

impl Linear {
    /// A pixel from components with 24 fraction bits; above 1.0 they are
    /// clamped.
    #[must_use]
    #[inline]
    pub const fn from_raw(r: u32, g: u32, b: u32) -> Self {
        Self {
            r: clamp(r),
            g: clamp(g),
            b: clamp(b),
        }
    }

    /// Red, green and blue, 24 fraction bits, each at most [`LINEAR_ONE`].
    #[must_use]
    #[inline]
    pub const fn to_raw(self) -> [u32; 3] {
        [self.r, self.g, self.b]
    }

    /// 8-bit sRGB, exactly rounded ([`srgb8`]).
    #[must_use]
    #[inline]
    pub const fn srgb8(self) -> [u8; 3] {
        [srgb8(self.r), srgb8(self.g), srgb8(self.b)]
    }

    /// RGB565, each channel the nearest of its 32 or 64 sRGB levels to the
    /// 8-bit code: at most half a level from it.
    #[must_use]
    #[inline]
    pub const fn rgb565(self) -> u16 {
        let [r, g, b] = self.srgb8();
        five_bits(r) << 11 | six_bits(g) << 5 | five_bits(b)
    }

    /// RGB565 of the pixel at (`x`, `y`), each channel the level below or above
    /// its 8-bit sRGB code, by a 4 x 4 ordered dither that is fixed to the
    /// screen and the same for all channels: over a cell, levels average to
    /// the code within a thirty-second of their distance.
    #[must_use]
    #[inline]
    pub fn rgb565_dithered(self, x: usize, y: usize) -> u16 {
        let [r, g, b] = self.srgb8();
        let threshold = threshold(x, y);
        (level(r, 31, threshold) << 11 | level(g, 63, threshold) << 5 | level(b, 31, threshold))
            as u16
    }

    /// Relative luminance with 24 fraction bits: 0.2126 R + 0.7152 G +
    /// 0.0722 B (Rec. 709), rounded down; weights to 2⁻¹⁶.
    #[must_use]
    #[inline]
    pub const fn luminance(self) -> u32 {
        weigh(self.r, 13_933) + weigh(self.g, 46_871) + weigh(self.b, 4_732)
    }
}

/// round(code · 31/255), by a multiply and a shift.
#[inline]
const fn five_bits(code: u8) -> u16 {
    (code as u16 * 249 + 1014) >> 11
}

/// round(code · 63/255).
#[inline]
const fn six_bits(code: u8) -> u16 {
    ((code as u32 * 253 + 505) >> 10) as u16
}

#[inline]
const fn clamp(component: u32) -> u32 {
    if component < LINEAR_ONE {
        component
    } else {
        LINEAR_ONE
    }
}

/// `value · weight / 2¹⁶` for a value of at most 25 bits, without a 64-bit
/// product.
#[inline]
const fn weigh(value: u32, weight: u32) -> u32 {
    (value >> 12) * weight / 16 + (((value & 0xFFF) * weight) >> 16)
}
