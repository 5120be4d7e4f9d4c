//! Where single precision takes its exponentials and roots from.

mod libm;
#[cfg(feature = "micromath")]
mod micromath;

pub use self::libm::Libm;
#[cfg(feature = "micromath")]
pub use self::micromath::{Approximate, Micromath};

use core::fmt::Debug;

/// The functions that are not mere sums, products and quotients.
///
/// Their names are none of the standard library's, whose inherent methods
/// would be called in their place on a host.
pub trait Math: Copy + Debug + PartialEq + 'static {
    /// Name of the arithmetic that is made with it.
    const NAME: &'static str;

    /// eʸ.
    fn exp(y: f32) -> f32;
    /// ln(1 − x) for x < 1, keeping the digits of a small x.
    fn ln_one_minus(x: f32) -> f32;
    /// √y for y ≥ 0.
    fn root(y: f32) -> f32;
    /// cosineᵉ for a cosine above 0 and an exponent in [0, 1].
    fn power(cosine: f32, exponent: f32) -> f32;
}
