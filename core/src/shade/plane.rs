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

impl<A: Tracing> Plane<A> {
    /// Distance and normal where the ray `d` meets the plane.
    #[inline]
    pub(crate) fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>)> {
        let depth = A::plane_depth(self.height, &self.normal, d)?;
        Some((depth, self.normal))
    }
}
