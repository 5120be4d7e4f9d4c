//! Ray tracing for 16-bit shading: rays and shapes in 32 bits, since an error
//! of a ray grows with the distance; what it meets is rounded for the shader.

use fixed::types::{I2F14, I2F30, I8F24, I24F40};

use super::{Camera, Tracing};
use crate::arithmetic::{Q15, Q31};
use crate::geometry::Direction;

/// Tables are not traced: their size is of no matter.
type Fine = Q31<1>;

impl<const KNOTS: usize> Tracing for Q15<KNOTS> {
    type Ray = Direction<Fine>;
    type Length = I8F24;
    type Fine = I24F40;
    /// 28 fraction bits.
    type Near = i32;
    /// 24 fraction bits.
    type Depth = i64;

    #[inline]
    fn ray(camera: &Camera<Self>, x: usize, y: usize) -> Direction<Fine> {
        let camera = Camera::<Fine> {
            width: camera.width,
            height: camera.height,
            forward: camera.forward,
            right: camera.right,
            up: camera.up,
        };
        Fine::ray(&camera, x, y)
    }

    #[inline]
    fn reverse(d: &Direction<Fine>) -> Direction<Self> {
        rounded(&Fine::reverse(d))
    }

    #[inline]
    fn along(eye: &[I8F24; 3], d: &Direction<Fine>) -> I8F24 {
        Fine::along(eye, d)
    }

    #[inline]
    fn nearest(eye: &[I8F24; 3], d: &Direction<Fine>, along: I8F24) -> Option<[i32; 3]> {
        Fine::nearest(eye, d, along)
    }

    #[inline]
    fn half_chord(nearest: &[i32; 3]) -> Option<i32> {
        Fine::half_chord(nearest)
    }

    #[inline]
    fn entry(nearest: &[i32; 3], half: i32, d: &Direction<Fine>) -> Direction<Self> {
        rounded(&Fine::entry(nearest, half, d))
    }

    #[inline]
    fn sphere_depth(radius: I8F24, along: I8F24, half: i32) -> Option<i64> {
        Fine::sphere_depth(radius, along, half)
    }

    #[inline]
    fn plane_depth(height: I8F24, normal: &Direction<Self>, d: &Direction<Fine>) -> Option<i64> {
        Fine::plane_depth(height, &widened(normal), d)
    }

    #[inline]
    fn normalised(vector: [i32; 3]) -> Direction<Self> {
        rounded(&Fine::normalised(vector))
    }

    #[inline]
    fn stored_depth(near: I8F24, range: I8F24, code: u16) -> i64 {
        Fine::stored_depth(near, range, code)
    }
}

#[inline]
pub(super) fn widened<const KNOTS: usize>(d: &Direction<Q15<KNOTS>>) -> Direction<Fine> {
    let wide = |component: I2F14| I2F30::from_bits(i32::from(component.to_bits()) << 16);
    Direction::new(wide(d.x), wide(d.y), wide(d.z))
}

#[inline]
pub(super) fn rounded<const KNOTS: usize>(d: &Direction<Fine>) -> Direction<Q15<KNOTS>> {
    // Components are at most 1 but for a few steps: half a step more fits.
    let short = |component: I2F30| {
        I2F14::from_bits((component.to_bits().saturating_add(1 << 15) >> 16) as i16)
    };
    Direction::new(short(d.x), short(d.y), short(d.z))
}
