//! cosⁿα lobes: metallic Phong (3.7), reciprocal Phong (3.5), the p-model
//! (3.12) and their retro-reflective forms (3.13).

use core::marker::PhantomData;

use fixed::types::U32F32;

use super::Shape;
use super::foreshortening::{Flat, Foreshortening, Metallic, PowerModel};
use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31, exponent};
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::integer::INVERSE_PI;

/// f = c_n · cosⁿα / cosᵖΘmin, c_n = (n + 2)/2π (3.6), where α is the angle
/// between V and the axis `X` of the lobe, and `P` the foreshortening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhongLobe<A: Arithmetic, X, P> {
    power: A::Power,
    pub(super) peak: A::Scale,
    foreshortening: P,
    axis: PhantomData<X>,
}

/// The metallic Phong model (3.7): f = c_n · cosⁿα / cosΘmin.
///
/// Tends to the ideal mirror for n → ∞; its albedo at grazing is
/// (n+2)/(2n+2) (3.27). With c_n as published the albedo passes 1 for n < 2:
/// by 2.9e-4 at n = 1, by 8.6e-2 at n = 0 ([`PhongLobe::with_peak`] mends
/// it).
///
/// In `f32` the sRGB code of the share is within 0.55 LSB of the exact one
/// for any n to 1e8, in `q31` within 0.60 LSB for n from 1 to 1e5; tested in
/// `tests/tests/accuracy.rs`.
///
/// ```
/// use microbrdf::arithmetic::F32;
/// use microbrdf::brdf::{Brdf, MetallicPhong};
/// use microbrdf::geometry::{Direction, ShadingFrame};
///
/// let silver = MetallicPhong::<F32>::new(60.0)?;
/// let l = Direction::new(0.6, 0.0, 0.8);
/// let mirror = Direction::new(-0.6, 0.0, 0.8);
/// let f = silver.brdf(&ShadingFrame::new(l, mirror)).r;
/// assert!((f - 62.0 / core::f32::consts::TAU / 0.8).abs() < 1e-5);
/// # Ok::<(), microbrdf::ParameterError>(())
/// ```
pub type MetallicPhong<A> = PhongLobe<A, Mirror, Metallic>;

/// Reciprocal Phong (3.5): f = c_n · cosⁿα. Darkens at grazing.
pub type Phong<A> = PhongLobe<A, Mirror, Flat>;

/// The p-model (3.12), 0 < p < 1, between [`Phong`] and [`MetallicPhong`].
pub type PModel<A> = PhongLobe<A, Mirror, PowerModel<A>>;

/// Retro-reflective metallic Phong (3.13): the lobe points back to the light.
pub type RetroPhong<A> = PhongLobe<A, Retro, Metallic>;

/// Where a lobe points.
pub trait Axis {
    /// 1 − cos α.
    fn versine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Versine;
}

/// To R, the light direction mirrored at the normal (3.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mirror;

impl Axis for Mirror {
    #[inline]
    fn versine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Versine {
        geometry.versine()
    }
}

/// Back to the light (3.13).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Retro;

impl Axis for Retro {
    #[inline]
    fn versine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Versine {
        geometry.retro_versine()
    }
}

impl<A: Arithmetic, X: Axis, P: Foreshortening<A>> PhongLobe<A, X, P> {
    /// The lobe cosⁿα as an arithmetic of one's own holds it, with its peak in sr⁻¹
    /// and a foreshortening; nothing is checked.
    #[must_use]
    pub const fn from_stored(power: A::Power, peak: A::Scale, foreshortening: P) -> Self
    where
        P: Copy,
    {
        Self {
            power,
            peak,
            foreshortening,
            axis: PhantomData,
        }
    }

    /// Its stored lobe cosⁿα.
    #[inline]
    pub(super) const fn power(&self) -> &A::Power {
        &self.power
    }

    /// The same with another peak in sr⁻¹. For n < 2 the published constant
    /// divided by the greatest albedo conserves energy strictly.
    #[must_use]
    pub fn with_peak(self, peak: A::Scale) -> Self {
        Self { peak, ..self }
    }
}

