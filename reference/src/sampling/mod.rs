//! Importance sampling: given V, directions L with a density, and the chi-square and
//! variance tests' material.
//!
//! A sampler is made for one V. It draws a direction, or rejects: then the radiance
//! counts 0, and that mass is missing from the density. `weight` is what the incoming
//! radiance is multiplied by.

mod ball;
mod choice;
mod cosine;
mod inverse;
mod mixture;
mod patch;
mod phong_lobe;
mod radii;
mod random;
mod specular;
mod tobler;
mod two_step;
mod variance;
mod weighted;

pub use ball::MetricPatch;
pub use choice::Choice;
pub use cosine::Cosine;
pub use mixture::{Mixture, MixtureMethod};
pub use patch::{PatchDisc, PatchMethod};
pub use phong_lobe::PhongLobe;
pub use radii::{DensityRadii, ProfileRadii, Radii};
pub use random::Random;
pub use specular::Specular;
pub use tobler::{ToblerLobe, ToblerProfile};
pub use two_step::TwoStep;
pub use variance::{Efficiency, efficiency, variance_table};
pub use weighted::Weighted;

use crate::Direction;

/// A direction that was drawn, and the factor of the radiance from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampled {
    /// The direction L.
    pub direction: Direction,
    /// Its weight: f cosΘL/pdf for each channel; of a Dirac part its weight over its
    /// probability.
    pub weight: [f64; 3],
    /// Whether it is the mirror direction of a Dirac part, which the density leaves out.
    pub is_dirac: bool,
}

impl Sampled {
    /// A direction from a density.
    pub fn spread(direction: Direction, weight: [f64; 3]) -> Self {
        Self {
            direction,
            weight,
            is_dirac: false,
        }
    }

    /// The direction of a Dirac part.
    pub fn dirac(direction: Direction, weight: [f64; 3]) -> Self {
        Self {
            direction,
            weight,
            is_dirac: true,
        }
    }
}

/// Draws directions for one V.
pub trait Sampler {
    /// A direction and its weight, or nothing where the sample is rejected.
    /// `random` gives independent numbers, uniform on 0 ≤ u < 1.
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled>;

    /// The density in sr⁻¹ of drawing L; its integral is 1 less the rejected mass and
    /// [`Self::dirac`].
    fn pdf(&self, l: &Direction) -> f64;

    /// The probability of the Dirac part's direction, 0 for most.
    fn dirac(&self) -> f64 {
        0.0
    }
}
