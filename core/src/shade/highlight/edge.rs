//! Pixels where N·V is small: no step of z² is small enough for its root.

use super::lit_sphere::COEFFICIENT_BITS;
use super::lobe_colours::{BLACK, LESS_BITS, LobeColours, SUM_BITS, in_ratios};
use super::walk::Offsets;
use super::angle::Angle;
use super::wide::{UNIT, UNIT_BITS, product, quotient};
use super::word::{FAR, WAY_BITS};
use crate::shade::root::Root;

/// Fraction bits of a ratio of the cosines.
const RATIO_BITS: u32 = 31;
const ONE: u64 = 1 << RATIO_BITS;
/// Fraction bits of `slope`.
const SLOPE_BITS: u32 = 29;
/// One that a part of a ratio has: those of the slope's product with 1/z, 29, and d's.
const PART_BITS: u32 = SLOPE_BITS - 1 + COEFFICIENT_BITS;

/// What such pixels take from the light, for a root by Newton's iteration where others
/// look up a step: z, d and the ratio of the cosines keep their digits at any z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edge {
    /// Whether the lobe reaches such pixels.
    lit: bool,
    /// sinθ over the cutoff's mantissa, 28 fraction bits.
    tilt: u32,
    /// The product of both, doubled, 29 fraction bits.
    slope: u32,
    narrowness: u32,
    /// What has been taken from d, in its unit.
    height: i64,
}

impl Edge {
    /// For sinθ and the cutoff with 30 and 32 fraction bits, of which `tilt` is the
    /// quotient less `narrowness` halvings.
    pub(super) const fn new(
        lit: bool,
        sine: i64,
        radius: u32,
        tilt: i64,
        middle: i64,
    ) -> Self {
        let narrowness = radius.leading_zeros();
        Self {
            lit,
            tilt: tilt as u32,
            slope: ((sine * ((radius as i64) << narrowness)) >> (UNIT_BITS + 32 - SLOPE_BITS - 1))
                as u32,
            narrowness,
            height: product(tilt, middle) << narrowness,
        }
    }

    /// The code at offsets d and b, of which d lacks z's part, for z² with 30 fraction bits.
    #[inline(never)]
    pub(super) fn pixel<const COLOURS: usize>(
        &self,
        colours: &LobeColours<COLOURS>,
        at: Offsets,
        square: i64,
    ) -> u16 {
        if !self.lit || square <= 0 {
            return BLACK;
        }
        let square = square.min(UNIT - 1) as u64;
        let (root, inverse, halvings) = Root::of(square << (64 - UNIT_BITS)).parts();
        let product = u64::from(self.tilt) * u64::from(root);
        let lowered = product >> (32 + halvings).saturating_sub(self.narrowness);
        let height = self.height - lowered as i64;
        if height.unsigned_abs() > FAR as u64 {
            return BLACK;
        }
        let d = at.d.wrapping_add(height as i32);

        let rounded = |offset: i32| offset.wrapping_add(1 << (WAY_BITS - 1)) >> WAY_BITS;
        let [down, aside] = [rounded(d), rounded(at.b)];
        let mut x = (down.wrapping_mul(down)).wrapping_add(aside.wrapping_mul(aside));
        if d >= 0 {
            return colours.at(x);
        }
        // What the ratio is less than 1.
        let steep = (u64::from(self.slope) * u64::from(inverse)) >> 32;
        let less = steep.wrapping_mul(u64::from(d.unsigned_abs()))
            >> (PART_BITS - RATIO_BITS + self.narrowness).saturating_sub(halvings);
        let Some(ratio @ 1..) = ONE.checked_sub(less) else {
            return BLACK;
        };
        let mut ratio = ratio as u32;
        // Steps of a ratio are as fine as it is small.
        while ratio < (ONE / 2) as u32 {
            if x >> SUM_BITS != 0 {
                return BLACK;
            }
            x = colours.halved(x);
            ratio <<= 1;
        }
        let less = in_ratios((ONE as i64 - i64::from(ratio)) >> (RATIO_BITS - LESS_BITS));
        colours.at(colours.dimmed(|| x, less as i32))
    }
}

/// z² up to which pixels are the edge's, if steps of z² are as wide as `1 << step_bits`,
/// 30 fraction bits: beyond, half a step is a part of a level at most.
pub(super) const fn end<const COLOURS: usize>(
    colours: &LobeColours<COLOURS>,
    angle: &Angle,
    step_bits: u32,
) -> i64 {
    /// Steps, whatever is seen there.
    const LEAST: i64 = 16;
    let (sine, cosine) = (angle.sine, angle.cosine);
    let radius = (colours.radius as i64) >> 2;

    // Of d half a step is sinθ · step/4z. Light that is white well beyond the middle
    // shows more of it where it no longer is.
    let shift = quotient(sine << step_bits, product(cosine, radius) << 2);
    let white = colours.level_at(1, 4) == 63;
    if shift > (if white { 3 } else { 8 }) * (UNIT >> 11) {
        return UNIT;
    }
    // At the lobe's end x is 2d times as wrong.
    let z = quotient((2 * sine) * colours.steepness as i64, 3 * radius) << step_bits;
    let z = if z < UNIT { z } else { UNIT };
    let mut end = product(z, z);
    if end < LEAST << step_bits {
        end = LEAST << step_bits;
    }
    // Where the ratio of the cosines goes to 0 it is −L·V · step/4z² wrong, and 1 − R·V
    // is 2cos²θ: if light is seen there, the source is behind.
    let behind = UNIT - 2 * product(cosine, cosine);
    let level = colours.level_at(cosine, radius);
    if level > BRIGHT {
        return UNIT;
    }
    let ratio = quotient(product(DARKEST * level * level, behind), 63 * 63) << step_bits;
    if ratio > end { ratio } else { end }
}

/// Half of the levels of green that the whole of light would be at the slope of its
/// least.
const DARKEST: i64 = 407;
/// A level for which a step of a ratio is some levels where it goes to 0.
const BRIGHT: i64 = 34;
