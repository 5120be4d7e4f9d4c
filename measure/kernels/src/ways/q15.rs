//! 16-bit fixed point; the tables' size is each kernel's own.

use fixed::types::{I2F14, U0F32, U1F31, U2F30, U32F32};
use microbrdf::arithmetic::{Gain15, Q15};
use microbrdf::geometry::Direction;

#[cfg(not(target_os = "none"))]
pub use crate::call::Call::{ShortColour as Colour, ShortGrey as Grey, ShortWorld as World};
use crate::call::Short;

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
pub const fn gain(k: f64) -> Gain15 {
    Gain15::new(number(k))
}

/// How a direction is handed over: by value.
pub type Vector<'a> = Short;

/// A direction from its bits.
#[inline(always)]
pub fn direction<const KNOTS: usize>(Short { x, y, z }: Short) -> Direction<Q15<KNOTS>> {
    let [x, y, z] = [x, y, z].map(I2F14::from_bits);
    Direction::new(x, y, z)
}

/// A component's bits.
#[inline(always)]
pub fn bits(cosine: i32) -> u32 {
    cosine as u32
}
