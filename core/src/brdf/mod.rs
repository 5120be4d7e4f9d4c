//! The reflectance models, one file each.
//!
//! A model is a peak c, a shape in [0, 1] (a lobe, perhaps with Fresnel's
//! factor) and a foreshortening: what the shape is divided by. The formulas
//! that join them stand in this file, once, for every model and arithmetic:
//!
//! * BRDF: f(L, V) = c · shape / cosᵖΘmin, in sr⁻¹, without the cosine;
//! * reflected radiance for unit normal irradiance: f · cosΘL = c · ρ, with
//!   the share ρ = shape · cosΘL / cosᵖΘmin, bounded by the shape for p ≤ 1.

mod direct_phong;
mod exposed;
mod exposed_patch;
mod foreshortening;
mod generalised_lambert;
mod lambert;
mod metal;
mod patch;
mod patch_exponential;
mod patch_profile;
mod phong;
mod plastic;
mod tinted;

pub use direct_phong::DirectPhong;
pub use exposed::{Exposed, ExposedMetal, ExposedPhong, Exposing};
pub use exposed_patch::ExposedPatch;
pub use foreshortening::{Flat, Foreshortening, Metallic, PowerModel};
pub use generalised_lambert::GeneralisedLambert;
pub use lambert::Lambert;
pub use metal::Metal;
pub use patch::Patch;
pub use patch_exponential::PatchExponential;
pub(crate) use patch_exponential::mixture_mass;
pub use patch_profile::PatchProfile;
pub use phong::{Axis, MetallicPhong, Mirror, PModel, Phong, PhongLobe, Retro, RetroPhong};
pub use plastic::Plastic;
pub use tinted::{Incidence, MetallicPaint, PatchMetal, ThetaMin, ThetaPrime, Tinted};

use crate::arithmetic::Arithmetic;
use crate::colour::Rgb;
use crate::geometry::Geometry;

/// A reflectance model in one arithmetic.
///
/// Below the horizon (a negative cosine) every result is 0. Where both
/// cosines are 0 the reflected radiance is 0, and the BRDF takes the greatest
/// value that its type holds, unless the shape is 0.
pub trait Brdf<A: Arithmetic> {
    /// The peak c in sr⁻¹: reflected radiance is c · ρ.
    fn peak(&self) -> A::Scale;

    /// The share ρ of the peak, per channel, in [0, 1] but for the red of
    /// metals outside the gamut.
    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit>;

    /// f(L, V) in sr⁻¹.
    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value>;

    /// Reflected radiance f(L, V)·cosΘL for unit normal irradiance, in sr⁻¹:
    /// at most the peak.
    #[inline]
    fn reflect(&self, geometry: &impl Geometry<A>) -> Rgb<A::Radiance> {
        let peak = self.peak();
        self.share(geometry).map(|share| A::radiance(peak, share))
    }

    /// Exposed light K·ρ for a gain K per channel, not yet clamped to 1.
    #[inline]
    fn shade(&self, gain: &Rgb<A::Gain>, geometry: &impl Geometry<A>) -> Rgb<A::Light> {
        gain.zip(self.share(geometry), A::expose)
    }
}

/// A model that is a peak, a shape and a foreshortening.
pub trait Shape {
    /// How it is computed.
    type Arithmetic: Arithmetic;
    /// What divides the shape.
    type Foreshortening: Foreshortening<Self::Arithmetic>;

    /// The peak in sr⁻¹.
    fn amplitude(&self) -> <Self::Arithmetic as Arithmetic>::Scale;

    /// What divides the shape.
    fn foreshortening(&self) -> &Self::Foreshortening;

    /// The colourless part of the shape in [0, 1], above the horizon.
    fn lobe(
        &self,
        geometry: &impl Geometry<Self::Arithmetic>,
    ) -> <Self::Arithmetic as Arithmetic>::Unit;

    /// A share of the lobe with the shape's colour; without one it is grey.
    #[inline]
    fn coloured(
        &self,
        share: <Self::Arithmetic as Arithmetic>::Unit,
        _: &impl Geometry<Self::Arithmetic>,
    ) -> Rgb<<Self::Arithmetic as Arithmetic>::Unit> {
        Rgb::grey(share)
    }
}

impl<A: Arithmetic, S: Shape<Arithmetic = A>> Brdf<A> for S {
    #[inline]
    fn peak(&self) -> A::Scale {
        self.amplitude()
    }

    #[inline]
    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        share_of(self, geometry, A::bounded)
    }

    // A shading loop calls it once for a material: let the loop hold it. The
    // pixel is clamped in any case.
    #[inline(always)]
    fn shade(&self, gain: &Rgb<A::Gain>, geometry: &impl Geometry<A>) -> Rgb<A::Light> {
        gain.zip(share_of(self, geometry, |share| share), A::expose)
    }

    #[inline]
    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value> {
        tinted_brdf(self, Rgb::grey(A::ONE), geometry)
    }
}

/// The share of a shape, with what `limit` leaves of the part without colour.
#[inline(always)]
fn share_of<A: Arithmetic>(
    model: &impl Shape<Arithmetic = A>,
    geometry: &impl Geometry<A>,
    limit: impl Fn(A::Unit) -> A::Unit,
) -> Rgb<A::Unit> {
    let (n_dot_l, n_dot_v) = geometry.cosines();
    if !A::lit(n_dot_l, n_dot_v) {
        return Rgb::grey(A::ZERO);
    }
    let lobe = model.lobe(geometry);
    // Most directions lie outside a narrow lobe: spare them the division.
    if lobe == A::ZERO {
        return Rgb::grey(lobe);
    }
    let share = model.foreshortening().attenuate(lobe, n_dot_l, n_dot_v);
    model.coloured(limit(share), geometry)
}

/// The BRDF of a shape, times a tint.
#[inline]
fn tinted_brdf<A: Arithmetic>(
    model: &impl Shape<Arithmetic = A>,
    tint: Rgb<A::Unit>,
    geometry: &impl Geometry<A>,
) -> Rgb<A::Value> {
    let (n_dot_l, n_dot_v) = geometry.cosines();
    let peak = model.amplitude();
    if !A::above_horizon(n_dot_l, n_dot_v) {
        return Rgb::grey(A::value(peak, A::ZERO));
    }
    let larger = A::larger(n_dot_l, n_dot_v);
    let shape = model.coloured(model.lobe(geometry), geometry);
    tint.zip(shape, |tint, shape| {
        model
            .foreshortening()
            .value(peak, A::product(shape, tint), larger)
    })
}
