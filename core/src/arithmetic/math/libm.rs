//! The functions of libm, in software: the same bits on every core.

use super::Math;

/// libm's functions, each within about one step of its result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Libm;

impl Math for Libm {
    const NAME: &'static str = "f32";

    #[inline]
    fn exp(y: f32) -> f32 {
        libm::expf(y)
    }

    #[inline]
    fn ln_one_minus(x: f32) -> f32 {
        libm::log1pf(-x)
    }

    #[inline]
    fn root(y: f32) -> f32 {
        libm::sqrtf(y)
    }

    #[inline]
    fn power(cosine: f32, exponent: f32) -> f32 {
        libm::powf(cosine, exponent)
    }
}
