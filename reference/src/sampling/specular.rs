//! Sampling of the ideal mirror (slides, specular reflection): its one direction.

use super::{Sampled, Sampler};
use crate::{Brdf, Direction};

/// The mirror direction, always, with the weight of the model's Dirac part.
pub struct Specular {
    v: Direction,
    weight: [f64; 3],
}

impl Specular {
    /// For the Dirac part of any model.
    pub fn new(brdf: &dyn Brdf, v: Direction) -> Self {
        Self {
            v,
            weight: brdf.delta_weight(&v),
        }
    }
}

impl Sampler for Specular {
    fn sample(&self, _random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        Some(Sampled::dirac(self.v.mirrored(), self.weight))
    }

    fn pdf(&self, _l: &Direction) -> f64 {
        0.0
    }

    fn dirac(&self) -> f64 {
        1.0
    }
}
