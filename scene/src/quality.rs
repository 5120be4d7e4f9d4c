//! Shadows and samples, chosen at run time.

use microbrdf::geometry::Direction;
use microbrdf::shade::{
    FourSamples, Light, Linear, OneSample, Placing, Samples, Shadowed, Shadows, Sphere,
};

/// Whether spheres throw shadows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnyShadows(pub bool);

impl Shadows for AnyShadows {
    fn hide<A: Placing>(
        self,
        spheres: &[Sphere<A>],
        place: impl Fn() -> A::Place,
        light: &impl Light<A>,
        l: &Direction<A>,
    ) -> bool {
        self.0 && Shadowed.hide(spheres, place, light, l)
    }
}

/// How many rays a pixel is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnySamples {
    /// One.
    One,
    /// Four.
    Four,
}

impl Samples for AnySamples {
    fn side(self) -> u16 {
        match self {
            Self::One => OneSample.side(),
            Self::Four => FourSamples.side(),
        }
    }

    fn pixel(self, x: usize, y: usize, seen: impl Fn(usize, usize) -> Linear) -> Linear {
        match self {
            Self::One => OneSample.pixel(x, y, seen),
            Self::Four => FourSamples.pixel(x, y, seen),
        }
    }
}