impl<M: Math, X: Axis, P: Foreshortening<Float<M>>> PhongLobe<Float<M>, X, P> {
    /// The lobe with exponent `n` from 0 to 1e8 and a foreshortening.
    ///
    /// # Errors
    /// `n` outside its range or not a number.
    pub const fn with_foreshortening(n: f32, foreshortening: P) -> Result<Self, ParameterError>
    where
        P: Copy,
    {
        let n = match exponent::single(n) {
            Ok(n) => n,
            Err(error) => return Err(error),
        };
        let peak = (n + 2.0) / core::f32::consts::TAU;
        Ok(Self {
            power: n,
            peak,
            foreshortening,
            axis: PhantomData,
        })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize, X: Axis, P: Foreshortening<$arithmetic<SIZE>>>
            PhongLobe<$arithmetic<SIZE>, X, P>
        {
            /// The lobe with exponent `n`, 0 or from 1 to 1e8, and a foreshortening.
            /// Between 0 and 1 the slope at α = 90° is infinite, which no table of
            /// even cells holds.
            ///
            /// # Errors
            /// `n` outside its range.
            pub const fn with_foreshortening(
                n: U32F32,
                foreshortening: P,
            ) -> Result<Self, ParameterError>
            where
                P: Copy,
            {
                let bits = match exponent::fixed(n) {
                    Ok(bits) => bits,
                    Err(error) => return Err(error),
                };
                let peak = U32F32::from_bits(lobe_peak(bits));
                let power = $arithmetic::<SIZE>::stored_power(bits);
                Ok(Self {
                    power,
                    peak,
                    foreshortening,
                    axis: PhantomData,
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

/// (n + 2)/2π (3.6), 32 fraction bits in and out.
pub(super) const fn lobe_peak(n: u64) -> u64 {
    (((n + (2 << 32)) as u128 * INVERSE_PI) >> 65) as u64
}

macro_rules! plain_constructors {
    ($($foreshortening:ident),*) => {$(
        impl<M: Math, X: Axis> PhongLobe<Float<M>, X, $foreshortening> {
            /// The lobe with exponent `n` from 0 to 1e8.
            ///
            /// # Errors
            /// `n` outside its range or not a number.
            pub const fn new(n: f32) -> Result<Self, ParameterError> {
                Self::with_foreshortening(n, $foreshortening)
            }
        }

    )*};
}

macro_rules! plain_fixed_constructors {
    ($($arithmetic:ident $foreshortening:ident),*) => {$(
        impl<const SIZE: usize, X: Axis> PhongLobe<$arithmetic<SIZE>, X, $foreshortening> {
            /// The lobe with exponent `n`, 0 or from 1 to 1e8.
            ///
            /// # Errors
            /// `n` outside its range.
            pub const fn new(n: U32F32) -> Result<Self, ParameterError> {
                Self::with_foreshortening(n, $foreshortening)
            }
        }
    )*};
}

plain_constructors!(Flat, Metallic);
plain_fixed_constructors!(Q31 Flat, Q31 Metallic, Q15 Flat, Q15 Metallic);

impl<A: Arithmetic, X: Axis, P: Foreshortening<A>> Shape for PhongLobe<A, X, P> {
    type Arithmetic = A;
    type Foreshortening = P;

    #[inline]
    fn amplitude(&self) -> A::Scale {
        self.peak
    }

    #[inline]
    fn foreshortening(&self) -> &P {
        &self.foreshortening
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<A>) -> A::Unit {
        A::power(&self.power, X::versine(geometry))
    }
}

#[cfg(test)]
mod tests {
    use fixed::types::U32F32;

    use super::MetallicPhong;
    use crate::arithmetic::{F32, Q31};
    use crate::brdf::Brdf;

    #[test]
    fn another_peak_is_taken() {
        let lobe = MetallicPhong::<F32>::new(3.0).expect("n");
        assert_eq!(lobe.with_peak(0.25).peak(), 0.25);
        let lobe = MetallicPhong::<Q31>::new(U32F32::lit("3")).expect("n");
        let peak = U32F32::lit("0.25");
        assert_eq!(lobe.with_peak(peak).peak(), peak);
    }
}
