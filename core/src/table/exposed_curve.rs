//! A metal's colour over the cosine with a light's gain in it.

use fixed::types::U32F32;

use super::cosine_curve::CosineCurve;
use super::exposure::{Exposure, factor};
use crate::colour::Rgb;
use crate::error::ParameterError;

/// Fraction bits of a cosine.
const COSINE_BITS: u32 = 30;
/// Bits of the position within a cell.
const POSITION_BITS: u32 = 15;

/// K·F(cosΘ) for a gain K of each channel, at `KNOTS` knots of equal distance:
/// 65, 129 or 257, twelve bytes each.
///
/// A word holds where a cell's line meets cosine 0 in its upper half and twice
/// the rise over the cell in its lower one: one load and one product
/// interpolate. The factor is taken to 12 bits of its greatest value and the
/// share to 19. A share with which every channel is beyond 1.0 already is
/// limited before the product: nothing wraps.
///
/// What comes out is linear light of 16 bits, rounded down: k stands for
/// k/2¹⁶ to (k + 1)/2¹⁶, 65535 also for 1.0 and above. Encoders take the middle
/// of a step ([`srgb8_direct`](crate::shade::srgb8_direct)), which is within
/// 0.03 LSB of the sRGB code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExposedCurve<const KNOTS: usize> {
    /// A cell from each knot on; the last, at cosine 1, is level.
    cells: [[i32; 3]; KNOTS],
    exposure: Exposure,
}

const CELLS_RANGE: ParameterError = ParameterError::new(
    "fresnel",
    "a curve that rises or falls by less than 1/2 of its greatest value in a cell",
);

impl<const KNOTS: usize> ExposedCurve<KNOTS> {
    const CELLS: usize = {
        assert!(
            KNOTS == 65 || KNOTS == 129 || KNOTS == 257,
            "the number of knots must be 65, 129 or 257"
        );
        KNOTS - 1
    };
    const CELL_BITS: u32 = Self::CELLS.ilog2();

    /// The curve `fresnel` times a `gain` for each channel.
    ///
    /// # Errors
    /// A curve that is too steep for so few cells; a gain above 256 with a
    /// channel, not 0, that is somewhere 128 times less than another.
    pub const fn new(fresnel: &CosineCurve, gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        let gain = [
            gain.r.to_bits() as u128,
            gain.g.to_bits() as u128,
            gain.b.to_bits() as u128,
        ];
        let (least, greatest) = Self::ends(fresnel, gain);
        let exposure = match Exposure::new(least, greatest) {
            Ok(exposure) => exposure,
            Err(error) => return Err(error),
        };
        let mut curve = Self {
            cells: [[0; 3]; KNOTS],
            exposure,
        };
        let mut channel = 0;
        while channel < 3 {
            let gain = gain[channel];
            let mut from = exposure.word(Self::knot(fresnel, channel, 0) * gain);
            let mut cell = 0;
            while cell < Self::CELLS {
                let to = exposure.word(Self::knot(fresnel, channel, cell + 1) * gain);
                let rise = (to >> 16) - (from >> 16);
                if rise < -(1 << 14) || rise >= 1 << 14 {
                    return Err(CELLS_RANGE);
                }
                // Where the cell's line meets cosine 0; words wrap, and so does
                // what is read. The product is a multiple of 2¹⁶.
                let slope = 2 * rise;
                let start = slope.wrapping_mul((cell as i32) << POSITION_BITS);
                let left = ((from as u32) & 0xFFFF_0000) as i32;
                curve.cells[cell][channel] = left.wrapping_sub(start) | slope as u16 as i32;
                from = to;
                cell += 1;
            }
            curve.cells[Self::CELLS][channel] = ((from as u32) & 0xFFFF_0000) as i32;
            channel += 1;
        }
        Ok(curve)
    }

    /// What a channel's knot holds, 15 fraction bits: half of the chords' error
    /// below the curve, so that it is centred on 0.
    const fn knot(fresnel: &CosineCurve, channel: usize, knot: usize) -> u128 {
        let after = if knot < Self::CELLS {
            knot
        } else {
            Self::CELLS - 1
        };
        let before = knot.saturating_sub(1);
        let sags = Self::sag(fresnel, channel, before) + Self::sag(fresnel, channel, after);
        let lowered = fresnel.at_knot(knot, Self::CELLS)[channel] as i32 - sags / 4;
        // No reflectance is negative.
        if lowered > 0 { lowered as u128 } else { 0 }
    }

    /// How far a cell's chord is above the curve in its middle.
    const fn sag(fresnel: &CosineCurve, channel: usize, cell: usize) -> i32 {
        if Self::CELLS == 256 {
            return 0; // the curve has no knots between
        }
        let [left, middle, right] = [2 * cell, 2 * cell + 1, 2 * cell + 2];
        let left = fresnel.at_knot(left, 2 * Self::CELLS)[channel] as i32;
        let middle = fresnel.at_knot(middle, 2 * Self::CELLS)[channel] as i32;
        let right = fresnel.at_knot(right, 2 * Self::CELLS)[channel] as i32;
        (left + right) / 2 - middle
    }

    /// The least product that is not 0, and the greatest.
    const fn ends(fresnel: &CosineCurve, gain: [u128; 3]) -> (u128, u128) {
        let (mut least, mut greatest) = (u128::MAX, 0);
        let mut knot = 0;
        while knot <= Self::CELLS {
            let mut channel = 0;
            while channel < 3 {
                let product = Self::knot(fresnel, channel, knot) * gain[channel];
                if product > greatest {
                    greatest = product;
                }
                if product > 0 && product < least {
                    least = product;
                }
                channel += 1;
            }
            knot += 1;
        }
        (least, greatest)
    }

    /// `share` · K·F at a cosine. The share is at most 1 and has a lobe table's
    /// 25 fraction bits; the cosine, not
    /// negative, has 30 fraction bits, and one of 1 or more gets the curve's
    /// end.
    #[inline(always)]
    pub(crate) fn expose(&self, share: u32, cosine: i32) -> Rgb<u16> {
        let share = self.exposure.share(share);
        let cosine = cosine as u32;
        let cell = (cosine >> (COSINE_BITS - Self::CELL_BITS)) as usize;
        let words = &self.cells[cell.min(Self::CELLS)];
        // From cosine 0, not from the cell's left end: it spares a mask.
        let position = (cosine >> (COSINE_BITS - Self::CELL_BITS - POSITION_BITS)) as i32;
        Rgb::from_array(words.map(|word| {
            let rise = i32::from(word as i16).wrapping_mul(position);
            self.exposure.light(factor(word.wrapping_add(rise)), share)
        }))
    }
}
