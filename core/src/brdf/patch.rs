//! The basic patch BRDF (4.2).

use fixed::types::{U2F30, U32F32};

use super::Shape;
use super::foreshortening::Flat;
use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31};
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::integer::{INVERSE_PI, divide};

/// f = 1/(π·min(1, R²)) where m ≤ R, else 0 (4.2, 4.7): constant inside a
/// disc of radius R about the mirrored light direction, both projected onto
/// the base plane.
///
/// R = 2 covers every direction: it is Lambert's law. The jump at m = R is
/// decided exactly in `q31` for the directions given; in `f32` to 1e-7 of m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch<A: Arithmetic> {
    radius_squared: A::Separation,
    peak: A::Scale,
}

const RADIUS_RANGE: ParameterError = ParameterError::new("radius", "a number from 1e-4 to 2");

impl<M: Math> Patch<Float<M>> {
    /// The disc of radius `radius`, from 1e-4 to 2.
    ///
    /// # Errors
    /// `radius` outside its range or not a number.
    pub const fn new(radius: f32) -> Result<Self, ParameterError> {
        if !(radius >= 1e-4 && radius <= 2.0) {
            return Err(RADIUS_RANGE);
        }
        let square = radius * radius;
        let peak = core::f32::consts::FRAC_1_PI / square.min(1.0);
        let radius_squared = if radius == 2.0 { f32::MAX } else { square };
        Ok(Self {
            radius_squared,
            peak,
        })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> Patch<$arithmetic<SIZE>> {
            /// The disc of radius `radius`, from 1e-4 to 2.
            ///
            /// # Errors
            /// `radius` outside its range.
            pub const fn new(radius: U2F30) -> Result<Self, ParameterError> {
                let bits = radius.to_bits() as u64;
                // 1e-4 with 30 fraction bits is 107374.18.
                if bits < 107_374 || bits > 2 << 30 {
                    return Err(RADIUS_RANGE);
                }
                let square = bits * bits;
                let divisor = if square < 1 << 60 { square } else { 1 << 60 };
                let peak =
                    U32F32::from_bits((divide(INVERSE_PI << 60, divisor as u128) >> 32) as u64);
                // R = 2 covers every direction, whatever its length.
                let covered = if bits == 2 << 30 { u64::MAX } else { square };
                let radius_squared = $arithmetic::<SIZE>::separation(covered);
                Ok(Self {
                    radius_squared,
                    peak,
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

impl<A: Arithmetic> Patch<A> {
    /// The disc of a squared radius as an arithmetic of one's own holds it, with
    /// its peak in sr⁻¹; nothing is checked.
    #[must_use]
    pub const fn from_stored(radius_squared: A::Separation, peak: A::Scale) -> Self {
        Self {
            radius_squared,
            peak,
        }
    }

    /// R² as the arithmetic holds it.
    #[must_use]
    pub const fn radius_squared(&self) -> A::Separation {
        self.radius_squared
    }

    /// Whether V lies within the disc: m ≤ R.
    #[inline]
    pub(super) fn covers(&self, geometry: &impl Geometry<A>) -> bool {
        geometry.separation() <= self.radius_squared
    }
}

impl<A: Arithmetic> Shape for Patch<A> {
    type Arithmetic = A;
    type Foreshortening = Flat;

    #[inline]
    fn amplitude(&self) -> A::Scale {
        self.peak
    }

    #[inline]
    fn foreshortening(&self) -> &Flat {
        &Flat
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<A>) -> A::Unit {
        A::within(geometry.separation(), self.radius_squared)
    }
}
