//! Lambert's law: a constant BRDF (1.26).

use fixed::types::{U1F31, U32F32};

use super::Shape;
use super::foreshortening::Flat;
use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::integer::INVERSE_PI;

/// f = a/π for an albedo a of red, green and blue. The peak is 1/π, the share
/// a·cosΘL.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert<A: Arithmetic> {
    pub(super) peak: A::Scale,
    albedo: Rgb<A::Unit>,
}

const ALBEDO_RANGE: ParameterError = ParameterError::new("albedo", "a number from 0 to 1");

impl<M: Math> Lambert<Float<M>> {
    /// The diffuser with an albedo in [0, 1] per channel.
    ///
    /// # Errors
    /// An albedo outside its range or not a number.
    pub const fn new(albedo: Rgb<f32>) -> Result<Self, ParameterError> {
        let Rgb { r, g, b } = albedo;
        if !(r >= 0.0 && r <= 1.0 && g >= 0.0 && g <= 1.0 && b >= 0.0 && b <= 1.0) {
            return Err(ALBEDO_RANGE);
        }
        Ok(Self {
            peak: core::f32::consts::FRAC_1_PI,
            albedo,
        })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> Lambert<$arithmetic<SIZE>> {
            /// The diffuser with an albedo in [0, 1] per channel.
            ///
            /// # Errors
            /// An albedo above 1.
            pub const fn new(albedo: Rgb<U1F31>) -> Result<Self, ParameterError> {
                let [r, g, b] = [albedo.r.to_bits(), albedo.g.to_bits(), albedo.b.to_bits()];
                if r > 1 << 31 || g > 1 << 31 || b > 1 << 31 {
                    return Err(ALBEDO_RANGE);
                }
                Ok(Self {
                    peak: U32F32::from_bits((INVERSE_PI >> 32) as u64),
                    albedo,
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

impl<A: Arithmetic> Lambert<A> {
    /// The diffuser of an albedo as an arithmetic of one's own holds it, with the
    /// peak 1/π; nothing is checked.
    #[must_use]
    pub const fn from_stored(albedo: Rgb<A::Unit>, peak: A::Scale) -> Self {
        Self { peak, albedo }
    }
}

impl<A: Arithmetic> Shape for Lambert<A> {
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
        // The value does not depend on it, but the rule for bad input does.
        if A::is_number(geometry.versine()) {
            A::ONE
        } else {
            A::ZERO
        }
    }

    #[inline]
    fn coloured(&self, share: A::Unit, _: &impl Geometry<A>) -> Rgb<A::Unit> {
        self.albedo.map(|albedo| A::product(share, albedo))
    }
}
