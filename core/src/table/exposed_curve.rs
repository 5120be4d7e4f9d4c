//! A metal's colour over the cosine with a light's exposure in it: one word a
//! channel and one product of 32 bits for what comes out.

use fixed::types::{U1F31, U32F32};

use super::cosine_curve::CosineCurve;
use crate::colour::Rgb;
use crate::error::ParameterError;

/// Fraction bits of a cosine.
const COSINE_BITS: u32 = 30;
/// Bits of the position within a cell.
const POSITION_BITS: u32 = 15;
/// Bits of a factor, and of the share that it is multiplied by: a signed word
/// holds the product.
const FACTOR_BITS: u32 = 12;
const SHARE_BITS: u32 = 31 - FACTOR_BITS;
/// Bits of a word that is not negative.
const WORD_BITS: u32 = 31;
/// Half a step of a factor, in the word that holds one at its upper end.
const HALF: u32 = 1 << (WORD_BITS - FACTOR_BITS - 1);
/// Fraction bits of K·F: 32 of the gain, 15 of the curve.
const PRODUCT_BITS: u32 = 32 + 15;
/// Fraction bits of a share and of what comes out.
const UNIT_BITS: u32 = 31;
const LIGHT_BITS: u32 = 16;

/// K·F(cosΘ) for a gain K of each channel, in `CELLS` equal cells: 64, 128 or
/// 256, twelve bytes each.
///
/// A word holds where a cell's line meets cosine 0 in its upper half and twice
/// the rise over the cell in its lower one: one load and one product
/// interpolate.
/// The factor is taken to 12 bits of its greatest value and the share to 19.
/// A share with which every channel is beyond 1.0 already is limited before the
/// product: nothing wraps.
///
/// What comes out is linear light of 16 bits, rounded down: k stands for
/// k/2¹⁶ to (k + 1)/2¹⁶, 65535 also for 1.0 and above. Encoders take the middle
/// of a step ([`srgb8_direct`](crate::shade::srgb8_direct)), which is within
/// 0.03 LSB of the sRGB code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExposedCurve<const CELLS: usize> {
    cells: [[i32; 3]; CELLS],
    /// Factors at cosine 1.
    end: [i32; 3],
    /// The share beyond which every channel is white.
    limit: u32,
    /// From a share's 31 fraction bits to those of the product: one is 0.
    right: u32,
    left: u32,
    /// From the product to linear light.
    down: u32,
}

const CELLS_RANGE: ParameterError =
    ParameterError::new("fresnel", "a curve that rises or falls by less than a half of its greatest value in a cell");
const GAIN_RANGE: ParameterError = ParameterError::new(
    "gain",
    "below 256, or such that no channel is 128 times as bright as another",
);

impl<const CELLS: usize> ExposedCurve<CELLS> {
    const CELL_BITS: u32 = {
        assert!(
            CELLS == 64 || CELLS == 128 || CELLS == 256,
            "the number of cells must be 64, 128 or 256"
        );
        CELLS.ilog2()
    };

    /// The curve `fresnel` times a `gain` for each channel.
    ///
    /// # Errors
    /// A curve that is too steep for so few cells; a gain with which a share
    /// that makes one channel 256 leaves another below 1, although it is lit.
    pub const fn new(fresnel: &CosineCurve, gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        let gain = [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()];
        let (least, greatest) = Self::ends(fresnel, gain);
        // The greatest product is at most 2^exponent and above half of it.
        let exponent =
            (128 - greatest.saturating_sub(1).leading_zeros()) as i32 - PRODUCT_BITS as i32;
        // Where a share is limited the brightest channel has at least half of
        // 2^headroom, and so the darkest at least 1.
        let mut headroom = 1;
        while headroom < 8 && (least << (headroom - 1)) < greatest {
            headroom += 1;
        }
        let up = if exponent > headroom {
            (exponent - headroom) as u32
        } else {
            0
        };
        if exponent > 8 && (least << (headroom - 1)) < greatest {
            return Err(GAIN_RANGE);
        }
        // A share has this many bits more than the product takes.
        let excess = UNIT_BITS - SHARE_BITS;
        let down = (31 - LIGHT_BITS) as i32 - exponent + up as i32;
        let mut curve = Self {
            cells: [[0; 3]; CELLS],
            end: [0; 3],
            limit: if up == 0 {
                u32::MAX
            } else if up < UNIT_BITS {
                1 << (UNIT_BITS - up)
            } else {
                1
            },
            right: excess.saturating_sub(up),
            left: if up > UNIT_BITS { UNIT_BITS - excess } else { up.saturating_sub(excess) },
            down: if down < 32 { down as u32 } else { 31 },
        };
        // What is less than a step of light at its brightest is black.
        if down >= 32 {
            return Ok(curve);
        }
        let mut channel = 0;
        while channel < 3 {
            let gain = gain[channel];
            let mut from = word(Self::knot(fresnel, channel, 0), gain, exponent);
            let mut cell = 0;
            while cell < CELLS {
                let to = word(Self::knot(fresnel, channel, cell + 1), gain, exponent);
                let rise = (to >> 16) - (from >> 16);
                if rise < -(1 << 14) || rise >= 1 << 14 {
                    return Err(CELLS_RANGE);
                }
                // Where the cell's line meets cosine 0; words wrap, and so does
                // what is read. The product is a multiple of 2¹⁶.
                let slope = 2 * rise;
                let start = slope.wrapping_mul((cell as i32) << POSITION_BITS);
                curve.cells[cell][channel] = from.wrapping_sub(start) | slope as u16 as i32;
                from = to;
                cell += 1;
            }
            curve.end[channel] = from >> (WORD_BITS - FACTOR_BITS);
            channel += 1;
        }
        Ok(curve)
    }

