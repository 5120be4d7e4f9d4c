//! Planes.

use super::Tracing;
use crate::geometry::Direction;

/// A plane, seen from its front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<A: Tracing> {
    /// Unit normal, towards the eye's side.
    pub normal: Direction<A>,
    /// Height of the eye above it, in scene units.
    pub height: A::Length,
    /// Index of its material.
    pub material: u8,
}

/// A plane and what it is painted with: a [`Plane`] of one material, or a
/// [`Checker`](super::Checker).
pub trait Ground<A: Tracing> {
    /// Distance, normal and material where the ray `d` meets it.
    fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)>;
}

impl<A: Tracing> Ground<A> for Plane<A> {
    #[inline]
    fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)> {
        let depth = A::plane_depth(self.height, &self.normal, d)?;
        Some((depth, self.normal, self.material))
    }
}
