//! A patch with a light's gain in it.

use fixed::types::U32F32;

use super::patch::Patch;
use crate::arithmetic::{Arithmetic, Q15};
use crate::colour::{Rgb, greatest};
use crate::error::ParameterError;
use crate::geometry::Geometry;

/// Fraction bits of N·L here, and of a cosine elsewhere.
const SHORT_BITS: u32 = 18;
const COSINE_BITS: u32 = 30;
/// Bits of a factor: with a cosine below 2 the product is positive.
const FACTOR_BITS: u32 = 12;
/// Binary logarithm of the greatest gain: there the product is light.
const GAIN_BITS: u32 = SHORT_BITS + FACTOR_BITS - u16::BITS;

/// K · cosΘL where m ≤ R, else 0 (4.2), as linear light of 16 bits: a [`Patch`]
/// under one light, its gain K folded in.
///
/// Factors have 12 bits of the greatest, and N·L 18 fraction bits. What comes
/// out is as [`ExposedCurve`](crate::table::ExposedCurve) says; its sRGB code is
/// within 0.56 LSB, tested in `tests/tests/exposed.rs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExposedPatch<const KNOTS: usize = 129> {
    patch: Patch<Q15<KNOTS>>,
    factors: [i32; 3],
    /// From the product to light.
    down: u32,
}

const GAIN_RANGE: ParameterError = ParameterError::new("gain", "at most 16384");

impl<const KNOTS: usize> ExposedPatch<KNOTS> {
    /// The disc of `patch` with the `gain` K of each channel.
    ///
    /// # Errors
    /// A gain above 16384, which R = 4.5e-3 has at K = 1/(πR²).
    pub const fn new(patch: Patch<Q15<KNOTS>>, gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        let gain = [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()];
        let greatest = greatest(gain);
        if greatest > 1 << (32 + GAIN_BITS) {
            return Err(GAIN_RANGE);
        }
        // The greatest is below 2^exponent and at least half of it: a power of
        // two is a shift.
        let bits = 64 - greatest.leading_zeros();
        let exponent = bits as i32 - 32;
        let mut factors = [0; 3];
        let mut channel = 0;
        while channel < 3 {
            // One bit more, to round it.
            let doubled = ((gain[channel] as u128) << (FACTOR_BITS + 1)) >> bits;
            let factor = doubled.div_ceil(2) as i32;
            factors[channel] = if factor < 1 << FACTOR_BITS {
                factor
            } else {
                (1 << FACTOR_BITS) - 1
            };
            channel += 1;
        }
        let down = GAIN_BITS as i32 - exponent;
        Ok(Self {
            patch,
            factors,
            // Beyond that everything is less than a step.
            down: if down < 32 { down as u32 } else { 31 },
        })
    }

    /// Exposed light, 16 bits a channel; below the horizon and beyond the disc
    /// it is 0.
    // A shading loop calls it once for a material: let the loop hold it.
    #[inline(always)]
    pub fn shade(&self, geometry: &impl Geometry<Q15<KNOTS>>) -> Rgb<u16> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        if !Q15::<KNOTS>::lit(n_dot_l, n_dot_v) {
            return Rgb::grey(0);
        }
        let covers = self.patch.covers(geometry);
        let n_dot_l = n_dot_l >> (COSINE_BITS - SHORT_BITS);
        Rgb::from_array(self.factors.map(|factor| {
            let light = factor.wrapping_mul(n_dot_l) >> (self.down % 32);
            // A choice, not a branch: discs are broad.
            if covers {
                light.clamp(0, 0xFFFF) as u16
            } else {
                0
            }
        }))
    }
}
