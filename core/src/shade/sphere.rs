//! Spheres.

use super::{Extent, Tracing};
use crate::geometry::Direction;

/// A sphere, seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<A: Tracing> {
    /// (eye − centre)/radius, each coordinate below 128.
    pub eye: [A::Length; 3],
    /// Radius in scene units.
    pub radius: A::Length,
    /// Index of its material.
    pub material: u8,
    /// Where it may be seen.
    pub extent: Extent,
}

impl<A: Tracing> Sphere<A> {
    /// Distance, normal and material where the ray `d` enters; `None` beside the
    /// sphere and behind the eye. Whoever asks has looked at [`Self::extent`].
    #[inline]
    pub fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)> {
        let along = A::along(&self.eye, d);
        let nearest = A::nearest(&self.eye, d, along)?;
        let half = A::half_chord(&nearest)?;
        let depth = A::sphere_depth(self.radius, along, half)?;
        Some((depth, A::entry(&nearest, half, d), self.material))
    }
}
