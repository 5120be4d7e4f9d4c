//! Plastics and ceramics: a diffuser under a highlight (3.30, 3.31).

use fixed::types::{U1F31, U32F32};

use super::{Brdf, Lambert, Metal, MetallicPhong, Shape, tinted_brdf};
use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::CosineCurve;

/// f = a/π + a_s · c_n · cosⁿα / cosΘmin (3.31), for an albedo a and a
/// specular share a_s, each of red, green and blue.
///
/// With Fresnel's factor F(Θmin) of a real index on the highlight it is (3.30):
/// [`Plastic::with_fresnel`] makes its `H` a [`Metal`].
///
/// The peak is the sum of the parts' greatest values. In `q31` a share has 31 fraction
/// bits of that sum, so for n above 1e5 the diffuse part of
/// [`Brdf::share`] is coarse; BRDF and reflected radiance are not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic<A: Arithmetic, H = MetallicPhong<A>> {
    diffuse: Lambert<A>,
    highlight: H,
    specular: Rgb<A::Unit>,
    peak: A::Scale,
    /// The parts' shares of the peak.
    diffuse_weight: Rgb<A::Unit>,
    highlight_weight: Rgb<A::Unit>,
}

const SPECULAR_RANGE: ParameterError = ParameterError::new(
    "specular",
    "from 0 to 1, and with the greatest albedo at most 1",
);

