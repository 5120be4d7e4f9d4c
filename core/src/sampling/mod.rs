//! Importance sampling: directions for a V that are drawn as a model reflects.
//!
//! A sampler is a model with the few constants that drawing needs; a scene
//! that only evaluates models links nothing of it. It takes V in the shading
//! frame and two independent random numbers, and gives a direction L with its
//! weight f·cosΘL / pdf, which is what the radiance from L is multiplied by.
//! It never tries again: where a try misses the hemisphere or the patch, the
//! sample is rejected (Russian roulette), counts 0, and that mass is missing
//! from the density, whose integral is 1 less what is rejected. So the work
//! is bounded, and the mean of weight times radiance has no bias.
//!
//! By reciprocity V may as well be the direction to the light, and L the one
//! to the viewer.
//!
//! ```
//! use microbrdf::arithmetic::Q31;
//! use microbrdf::fixed::types::{I2F30, U0F32, U32F32};
//! use microbrdf::geometry::Direction;
//! use microbrdf::sampling::{MetallicPhongSampler, Sample};
//!
//! static STEEL: MetallicPhongSampler<Q31> =
//!     microbrdf::constant!(MetallicPhongSampler::<Q31>::new(U32F32::lit("40")));
//!
//! let v = Direction::new(I2F30::lit("0.6"), I2F30::ZERO, I2F30::lit("0.8"));
//! // Two words of a random number generator.
//! let random = [0x1234_5678, 0x9ABC_DEF0].map(U0F32::from_bits);
//! let drawn = STEEL.sample(&v, random).expect("above the horizon");
//! assert!(STEEL.pdf(&drawn.direction, &v) > 0);
//! assert!(drawn.weight.r > U32F32::lit("0.9"));
//! ```

mod exponential;
mod f32;
mod lambert;
mod logarithm;
mod metal;
mod patch;
mod patch_exponential;
mod phong;
mod q31;
mod reciprocal;
mod steps;
mod turn;

pub use metal::MetalSampler;
pub use patch::PatchSampler;
pub use patch_exponential::PatchExponentialSampler;
pub use phong::{
    LobeAxis, MetallicPhongSampler, PModelSampler, PhongLobeSampler, PhongSampler,
    RetroPhongSampler,
};
pub use q31::{Cap31, Spread31};
pub use reciprocal::Reciprocal;
pub use steps::Sampling;

use crate::arithmetic::Arithmetic;
use crate::colour::Rgb;
use crate::geometry::Direction;

/// A direction that was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn<A: Arithmetic> {
    /// L in the shading frame, a unit vector as V is.
    pub direction: Direction<A>,
    /// f·cosΘL / pdf per channel, at most 2: what the radiance from L is
    /// multiplied by.
    pub weight: Rgb<A::Radiance>,
}

/// Draws directions for one V in the shading frame.
pub trait Sample<A: Sampling> {
    /// A direction L and its weight, from two independent random numbers,
    /// uniform on [0, 1); `None` where the sample is rejected and counts 0.
    ///
    /// A V below the horizon gets `None`; a V that is not finite, in `f32`,
    /// `None` or a weight of 0. The density drawn is within 2e-5 of
    /// [`Self::pdf`], relatively, and a mean over all samples is the model's
    /// albedo; tested by chi-square in `tests/tests/sampling.rs`.
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>>;

    /// The density in sr⁻¹ of drawing L, 0 below the horizon; its error is
    /// that of the model's lobe. Its integral is 1 less the mass that is
    /// rejected.
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance;
}
