//! What eight neighbouring pixels see.
//!
//! Where a pixel's ray meets nothing the depth is not a number, which is nearer
//! than none.

use microbrdf::geometry::Direction;
use microbrdf::shade::{Camera, Tracing};

use super::lanes::{One, WIDTH, directions, one};
use super::{Lanes, Wide};

/// The camera as one pixel's ray takes it.
#[inline(always)]
fn single(camera: &Camera<Wide>) -> Camera<One> {
    Camera {
        width: camera.width,
        height: camera.height,
        forward: camera.forward,
        right: camera.right,
        up: camera.up,
    }
}

/// `None` where no pixel has a number.
#[inline(always)]
fn some(lanes: Lanes) -> Option<Lanes> {
    let none = (0..WIDTH).fold(true, |none, i| none & lanes.0[i].is_nan());
    (!none).then_some(lanes)
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
        let camera = single(camera);
        directions(|i| One::ray(&camera, x + i, y))
    }
    #[inline(always)]
    fn reverse(d: &Direction<Self>) -> Direction<Self> {
        directions(|i| One::reverse(&one(d, i)))
    }
    #[inline(always)]
    fn along(eye: &[Lanes; 3], d: &Direction<Self>) -> Lanes {
        Lanes::of(|i| One::along(&eye.map(|c| c.0[i]), &one(d, i)))
    }
    #[inline(always)]
    fn nearest(eye: &[Lanes; 3], d: &Direction<Self>, along: Lanes) -> Option<[Lanes; 3]> {
        let mut nearest = [Lanes::default(); 3];
        for i in 0..WIDTH {
            let eye = eye.map(|c| c.0[i]);
            let point = One::nearest(&eye, &one(d, i), along.0[i]).unwrap_or([f32::NAN; 3]);
            for (lanes, c) in nearest.iter_mut().zip(point) {
                lanes.0[i] = c;
            }
        }
        Some(nearest)
    }
    #[inline(always)]
    fn half_chord(nearest: &[Lanes; 3]) -> Option<Lanes> {
        some(Lanes::of(|i| {
            One::half_chord(&nearest.map(|c| c.0[i])).unwrap_or(f32::NAN)
        }))
    }
    #[inline(always)]
    fn entry(nearest: &[Lanes; 3], half: Lanes, d: &Direction<Self>) -> Direction<Self> {
        directions(|i| One::entry(&nearest.map(|c| c.0[i]), half.0[i], &one(d, i)))
    }
    #[inline(always)]
    fn sphere_depth(radius: Lanes, along: Lanes, half: Lanes) -> Option<Lanes> {
        some(Lanes::of(|i| {
            One::sphere_depth(radius.0[i], along.0[i], half.0[i]).unwrap_or(f32::NAN)
        }))
    }
    #[inline(always)]
    fn plane_depth(height: Lanes, normal: &Direction<Self>, d: &Direction<Self>) -> Option<Lanes> {
        some(Lanes::of(|i| {
            One::plane_depth(height.0[i], &one(normal, i), &one(d, i)).unwrap_or(f32::NAN)
        }))
    }
    fn normalised(vector: [i32; 3]) -> Direction<Self> {
        directions(|_| One::normalised(vector))
    }
    fn stored_depth(near: Lanes, range: Lanes, code: u16) -> Lanes {
        Lanes::of(|i| One::stored_depth(near.0[i], range.0[i], code))
    }
}
