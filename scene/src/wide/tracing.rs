//! What eight neighbouring pixels see.
//!
//! Where a pixel's ray meets nothing the depth is not a number, which is nearer
//! than none.

use microbrdf::arithmetic::Arithmetic;
use microbrdf::geometry::Direction;
use microbrdf::shade::{Camera, Tracing};

use super::lanes::{One, all};
use super::{Lanes, Wide};

/// `None` where no pixel has a number.
#[inline(always)]
fn some(lanes: Lanes) -> Option<Lanes> {
    lanes.numbers().any().then_some(lanes)
}

impl Tracing for Wide {
    type Ray = Direction<Self>;
    type Length = Lanes;
    type Fine = f32;
    type Near = Lanes;
    type Depth = Lanes;

    /// From column `x` to the right.
    #[inline(always)]
    fn ray(camera: &Camera<Self>, x: usize, y: usize) -> Direction<Self> {
        let (column, row) = camera.half_steps(x, y);
        // As numbers in single precision they are exact.
        let column = Lanes::of(|i| (column + 2 * i as i32) as f32);
        let row = Lanes::all(row as f32);
        let [x, y, z] = [0, 1, 2].map(|i| {
            let [forward, right, up] =
                [camera.forward, camera.right, camera.up].map(|axis| Lanes::all(axis[i]));
            forward + (column * right + row * up)
        });
        let scale = Lanes::ONE / (x * x + y * y + z * z).root();
        Direction::new(x * scale, y * scale, z * scale)
    }
    #[inline(always)]
    fn reverse(d: &Direction<Self>) -> Direction<Self> {
        Direction::new(d.x.negative(), d.y.negative(), d.z.negative())
    }
    #[inline(always)]
    fn along(eye: &[Lanes; 3], d: &Direction<Self>) -> Lanes {
        (eye[0] * d.x + eye[1] * d.y + eye[2] * d.z).negative()
    }
    #[inline(always)]
    fn nearest(eye: &[Lanes; 3], d: &Direction<Self>, along: Lanes) -> Option<[Lanes; 3]> {
        Some([
            eye[0] + along * d.x,
            eye[1] + along * d.y,
            eye[2] + along * d.z,
        ])
    }
    #[inline(always)]
    fn half_chord(nearest: &[Lanes; 3]) -> Option<Lanes> {
        // A root of less than 0 is none.
        some((Lanes::ONE - Self::square(*nearest)).root())
    }
    #[inline(always)]
    fn entry(nearest: &[Lanes; 3], half: Lanes, d: &Direction<Self>) -> Direction<Self> {
        let [x, y, z] = *nearest;
        Direction::new(x - half * d.x, y - half * d.y, z - half * d.z)
    }
    #[inline(always)]
    fn sphere_depth(radius: Lanes, along: Lanes, half: Lanes) -> Option<Lanes> {
        let depth = radius * (along - half);
        some(depth.above(Lanes::ZERO).or_none(depth))
    }
    #[inline(always)]
    fn plane_depth(height: Lanes, normal: &Direction<Self>, d: &Direction<Self>) -> Option<Lanes> {
        let cosine = Self::dot(normal, d);
        let depth = height / cosine.negative();
        some(cosine.below(Lanes::ZERO).or_none(depth))
    }
    fn normalised(vector: [i32; 3]) -> Direction<Self> {
        all(One::normalised(vector))
    }
    fn stored_depth(near: Lanes, range: Lanes, code: u16) -> Lanes {
        near.zip(range, |near, range| One::stored_depth(near, range, code))
    }
}
