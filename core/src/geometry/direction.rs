//! Unit vectors.

use fixed::types::I2F14;

use crate::arithmetic::{Arithmetic, Q15};
use crate::table::root::root;

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

impl<const KNOTS: usize> Direction<Q15<KNOTS>> {
    /// The normal of a unit sphere about the origin, seen from afar along −z,
    /// at the point (x, y) of the picture plane; `None` beside the sphere. Its
    /// third component is within 2⁻¹³ of the exact one.
    #[inline]
    #[must_use]
    pub fn upon_sphere(x: I2F14, y: I2F14) -> Option<Self> {
        let square = |c: I2F14| (i32::from(c.to_bits()) * i32::from(c.to_bits())) as u32;
        // 28 fraction bits.
        let rest = (1u32 << 28).checked_sub(square(x).wrapping_add(square(y)))?;
        // 29 fraction bits, to 14.
        let z = (root(rest) + (1 << 14)) >> 15;
        Some(Self::new(x, y, I2F14::from_bits(z as i16)))
    }

    /// Its components' bits.
    #[inline(always)]
    pub(crate) fn bits(&self) -> [i32; 3] {
        [
            i32::from(self.x.to_bits()),
            i32::from(self.y.to_bits()),
            i32::from(self.z.to_bits()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{Direction, I2F14, Q15};

    #[test]
    fn normals_of_a_sphere_are_unit_vectors() {
        let mut worst = 0.0f64;
        for x in (-16_384..=16_384i16).step_by(64) {
            for y in (-16_384..=16_384i16).step_by(64) {
                let point = [x, y].map(|c| f64::from(c) / 16_384.0);
                let square = 1.0 - point[0] * point[0] - point[1] * point[1];
                let [x, y] = [x, y].map(I2F14::from_bits);
                match Direction::<Q15>::upon_sphere(x, y) {
                    Some(normal) => {
                        let z: f64 = normal.z.to_num();
                        worst = worst.max((z - square.sqrt()).abs());
                    }
                    None => assert!(square < 0.0),
                }
            }
        }
        assert!((3e-5..=1.0 / 8192.0).contains(&worst), "{worst:e}");
        let far = Direction::<Q15>::upon_sphere(I2F14::MIN, I2F14::MIN);
        assert!(far.is_none());
    }
}
