//! Single precision.

use microbrdf::arithmetic::{Float, Math};
use microbrdf::geometry::Direction;

#[cfg(not(target_os = "none"))]
pub use crate::call::Call::{Colour, Grey, World};
pub use crate::call::Vector;

/// An exponent or a sharpness.
pub const fn number(value: f64) -> f32 {
    value as f32
}

/// An albedo or another share.
pub const fn share(value: f64) -> f32 {
    value as f32
}

/// The p of the p-model.
pub const fn p(value: f64) -> f32 {
    value as f32
}

/// A radius.
pub const fn radius(value: f64) -> f32 {
    value as f32
}

/// A gain.
pub const fn gain(k: f64) -> f32 {
    k as f32
}

/// A direction from its bits.
#[inline(always)]
pub fn direction<M: Math>(&[x, y, z]: Vector<'_>) -> Direction<Float<M>> {
    Direction::new(f32::from_bits(x), f32::from_bits(y), f32::from_bits(z))
}

/// A component's bits.
#[inline(always)]
pub fn bits(component: f32) -> u32 {
    component.to_bits()
}
