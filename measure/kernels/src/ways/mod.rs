//! The core's arithmetics, each with its constructors fed by constants, and
//! how its directions are handed over.

pub mod f32;
pub mod micromath;
pub mod q15;
pub mod q31;

/// A number times 2^`bits`.
const fn scaled(value: f64, bits: u32) -> u64 {
    (value * (1u64 << bits) as f64 + 0.5) as u64
}
