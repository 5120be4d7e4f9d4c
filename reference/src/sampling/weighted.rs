//! Sampling of a product: directions of one factor, the other in the weight (4.7.2).

use super::{Sampled, Sampler};
use crate::{Brdf, Direction};

/// Directions of another sampler, with the weight f cosΘL/pdf of the model itself.
pub struct Weighted<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
    directions: Box<dyn Sampler + 'a>,
}

impl<'a> Weighted<'a> {
    /// `directions` must reach wherever the model is not 0, and have no Dirac part.
    pub fn new(brdf: &'a dyn Brdf, v: Direction, directions: Box<dyn Sampler + 'a>) -> Self {
        Self {
            brdf,
            v,
            directions,
        }
    }
}

impl Sampler for Weighted<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let direction = self.directions.sample(random)?.direction;
        let pdf = self.directions.pdf(&direction);
        let reflect = self.brdf.reflect(&direction, &self.v);
        let weight = reflect.map(|r| if r == 0.0 { 0.0 } else { r / pdf });
        Some(Sampled::spread(direction, weight))
    }

    fn pdf(&self, l: &Direction) -> f64 {
        self.directions.pdf(l)
    }
}