impl<M: Math> Plastic<Float<M>> {
    /// The plastic of an `albedo` and a `specular` share in [0, 1], and an
    /// exponent `n` from 0 to 1e8.
    ///
    /// # Errors
    /// A parameter outside its range or not a number; `specular` plus the
    /// greatest albedo above 1, which would create energy.
    pub const fn new(albedo: Rgb<f32>, specular: Rgb<f32>, n: f32) -> Result<Self, ParameterError> {
        let highlight = match MetallicPhong::<Float<M>>::new(n) {
            Ok(highlight) => highlight,
            Err(error) => return Err(error),
        };
        let diffuse = match Lambert::<Float<M>>::new(albedo) {
            Ok(diffuse) => diffuse,
            Err(error) => return Err(error),
        };
        let Rgb { r, g, b } = specular;
        // A share that is not a number fails here; `max` would pass it over.
        if !(r >= 0.0 && g >= 0.0 && b >= 0.0) {
            return Err(SPECULAR_RANGE);
        }
        // Room for rounding: 0.3 + 0.7 passes 1 in single precision.
        let greatest = [albedo.r.max(albedo.g).max(albedo.b), r.max(g).max(b)];
        if greatest[0] + greatest[1] > 1.000_001 {
            return Err(SPECULAR_RANGE);
        }
        let peak = greatest[0] * diffuse.peak + greatest[1] * highlight.peak;
        let unit = if peak > 0.0 { 1.0 / peak } else { 0.0 };
        let (low, high) = (diffuse.peak * unit, highlight.peak * unit);
        Ok(Self {
            diffuse,
            highlight,
            specular,
            peak,
            diffuse_weight: Rgb {
                r: albedo.r * low,
                g: albedo.g * low,
                b: albedo.b * low,
            },
            highlight_weight: Rgb {
                r: r * high,
                g: g * high,
                b: b * high,
            },
        })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> Plastic<$arithmetic<SIZE>> {
            /// The plastic of an `albedo` and a `specular` share in [0, 1], and an
            /// exponent `n`, 0 or from 1 to 1e8.
            ///
            /// # Errors
            /// A parameter outside its range; `specular` plus the greatest albedo
            /// above 1, which would create energy.
            pub const fn new(
                albedo: Rgb<U1F31>,
                specular: Rgb<U1F31>,
                n: U32F32,
            ) -> Result<Self, ParameterError> {
                let highlight = match MetallicPhong::<$arithmetic<SIZE>>::new(n) {
                    Ok(highlight) => highlight,
                    Err(error) => return Err(error),
                };
                let diffuse = match Lambert::<$arithmetic<SIZE>>::new(albedo) {
                    Ok(diffuse) => diffuse,
                    Err(error) => return Err(error),
                };
                // Both may be rounded up by half a step.
                if greatest(specular) as u64 + greatest(albedo) as u64 > (1 << 31) + 1 {
                    return Err(SPECULAR_RANGE);
                }
                let (low, high) = (diffuse.peak.to_bits(), highlight.peak.to_bits());
                let peak = times(greatest(albedo), low) + times(greatest(specular), high);
                Ok(Self {
                    diffuse,
                    highlight,
                    specular,
                    peak: U32F32::from_bits(peak),
                    diffuse_weight: weights(albedo, low, peak),
                    highlight_weight: weights(specular, high, peak),
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

impl<A: Arithmetic> Plastic<A> {
    /// The same with Fresnel's factor on its highlight (3.30): `fresnel`, a
    /// curve over cosΘmin that reaches 1 at grazing, so that the peak stays.
    #[must_use]
    pub const fn with_fresnel(self, fresnel: CosineCurve) -> Plastic<A, Metal<A>> {
        Plastic {
            diffuse: self.diffuse,
            highlight: Metal::new(self.highlight, fresnel),
            specular: self.specular,
            peak: self.peak,
            diffuse_weight: self.diffuse_weight,
            highlight_weight: self.highlight_weight,
        }
    }
}

/// share · peak.
const fn times(share: u32, peak: u64) -> u64 {
    ((share as u128 * peak as u128) >> 31) as u64
}

/// What part of the whole `peak` a part with its `own` is, per channel.
const fn weights(shares: Rgb<U1F31>, own: u64, peak: u64) -> Rgb<U1F31> {
    Rgb {
        r: weight(shares.r, own, peak),
        g: weight(shares.g, own, peak),
        b: weight(shares.b, own, peak),
    }
}

const fn weight(share: U1F31, own: u64, peak: u64) -> U1F31 {
    if peak == 0 {
        return U1F31::ZERO;
    }
    U1F31::from_bits((share.to_bits() as u128 * own as u128 / peak as u128) as u32)
}

const fn greatest(colour: Rgb<U1F31>) -> u32 {
    let mut greatest = colour.r.to_bits();
    if colour.g.to_bits() > greatest {
        greatest = colour.g.to_bits();
    }
    if colour.b.to_bits() > greatest {
        greatest = colour.b.to_bits();
    }
    greatest
}

impl<A: Arithmetic, H: Shape<Arithmetic = A>> Brdf<A> for Plastic<A, H> {
    #[inline]
    fn peak(&self) -> A::Scale {
        self.peak
    }

    // A shading loop calls it once for a material: let the loop hold it.
    #[inline(always)]
    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        if !A::above_horizon(n_dot_l, n_dot_v) || !A::is_number(geometry.versine()) {
            return Rgb::grey(A::ZERO);
        }
        let diffuse = self
            .diffuse_weight
            .map(|weight| A::foreshorten(weight, n_dot_l));
        let highlight = self
            .highlight
            .share(geometry)
            .zip(self.highlight_weight, A::product);
        diffuse.zip(highlight, A::total)
    }

    #[inline]
    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value> {
        let highlight = tinted_brdf(&self.highlight, self.specular, geometry);
        self.diffuse.brdf(geometry).zip(highlight, A::add_values)
    }

    #[inline]
    fn reflect(&self, geometry: &impl Geometry<A>) -> Rgb<A::Radiance> {
        let peak = self.highlight.amplitude();
        let share = self
            .highlight
            .share(geometry)
            .zip(self.specular, A::product);
        let highlight = share.map(|share| A::radiance(peak, share));
        self.diffuse
            .reflect(geometry)
            .zip(highlight, A::add_radiances)
    }
}
