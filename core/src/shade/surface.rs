//! A material under a scene's lights.

use super::{Beam, Light, Placing, Spot};
use crate::arithmetic::Arithmetic;
use crate::brdf::Brdf;
use crate::colour::Rgb;
use crate::geometry::{Direction, World};
use crate::table::CosineCurve;

/// What a scene knows of a material: the light that it sends to the viewer.
pub trait Surface<A: Placing> {
    /// Exposed light from a point with normal `n` towards `v`, both unit
    /// vectors of the lights' frame; `spot` tells where the point is, to those
    /// lights that ask, and what is kept from it.
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light>;
}

/// A model with the gain of each light, and its answer to daylight.
///
/// A gain is peak · irradiance · exposure · tint, per channel: what the
/// model's share is multiplied by, once, at the end.
#[derive(Clone, Copy, Debug)]
pub struct Coat<'a, A: Arithmetic, M, D> {
    /// The reflectance model.
    pub model: M,
    /// One gain for each of the scene's lights, in their order.
    pub gains: &'a [Rgb<A::Gain>],
    /// [`AlbedoDaylight`] or [`NoDaylight`].
    pub daylight: D,
}

impl<A: Placing, M: Brdf<A>, D: Daylight<A>> Surface<A> for Coat<'_, A, M, D> {
    #[inline]
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light> {
        let n_dot_v = A::dot(n, v);
        let mut sum = self.daylight.light(n_dot_v);
        for (light, gain) in lights.iter().zip(self.gains) {
            let beam = light.beam(|| spot.place());
            if spot.shadowed(light, beam.direction()) {
                continue;
            }
            let geometry = World::with_cosine(*n, *beam.direction(), *v, n_dot_v);
            sum = sum.zip(beam.shade(&self.model, gain, &geometry), A::add_light);
        }
        sum
    }
}

/// Two coats, one over the other: their light is added.
impl<A: Placing, S: Surface<A>, T: Surface<A>> Surface<A> for (S, T) {
    #[inline]
    fn light(
        &self,
        n: &Direction<A>,
        v: &Direction<A>,
        lights: &[impl Light<A>],
        spot: impl Spot<A>,
    ) -> Rgb<A::Light> {
        self.0
            .light(n, v, lights, spot)
            .zip(self.1.light(n, v, lights, spot), A::add_light)
    }
}

/// Reflection of a uniform sky.
pub trait Daylight<A: Arithmetic> {
    /// Exposed light that the sky sends to the viewer by way of the surface.
    fn light(&self, n_dot_v: A::Cosine) -> Rgb<A::Light>;
}

/// No sky: costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoDaylight;

impl<A: Arithmetic> Daylight<A> for NoDaylight {
    #[inline]
    fn light(&self, _: A::Cosine) -> Rgb<A::Light> {
        Rgb::default()
    }
}

/// A uniform sky: the BRDF's directional albedo times the sky's radiance
/// (3.32), the albedo tabulated over N·V with everything that it contains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlbedoDaylight<A: Arithmetic> {
    /// Directional albedo per channel.
    pub albedo: CosineCurve,
    /// Sky radiance · exposure per channel.
    pub gain: Rgb<A::Gain>,
}

impl<A: Arithmetic> Daylight<A> for AlbedoDaylight<A> {
    #[inline]
    fn light(&self, n_dot_v: A::Cosine) -> Rgb<A::Light> {
        self.gain.zip(A::curve(&self.albedo, n_dot_v), A::expose)
    }
}
