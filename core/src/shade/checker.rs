//! Planes with a checker of two materials.

use super::{Ground, Placing, Plane};
use crate::geometry::Direction;

/// A plane whose squares have two materials in turn.
///
/// A point on an edge belongs to the square on the side of the greater
/// coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker<A: Placing> {
    /// The plane, with the material of the squares of an even sum.
    pub plane: Plane<A>,
    /// Index of the material of the others.
    pub odd: u8,
    /// The eye's two coordinates on the plane, in squares.
    pub eye: [A::Fine; 2],
    /// Along which they are counted: unit vectors in the plane, divided by
    /// the squares' size, which must be at least 1/32 of a scene unit.
    pub across: [[A::Fine; 3]; 2],
}

impl<A: Placing> Ground<A> for Checker<A> {
    #[inline]
    fn hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)> {
        let (depth, normal, even) = self.plane.hit(d)?;
        let odd = |i: usize| A::odd_stripe(self.eye[i], &self.across[i], d, depth);
        let material = if even == self.odd || odd(0) == odd(1) {
            even
        } else {
            self.odd
        };
        Some((depth, normal, material))
    }
}
