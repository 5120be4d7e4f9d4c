//! 32-bit fixed point; the tables' size is each kernel's own.

use fixed::types::{I2F30, U0F32, U1F31, U2F30, U32F32};
use microbrdf::arithmetic::{Gain31, Q31};
use microbrdf::geometry::Direction;

#[cfg(not(target_os = "none"))]
pub use crate::call::Call::{Colour, Grey, World};
pub use crate::call::Vector;

use super::scaled;

/// An exponent or a sharpness.
pub const fn number(value: f64) -> U32F32 {
    U32F32::from_bits(scaled(value, 32))
}

/// An albedo or another share.
pub const fn share(value: f64) -> U1F31 {
    U1F31::from_bits(scaled(value, 31) as u32)
}

/// The p of the p-model.
pub const fn p(value: f64) -> U0F32 {
    U0F32::from_bits(scaled(value, 32) as u32)
}

/// A radius.
pub const fn radius(value: f64) -> U2F30 {
    U2F30::from_bits(scaled(value, 30) as u32)
}

/// A gain.
pub const fn gain(k: f64) -> Gain31 {
    Gain31::new(number(k))
}

/// A direction from its bits.
#[inline(always)]
pub fn direction<const CELLS: usize>(&[x, y, z]: Vector<'_>) -> Direction<Q31<CELLS>> {
    let component = |bits: u32| I2F30::from_bits(bits as i32);
    Direction::new(component(x), component(y), component(z))
}

/// A component's bits.
#[inline(always)]
pub fn bits(component: I2F30) -> u32 {
    component.to_bits() as u32
}
