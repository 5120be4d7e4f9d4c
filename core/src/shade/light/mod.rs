//! What a scene is lit by: one file a kind.

mod directional;
mod flood;
mod point;

pub use flood::FloodLight;
pub use point::{Dimmed, PointLight};

use super::Placing;
use crate::arithmetic::Arithmetic;
use crate::brdf::Brdf;
use crate::colour::Rgb;
use crate::geometry::{Direction, Geometry};

/// A light of a scene: a [`Direction`] to it where it is at infinity, or a
/// lamp within the scene.
pub trait Light<A: Placing> {
    /// What arrives.
    type Beam: Beam<A>;

    /// What arrives at a place, which is computed only if it matters.
    fn beam(&self, place: impl Fn() -> A::Place) -> Self::Beam;

    /// Where it is, as seen from the eye, if it is not at infinity: what is
    /// farther throws no shadow.
    fn lamp(&self) -> Option<&[A::Length; 3]>;
}

impl<A: Placing, L: Light<A>> Light<A> for &L {
    type Beam = L::Beam;

    #[inline]
    fn beam(&self, place: impl Fn() -> A::Place) -> L::Beam {
        (**self).beam(place)
    }

    #[inline]
    fn lamp(&self) -> Option<&[A::Length; 3]> {
        (**self).lamp()
    }
}

/// Light that arrives from one direction.
pub trait Beam<A: Arithmetic>: Copy {
    /// To the light.
    fn direction(&self) -> &Direction<A>;

    /// Exposed light that a model sends on; `gain` is for the whole light.
    fn shade(
        &self,
        model: &impl Brdf<A>,
        gain: &Rgb<A::Gain>,
        geometry: &impl Geometry<A>,
    ) -> Rgb<A::Light>;
}
