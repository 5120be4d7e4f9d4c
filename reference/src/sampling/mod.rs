//! Importance sampling: given V, directions L with a density, and the chi-square and
//! variance tests' material.
//!
//! A sampler is made for one V. It draws a direction, or rejects: then the radiance
//! counts 0, and that mass is missing from the density. `weight` is what the incoming
//! radiance is multiplied by.

mod cosine;
mod elliptic;
mod mixture;
mod patch;
mod phong_lobe;
mod random;
mod tobler;
mod variance;
mod weighted;

pub use cosine::Cosine;
pub use elliptic::Elliptic;
pub use mixture::{Mixture, MixtureMethod};
pub use patch::{PatchDisc, PatchMethod};
pub use phong_lobe::PhongLobe;
pub use random::Random;
pub use tobler::{ToblerLobe, ToblerProfile};
pub use variance::{Efficiency, efficiency, variance_table};
pub use weighted::Weighted;

use crate::Direction;

/// A direction that was drawn, and the factor of the radiance from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampled {
    /// The direction L.
    pub direction: Direction,
    /// Its weight: f cosΘL/pdf for each channel.
    pub weight: [f64; 3],
}

/// Draws directions for one V.
pub trait Sampler {
    /// A direction and its weight, or nothing where the sample is rejected.
    /// `random` gives independent numbers, uniform on 0 ≤ u < 1.
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled>;

    /// The density in sr⁻¹ of drawing L; its integral is 1 less the rejected mass.
    fn pdf(&self, l: &Direction) -> f64;
}
