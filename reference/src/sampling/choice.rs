//! Sampling of sums: one part is chosen, then a direction of it (5.2.5).

use super::{Sampled, Sampler};
use crate::{Brdf, Direction};

/// Directions of several samplers in given shares, with the weight f cosΘL/pdf of the whole
/// model, the density being that of all parts together.
pub struct Choice<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
    parts: Vec<(f64, Box<dyn Sampler + 'a>)>,
    /// The weight of a Dirac outcome.
    mirror: [f64; 3],
}

impl<'a> Choice<'a> {
    /// Shares need not add up to 1, but one must be above 0. The parts must together reach
    /// wherever the model is not 0.
    pub fn new(
        brdf: &'a dyn Brdf,
        v: Direction,
        mut parts: Vec<(f64, Box<dyn Sampler + 'a>)>,
    ) -> Self {
        parts.retain(|(share, _)| *share > 0.0);
        let sum: f64 = parts.iter().map(|(share, _)| share).sum();
        for (share, _) in &mut parts {
            *share /= sum;
        }
        let mut choice = Self {
            brdf,
            v,
            parts,
            mirror: [0.0; 3],
        };
        let dirac = choice.dirac();
        if dirac > 0.0 {
            choice.mirror = brdf.delta_weight(&v).map(|w| w / dirac);
        }
        choice
    }

    fn sum(&self, f: impl Fn(&dyn Sampler) -> f64) -> f64 {
        (self.parts.iter())
            .map(|(share, part)| share * f(part.as_ref()))
            .sum()
    }
}

impl Sampler for Choice<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let mut u = random();
        let chosen = self.parts.iter().find(|(share, _)| {
            u -= share;
            u < 0.0
        });
        // Rounding may leave a step of 1e-16 above the last.
        let (_, part) = chosen.or(self.parts.last())?;
        let sampled = part.sample(random)?;
        if sampled.is_dirac {
            return Some(Sampled::dirac(sampled.direction, self.mirror));
        }
        let pdf = self.pdf(&sampled.direction);
        let reflect = self.brdf.reflect(&sampled.direction, &self.v);
        let weight = reflect.map(|r| if r == 0.0 { 0.0 } else { r / pdf });
        Some(Sampled::spread(sampled.direction, weight))
    }

    fn pdf(&self, l: &Direction) -> f64 {
        self.sum(|part| part.pdf(l))
    }

    fn dirac(&self) -> f64 {
        self.sum(|part| part.dirac())
    }
}
