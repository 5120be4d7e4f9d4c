//! Ray tracing in 32-bit fixed point.

use fixed::types::{I2F30, I8F24, I24F40};

use super::root::Root;
use super::{Camera, Tracing};
use crate::arithmetic::{Arithmetic, Q31};
use crate::geometry::Direction;

/// Fraction bits of a direction's component.
const DIRECTION: u32 = 30;
/// Fraction bits of a length.
const LENGTH: u32 = 24;
/// Fraction bits of a coordinate within a unit sphere.
const NEAR: u32 = 28;

impl<const CELLS: usize> Tracing for Q31<CELLS> {
    type Ray = Direction<Self>;
    type Length = I8F24;
    type Fine = I24F40;
    /// 28 fraction bits.
    type Near = i32;
    /// 24 fraction bits.
    type Depth = i64;

    #[inline]
    fn ray(camera: &Camera<Self>, x: usize, y: usize) -> Direction<Self> {
        let (column, row) = camera.half_steps(x, y);
        // 40 fraction bits, then 28: components stay below 8.
        let coordinate = |i: usize| {
            let across = i64::from(column).wrapping_mul(camera.right[i].to_bits());
            let up = i64::from(row).wrapping_mul(camera.up[i].to_bits());
            camera.forward[i]
                .to_bits()
                .wrapping_add(across)
                .wrapping_add(up)
        };
        let components = [coordinate(0), coordinate(1), coordinate(2)];
        let square = components.iter().fold(0, |sum: u64, component| {
            let magnitude = (component >> (40 - NEAR)).unsigned_abs();
            sum.wrapping_add(magnitude.wrapping_mul(magnitude))
        });
        // The length's rounding scales all components alike, which the
        // versine forgives; their directions keep 2⁻³⁰.
        let inverse = i64::from(Root::of(square).inverse_58());
        let [x, y, z] = components.map(|component| {
            I2F30::from_bits((((component >> 10).wrapping_mul(inverse)) >> DIRECTION) as i32)
        });
        Direction::new(x, y, z)
    }

    #[inline]
    fn reverse(d: &Direction<Self>) -> Direction<Self> {
        Direction::new(d.x.wrapping_neg(), d.y.wrapping_neg(), d.z.wrapping_neg())
    }

    #[inline]
    fn along(eye: &[I8F24; 3], d: &Direction<Self>) -> I8F24 {
        let sum = product(eye[0], d.x)
            .wrapping_add(product(eye[1], d.y))
            .wrapping_add(product(eye[2], d.z));
        I8F24::from_bits((sum.wrapping_neg() >> DIRECTION) as i32)
    }

    #[inline]
    fn nearest(eye: &[I8F24; 3], d: &Direction<Self>, along: I8F24) -> Option<[i32; 3]> {
        let coordinate = |eye: I8F24, d: I2F30| {
            let exact = (i64::from(eye.to_bits()) << DIRECTION).wrapping_add(product(along, d));
            i32::try_from(exact >> (LENGTH + DIRECTION - NEAR)).ok()
        };
        Some([
            coordinate(eye[0], d.x)?,
            coordinate(eye[1], d.y)?,
            coordinate(eye[2], d.z)?,
        ])
    }

    #[inline]
    fn half_chord(nearest: &[i32; 3]) -> Option<i32> {
        let square = nearest.iter().fold(0, |sum: u64, coordinate| {
            let magnitude = u64::from(coordinate.unsigned_abs());
            sum.wrapping_add(magnitude * magnitude)
        });
        let rest = (1u64 << (2 * NEAR)).checked_sub(square)?;
        Some(Root::of(rest).root() as i32)
    }

    #[inline]
    fn entry(nearest: &[i32; 3], half: i32, d: &Direction<Self>) -> Direction<Self> {
        let coordinate = |nearest: i32, d: I2F30| {
            let back = (i64::from(half) * i64::from(d.to_bits())) >> NEAR;
            I2F30::from_bits((nearest << (DIRECTION - NEAR)).wrapping_sub(back as i32))
        };
        let [x, y, z] = *nearest;
        Direction::new(coordinate(x, d.x), coordinate(y, d.y), coordinate(z, d.z))
    }

    #[inline]
    fn sphere_depth(radius: I8F24, along: I8F24, half: i32) -> Option<i64> {
        let distance = i64::from(along.to_bits()) - i64::from(half >> (NEAR - LENGTH));
        let depth = i64::from(radius.to_bits()).wrapping_mul(distance) >> LENGTH;
        if depth > 0 { Some(depth) } else { None }
    }

    #[inline]
    fn plane_depth(height: I8F24, normal: &Direction<Self>, d: &Direction<Self>) -> Option<i64> {
        let descent = -i64::from(Self::dot(normal, d).to_bits());
        if descent > 0 {
            Some((i64::from(height.to_bits()) << DIRECTION) / descent)
        } else {
            None
        }
    }

    #[inline]
    fn normalised(vector: [i32; 3]) -> Direction<Self> {
        let square = vector.iter().fold(0, |sum: u64, component| {
            let magnitude = u64::from(component.unsigned_abs());
            sum.wrapping_add(magnitude.wrapping_mul(magnitude))
        });
        // 58 fraction bits more than the vector has; from then on 30.
        let inverse = i64::from(Root::of(square).inverse_58());
        let [x, y, z] = vector.map(|component| {
            let product = i64::from(component).wrapping_mul(inverse);
            I2F30::from_bits((product >> (58 - DIRECTION)) as i32)
        });
        Direction::new(x, y, z)
    }

    #[inline]
    fn stored_depth(near: I8F24, range: I8F24, code: u16) -> i64 {
        let more = i64::from(range.to_bits()).wrapping_mul(i64::from(code)) >> 16;
        i64::from(near.to_bits()).wrapping_add(more)
    }
}

/// length · component, 54 fraction bits.
#[inline]
fn product(length: I8F24, component: I2F30) -> i64 {
    i64::from(length.to_bits()) * i64::from(component.to_bits())
}
