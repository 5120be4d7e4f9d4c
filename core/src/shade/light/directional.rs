//! A light at infinity.

use super::{Beam, Light};
use crate::arithmetic::Arithmetic;
use crate::brdf::Brdf;
use crate::colour::Rgb;
use crate::geometry::{Direction, Geometry};
use crate::shade::Placing;

impl<A: Placing> Light<A> for Direction<A> {
    type Beam = Self;

    #[inline]
    fn beam(&self, _: impl Fn() -> A::Place) -> Self {
        *self
    }

    #[inline]
    fn lamp(&self) -> Option<&[A::Length; 3]> {
        None
    }
}

impl<A: Arithmetic> Beam<A> for Direction<A> {
    #[inline]
    fn direction(&self) -> &Self {
        self
    }

    #[inline]
    fn shade(
        &self,
        model: &impl Brdf<A>,
        gain: &Rgb<A::Gain>,
        geometry: &impl Geometry<A>,
    ) -> Rgb<A::Light> {
        model.shade(gain, geometry)
    }
}
