//! Plastics: a diffuser under a highlight (3.31).

use fixed::types::{U1F31, U32F32};

use super::{Brdf, Lambert, MetallicPhong, Shape, tinted_brdf};
use crate::arithmetic::{Arithmetic, F32, Q31};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::Geometry;

/// f = a/π + a_s · c_n · cosⁿα / cosΘmin (3.31), for an albedo a and a
/// specular share a_s, each of red, green and blue.
///
/// The peak is the sum of the parts' peaks. In `q31` a share has 31 fraction
/// bits of that sum, so for n above 1e5 the diffuse part of
/// [`Brdf::share`] is coarse; BRDF and reflected radiance are not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic<A: Arithmetic> {
    diffuse: Lambert<A>,
    highlight: MetallicPhong<A>,
    specular: Rgb<A::Unit>,
    peak: A::Scale,
    /// The parts' shares of the peak.
    diffuse_weight: A::Unit,
    highlight_weight: A::Unit,
}

const SPECULAR_RANGE: ParameterError = ParameterError::new(
    "specular",
    "from 0 to 1, and with the greatest albedo at most 1",
);

impl Plastic<F32> {
    /// The plastic of an `albedo` and a `specular` share in [0, 1], and an
    /// exponent `n` from 0 to 1e8.
    ///
    /// # Errors
    /// A parameter outside its range or not a number; `specular` plus the
    /// greatest albedo above 1, which would create energy.
    pub const fn new(albedo: Rgb<f32>, specular: Rgb<f32>, n: f32) -> Result<Self, ParameterError> {
        let highlight = match MetallicPhong::<F32>::new(n) {
            Ok(highlight) => highlight,
            Err(error) => return Err(error),
        };
        let diffuse = match Lambert::<F32>::new(albedo) {
            Ok(diffuse) => diffuse,
            Err(error) => return Err(error),
        };
        let Rgb { r, g, b } = specular;
        // A share that is not a number fails here; `max` would pass it over.
        if !(r >= 0.0 && g >= 0.0 && b >= 0.0) {
            return Err(SPECULAR_RANGE);
        }
        // Room for rounding: 0.3 + 0.7 passes 1 in single precision.
        let total = r.max(g).max(b) + albedo.r.max(albedo.g).max(albedo.b);
        if total > 1.000_001 {
            return Err(SPECULAR_RANGE);
        }
        let peak = diffuse.peak + highlight.peak;
        Ok(Self {
            diffuse,
            highlight,
            specular,
            peak,
            diffuse_weight: diffuse.peak / peak,
            highlight_weight: highlight.peak / peak,
        })
    }
}

impl<const CELLS: usize> Plastic<Q31<CELLS>> {
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
        let highlight = match MetallicPhong::<Q31<CELLS>>::new(n) {
            Ok(highlight) => highlight,
            Err(error) => return Err(error),
        };
        let diffuse = match Lambert::<Q31<CELLS>>::new(albedo) {
            Ok(diffuse) => diffuse,
            Err(error) => return Err(error),
        };
        // Both may be rounded up by half a step.
        if greatest(specular) as u64 + greatest(albedo) as u64 > (1 << 31) + 1 {
            return Err(SPECULAR_RANGE);
        }
        let (low, high) = (
            diffuse.peak.to_bits() as u128,
            highlight.peak.to_bits() as u128,
        );
        let peak = low + high;
        Ok(Self {
            diffuse,
            highlight,
            specular,
            peak: U32F32::from_bits(peak as u64),
            diffuse_weight: U1F31::from_bits(((low << 31) / peak) as u32),
            highlight_weight: U1F31::from_bits(((high << 31) / peak) as u32),
        })
    }
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

impl<A: Arithmetic> Plastic<A> {
    /// a_s times the highlight's own share.
    #[inline]
    fn highlight_share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        self.specular
            .zip(self.highlight.share(geometry), A::product)
    }
}

impl<A: Arithmetic> Brdf<A> for Plastic<A> {
    #[inline]
    fn peak(&self) -> A::Scale {
        self.peak
    }

    #[inline]
    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        let diffuse = self.diffuse.share(geometry);
        diffuse.zip(self.highlight_share(geometry), |diffuse, highlight| {
            A::total(
                A::product(self.diffuse_weight, diffuse),
                A::product(self.highlight_weight, highlight),
            )
        })
    }

    #[inline]
    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value> {
        let highlight = tinted_brdf(&self.highlight, self.specular, geometry);
        self.diffuse.brdf(geometry).zip(highlight, A::add_values)
    }

    #[inline]
    fn reflect(&self, geometry: &impl Geometry<A>) -> Rgb<A::Radiance> {
        let peak = self.highlight.amplitude();
        let highlight = self
            .highlight_share(geometry)
            .map(|share| A::radiance(peak, share));
        self.diffuse
            .reflect(geometry)
            .zip(highlight, A::add_radiances)
    }
}
