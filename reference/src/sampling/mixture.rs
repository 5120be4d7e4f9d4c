//! Sampling of mixtures of patches by any density of radii (4.4), as corrected.

use super::ball::Ball;
use super::radii::Radii;
use super::{Sampled, Sampler};
use crate::models::{Metric, PatchExponential};
use crate::quadrature::Accuracy;
use crate::{Brdf, Direction, albedo};

/// What happens to a point that misses its patch or the base circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MixtureMethod {
    /// A new radius with every new point: the density is f cosΘ/a exactly, all weights are a(V).
    Redraw,
    /// One radius, one point: accepted, with the mass of the radii as weight, or rejected.
    Roulette,
}

/// Directions of a model that is a mixture of patches in one metric.
pub struct Mixture<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
    metric: Metric,
    radii: Box<dyn Radii + 'a>,
    method: MixtureMethod,
    /// a(V) for `Redraw`, the mass for `Roulette`.
    weight: f64,
    mirror: f64,
}

impl<'a> Mixture<'a> {
    /// `radii` must be those of the model; finds a(V) by quadrature.
    pub fn new(
        brdf: &'a dyn Brdf,
        metric: Metric,
        radii: impl Radii + 'a,
        v: Direction,
        method: MixtureMethod,
    ) -> Self {
        let weight = match method {
            MixtureMethod::Redraw => albedo::directional_albedo_for(brdf, &v, Accuracy::FINE).value,
            MixtureMethod::Roulette => radii.mass(),
        };
        Self {
            brdf,
            v,
            metric,
            radii: Box::new(radii),
            method,
            weight,
            mirror: brdf.delta_weight(&v)[0],
        }
    }

    /// Of the exponential mixture.
    pub fn exponential(model: &'a PatchExponential, v: Direction, method: MixtureMethod) -> Self {
        Self::new(model, Metric::EUCLIDEAN, *model, v, method)
    }

    fn attempt(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let radius = self.radii.draw(random);
        let weight = [self.weight; 3];
        if radius == 0.0 {
            return Some(Sampled::dirac(self.v.mirrored(), weight));
        }
        let direction = Ball::new(self.metric, radius, self.v).attempt(random)?;
        Some(Sampled::spread(direction, weight))
    }
}

impl Sampler for Mixture<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        match self.method {
            MixtureMethod::Redraw => loop {
                if let Some(sampled) = self.attempt(random) {
                    return Some(sampled);
                }
            },
            MixtureMethod::Roulette => self.attempt(random),
        }
    }

    fn pdf(&self, l: &Direction) -> f64 {
        self.brdf.eval(l, &self.v) * l.z.max(0.0) / self.weight
    }

    fn dirac(&self) -> f64 {
        self.mirror / self.weight
    }
}
