//! Shadows, where a scene asks for them.

use super::{Light, Placing, Sphere};
use crate::geometry::Direction;

/// The point that is shaded, as a scene's lights see it.
pub trait Spot<A: Placing>: Copy {
    /// Where it is.
    fn place(self) -> A::Place;
    /// Whether something keeps this light, in the direction `l`, from it.
    fn shadowed(self, light: &impl Light<A>, l: &Direction<A>) -> bool;
}

/// Whether a scene's spheres throw shadows: [`Shadowed`] or [`Unshadowed`].
///
/// Planes need no test: a scene is on one side of each, so that a light behind
/// one reaches nothing, and whoever makes the scene leaves it out.
pub trait Shadows: Copy {
    /// Whether one of the spheres keeps a light from a place.
    fn hide<A: Placing>(
        self,
        spheres: &[Sphere<A>],
        place: impl Fn() -> A::Place,
        light: &impl Light<A>,
        l: &Direction<A>,
    ) -> bool;
}

/// Every light reaches everything that faces it; this costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unshadowed;

impl Shadows for Unshadowed {
    #[inline]
    fn hide<A: Placing>(
        self,
        _: &[Sphere<A>],
        _: impl Fn() -> A::Place,
        _: &impl Light<A>,
        _: &Direction<A>,
    ) -> bool {
        false
    }
}

/// Spheres throw shadows, with sharp edges.
///
/// An edge is displaced by at most 5e-7 in `f32`, 1.5e-7 in `q31` and `q15`,
/// times the greatest of 1, the sphere's radius, and both distances from the eye;
/// in `q15`, whose lights have components of 16 bits, by 6e-5 of the distance
/// from the place to the sphere besides. Tested in `tests/tests/shadows.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shadowed;

impl Shadows for Shadowed {
    #[inline]
    fn hide<A: Placing>(
        self,
        spheres: &[Sphere<A>],
        place: impl Fn() -> A::Place,
        light: &impl Light<A>,
        l: &Direction<A>,
    ) -> bool {
        let place = place();
        spheres
            .iter()
            .any(|sphere| A::hides(sphere, &place, l, light.lamp()))
    }
}

/// What a ray met, among the scene's spheres.
pub(super) struct Met<'a, A: Placing, F, H> {
    pub(super) place: F,
    pub(super) spheres: &'a [Sphere<A>],
    pub(super) shadows: H,
}

impl<A: Placing, F: Fn() -> A::Place, H: Shadows> Spot<A> for &Met<'_, A, F, H> {
    #[inline]
    fn place(self) -> A::Place {
        (self.place)()
    }

    #[inline]
    fn shadowed(self, light: &impl Light<A>, l: &Direction<A>) -> bool {
        self.shadows.hide(self.spheres, &self.place, light, l)
    }
}
