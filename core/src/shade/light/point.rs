//! A lamp that shines alike in all directions.

use super::{Beam, Light};
use crate::brdf::Brdf;
use crate::colour::Rgb;
use crate::geometry::{Direction, Geometry};
use crate::shade::Placing;

/// A point of some intensity; what arrives falls with the square of the
/// distance.
///
/// The gains of the materials are for the irradiance at the distance `near`,
/// so that the attenuation is a share; nearer than that no more arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight<A: Placing> {
    /// Where it is, as seen from the eye, in scene units.
    pub position: [A::Length; 3],
    /// Least distance to anything that it lights, in scene units.
    pub near: A::Length,
}

impl<A: Placing> Light<A> for PointLight<A> {
    type Beam = Dimmed<A>;

    #[inline]
    fn beam(&self, place: impl Fn() -> A::Place) -> Dimmed<A> {
        let (direction, dimming) = A::towards(&place(), &self.position, self.near);
        Dimmed {
            direction,
            dimming: Some(dimming),
        }
    }

    #[inline]
    fn lamp(&self) -> Option<&[A::Length; 3]> {
        Some(&self.position)
    }
}

/// A beam of which perhaps only a share arrives.
#[derive(Clone, Copy, Debug)]
pub struct Dimmed<A: Placing> {
    /// To the light.
    pub direction: Direction<A>,
    /// The share, where it is not all.
    pub dimming: Option<A::Dimming>,
}

/// All of a beam, beside lamps whose light is dimmed.
impl<A: Placing> From<Direction<A>> for Dimmed<A> {
    #[inline]
    fn from(direction: Direction<A>) -> Self {
        Self {
            direction,
            dimming: None,
        }
    }
}

impl<A: Placing> Beam<A> for Dimmed<A> {
    #[inline]
    fn direction(&self) -> &Direction<A> {
        &self.direction
    }

    #[inline]
    fn shade(
        &self,
        model: &impl Brdf<A>,
        gain: &Rgb<A::Gain>,
        geometry: &impl Geometry<A>,
    ) -> Rgb<A::Light> {
        match self.dimming {
            None => model.shade(gain, geometry),
            Some(dimming) => gain.zip(model.share(geometry), |gain, share| {
                A::expose(gain, A::dim(share, dimming))
            }),
        }
    }
}
