//! Unit vectors.

use crate::arithmetic::Arithmetic;

/// A direction, away from the surface: to the light or to the viewer, or a
/// surface normal.
///
/// Components are the arithmetic's own: `f32`, or `I2F30`, which holds 1.0.
/// For the stated accuracy its length must be within 2⁻¹⁴ of 1; with any
/// other length every result is finite and in range, and no more. An `f32`
/// component that is not a number or infinite makes the result 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction<A: Arithmetic> {
    /// First component; in the shading frame along the tangent.
    pub x: A::Component,
    /// Second component; in the shading frame along the bitangent.
    pub y: A::Component,
    /// Third component; in the shading frame the cosine with the normal.
    pub z: A::Component,
}

impl<A: Arithmetic> Direction<A> {
    /// A direction from its components.
    #[inline]
    pub const fn new(x: A::Component, y: A::Component, z: A::Component) -> Self {
        Self { x, y, z }
    }

    /// In the shading frame, the cosine of its angle with the normal.
    #[inline]
    #[must_use]
    pub fn cosine(&self) -> A::Cosine {
        A::upright(self.z)
    }
}