    /// What a channel's knot holds: half of the chords' error below the curve,
    /// so that it is centred on 0.
    const fn knot(fresnel: &CosineCurve, channel: usize, knot: usize) -> u32 {
        let after = if knot < CELLS { knot } else { CELLS - 1 };
        let before = knot.saturating_sub(1);
        let sags = Self::sag(fresnel, channel, before) + Self::sag(fresnel, channel, after);
        (fresnel.at_knot(knot, CELLS)[channel] as i32 - sags / 4) as u32
    }

    /// How far a cell's chord is above the curve in its middle.
    const fn sag(fresnel: &CosineCurve, channel: usize, cell: usize) -> i32 {
        if CELLS == 256 {
            return 0; // the curve has no knots between
        }
        let [left, middle, right] = [2 * cell, 2 * cell + 1, 2 * cell + 2];
        let left = fresnel.at_knot(left, 2 * CELLS)[channel] as i32;
        let middle = fresnel.at_knot(middle, 2 * CELLS)[channel] as i32;
        let right = fresnel.at_knot(right, 2 * CELLS)[channel] as i32;
        (left + right) / 2 - middle
    }

    /// The least product of a channel that has a gain, and the greatest.
    const fn ends(fresnel: &CosineCurve, gain: [u64; 3]) -> (u128, u128) {
        let (mut least, mut greatest) = (u128::MAX, 0);
        let mut knot = 0;
        while knot <= CELLS {
            let values = fresnel.at_knot(knot, CELLS);
            let mut channel = 0;
            while channel < 3 {
                let product = values[channel] as u128 * gain[channel] as u128;
                if product > greatest {
                    greatest = product;
                }
                if product < least && gain[channel] > 0 {
                    least = product;
                }
                channel += 1;
            }
            knot += 1;
        }
        // No more than a word apart: the search for the headroom is short.
        let floor = greatest >> 32;
        (if least < floor { floor } else { least }, greatest)
    }

    /// `share` · K·F at a cosine. The share is at most 1; the cosine, not
    /// negative, has 30 fraction bits, and one of 1 or more gets the curve's
    /// end.
    #[inline(always)]
    pub(crate) fn expose(&self, share: U1F31, cosine: i32) -> Rgb<u16> {
        let share = share.to_bits().min(self.limit);
        let share = (share >> (self.right % 32)) << (self.left % 32);
        let light = |factor: i32| saturated(factor.wrapping_mul(share as i32), self.down);
        let cosine = cosine as u32;
        let cell = (cosine >> (COSINE_BITS - Self::CELL_BITS)) as usize;
        let Some(words) = self.cells.get(cell) else {
            return Rgb::from_array(self.end.map(light));
        };
        // From cosine 0, not from the cell's left end: it spares a mask.
        let position = (cosine >> (COSINE_BITS - Self::CELL_BITS - POSITION_BITS)) as i32;
        Rgb::from_array(words.map(|word| {
            let rise = i32::from(word as i16).wrapping_mul(position);
            light(word.wrapping_add(rise) >> (WORD_BITS - FACTOR_BITS))
        }))
    }
}

/// A product of share and factor, 16 fraction bits, not beyond them.
#[inline(always)]
fn saturated(product: i32, down: u32) -> u16 {
    let light = product >> (down % 32);
    if cfg!(saturates) {
        light.clamp(0, 0xFFFF) as u16
    } else {
        // It is not negative, which only the table's builder knows.
        (light as u32).min(0xFFFF) as u16
    }
}

/// A product of curve and gain over 2^`exponent` in the upper half of a word,
/// and half a step of a factor.
const fn word(value: u32, gain: u64, exponent: i32) -> i32 {
    let product = value as u128 * gain as u128;
    let places = PRODUCT_BITS as i32 + exponent - WORD_BITS as i32;
    let word = if places >= 0 {
        product >> places
    } else {
        product << -places
    };
    // The greatest is at most 2³¹; below it by two steps rounding can't wrap.
    let greatest = (i32::MAX - 2 * HALF as i32) as u128;
    let word = if word < greatest { word } else { greatest };
    ((word as u32 + HALF) & 0xFFFF_0000) as i32
}
