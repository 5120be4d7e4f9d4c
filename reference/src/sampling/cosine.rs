//! Sampling by the cosine alone, for any model: pdf = cosΘL/π.

use super::{Sampled, Sampler};
use crate::{Brdf, Direction};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// Uniform points of the base circle; the weight is π f.
pub struct Cosine<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
}

impl<'a> Cosine<'a> {
    /// For any model and V.
    pub fn new(brdf: &'a dyn Brdf, v: Direction) -> Self {
        Self { brdf, v }
    }
}

/// A uniform point of a disc of the given radius about the origin.
pub(super) fn disc(radius: f64, random: &mut dyn FnMut() -> f64) -> (f64, f64) {
    let r = radius * random().sqrt();
    let phi = TAU * random();
    (r * phi.cos(), r * phi.sin())
}

/// The direction above a point of the base circle (4.17).
pub(super) fn lifted(x: f64, y: f64) -> Direction {
    Direction::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt())
}

impl Sampler for Cosine<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let (x, y) = disc(1.0, random);
        let direction = lifted(x, y);
        let weight = self.brdf.eval_rgb(&direction, &self.v).map(|f| PI * f);
        Some(Sampled::spread(direction, weight))
    }

    fn pdf(&self, l: &Direction) -> f64 {
        l.z.max(0.0) * FRAC_1_PI
    }
}
