//! Ray tracing in single precision.

use super::{Camera, Tracing};
use crate::arithmetic::{Arithmetic, Float, Math};
use crate::geometry::Direction;

impl<M: Math> Tracing for Float<M> {
    type Ray = Direction<Self>;
    type Length = f32;
    type Fine = f32;
    type Near = f32;
    type Depth = f32;

    #[inline]
    fn ray(camera: &Camera<Self>, x: usize, y: usize) -> Direction<Self> {
        let (column, row) = camera.half_steps(x, y);
        let (column, row) = (column as f32, row as f32);
        let coordinate =
            |i: usize| camera.forward[i] + (column * camera.right[i] + row * camera.up[i]);
        let [x, y, z] = [coordinate(0), coordinate(1), coordinate(2)];
        let scale = 1.0 / M::root(x * x + y * y + z * z);
        Direction::new(x * scale, y * scale, z * scale)
    }

    #[inline]
    fn reverse(d: &Direction<Self>) -> Direction<Self> {
        Direction::new(-d.x, -d.y, -d.z)
    }

    #[inline]
    fn along(eye: &[f32; 3], d: &Direction<Self>) -> f32 {
        -(eye[0] * d.x + eye[1] * d.y + eye[2] * d.z)
    }

    #[inline]
    fn nearest(eye: &[f32; 3], d: &Direction<Self>, along: f32) -> Option<[f32; 3]> {
        Some([
            eye[0] + along * d.x,
            eye[1] + along * d.y,
            eye[2] + along * d.z,
        ])
    }

    #[inline]
    fn half_chord(nearest: &[f32; 3]) -> Option<f32> {
        let rest = 1.0 - Self::square(*nearest);
        if rest >= 0.0 {
            Some(M::root(rest))
        } else {
            None
        }
    }

    #[inline]
    fn entry(nearest: &[f32; 3], half: f32, d: &Direction<Self>) -> Direction<Self> {
        let [x, y, z] = *nearest;
        Direction::new(x - half * d.x, y - half * d.y, z - half * d.z)
    }

    #[inline]
    fn sphere_depth(radius: f32, along: f32, half: f32) -> Option<f32> {
        let depth = radius * (along - half);
        if depth > 0.0 { Some(depth) } else { None }
    }

    #[inline]
    fn plane_depth(height: f32, normal: &Direction<Self>, d: &Direction<Self>) -> Option<f32> {
        let cosine = Self::dot(normal, d);
        if cosine < 0.0 {
            Some(height / -cosine)
        } else {
            None
        }
    }

    #[inline]
    fn normalised(vector: [i32; 3]) -> Direction<Self> {
        // Few bits are set of each: exact.
        let [x, y, z] = vector.map(|c| c as f32);
        let scale = 1.0 / M::root(x * x + y * y + z * z);
        Direction::new(x * scale, y * scale, z * scale)
    }

    #[inline]
    fn stored_depth(near: f32, range: f32, code: u16) -> f32 {
        near + range * (f32::from(code) / 65_536.0)
    }
}
