//! Numbers of neighbouring pixels.

use microbrdf::arithmetic::Float;
use microbrdf::geometry::Direction;

use super::Wide;
use crate::host::Native;

/// How many pixels.
pub(super) const WIDTH: usize = 8;

/// What each of them is computed in.
pub(super) type One = Float<Native>;

/// A number for each pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(align(32))]
pub struct Lanes(pub(super) [f32; WIDTH]);

impl Lanes {
    /// The same for all.
    pub(super) const fn all(value: f32) -> Self {
        Self([value; WIDTH])
    }

    /// `step` of each pixel.
    #[inline(always)]
    pub(super) fn of(step: impl Fn(usize) -> f32) -> Self {
        let mut lanes = [0.0; WIDTH];
        for (i, lane) in lanes.iter_mut().enumerate() {
            *lane = step(i);
        }
        Self(lanes)
    }
}

/// The direction of one pixel.
#[inline(always)]
pub(super) fn one(direction: &Direction<Wide>, i: usize) -> Direction<One> {
    Direction::new(direction.x.0[i], direction.y.0[i], direction.z.0[i])
}

/// `step` of each pixel, for three numbers.
#[inline(always)]
pub(super) fn directions(step: impl Fn(usize) -> Direction<One>) -> Direction<Wide> {
    let mut found: Direction<Wide> =
        Direction::new(Lanes::default(), Lanes::default(), Lanes::default());
    for i in 0..WIDTH {
        let direction = step(i);
        found.x.0[i] = direction.x;
        found.y.0[i] = direction.y;
        found.z.0[i] = direction.z;
    }
    found
}
