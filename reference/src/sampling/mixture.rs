//! Sampling of patch mixtures (4.4), as printed and as corrected.

use super::patch::{PatchDisc, PatchMethod};
use super::{Sampled, Sampler};
use crate::models::PatchExponential;
use crate::quadrature::{Accuracy, Estimate, adaptive};
use crate::{Brdf, Direction, albedo};
use std::f64::consts::FRAC_1_PI;

/// How a radius and a point are put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MixtureMethod {
    /// A new radius with every new point: the density is f cosΘ/a exactly, all weights are a(V).
    Redraw,
    /// As printed: one radius, then points until one is accepted. Its weights a_R vary
    /// between 0.39 and 1, and its density is not f cosΘ/a.
    TwoStep,
    /// One radius, one point: accepted with weight 1 or rejected.
    Roulette,
}

/// Directions of the exponential patch model.
pub struct Mixture {
    model: PatchExponential,
    v: Direction,
    method: MixtureMethod,
    albedo: f64,
}

impl Mixture {
    /// Finds a(V) by quadrature.
    pub fn new(model: PatchExponential, v: Direction, method: MixtureMethod) -> Self {
        let albedo = albedo::directional_albedo_for(&model, &v, Accuracy::FINE).value;
        Self {
            model,
            v,
            method,
            albedo,
        }
    }

    /// a(V).
    pub fn albedo(&self) -> f64 {
        self.albedo
    }

    fn patch(&self, random: &mut dyn FnMut() -> f64) -> PatchDisc {
        // The inverse returns 2, Lambert, for the mass of the diffuse part.
        let radius = self.model.inverse(random());
        PatchDisc::new(radius.max(1e-300), self.v, PatchMethod::Rejection)
    }
}

impl Sampler for Mixture {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        match self.method {
            MixtureMethod::Redraw => loop {
                if let Some(direction) = self.patch(random).attempt(random) {
                    return Some(Sampled {
                        direction,
                        weight: [self.albedo; 3],
                    });
                }
            },
            MixtureMethod::TwoStep => self.patch(random).sample(random),
            MixtureMethod::Roulette => {
                let direction = self.patch(random).attempt(random)?;
                Some(Sampled {
                    direction,
                    weight: [1.0; 3],
                })
            }
        }
    }

    fn pdf(&self, l: &Direction) -> f64 {
        if l.z < 0.0 {
            return 0.0;
        }
        let roulette = self.model.eval(l, &self.v) * l.z;
        match self.method {
            MixtureMethod::Redraw => roulette / self.albedo,
            MixtureMethod::Roulette => roulette,
            MixtureMethod::TwoStep => {
                let m = crate::geometry::metric_squared(l, &self.v).sqrt();
                let mut breaks = vec![m.min(2.0), 2.0];
                if m < 1.0 {
                    breaks.insert(1, 1.0);
                }
                let cos = self.v.z;
                let patches = adaptive(
                    &mut |r| Estimate {
                        value: self.model.density(r) / crate::models::patch::lens_area(r, cos),
                        error: 0.0,
                    },
                    &breaks,
                    1e-9,
                    50,
                );
                l.z * (patches.value + self.model.diffuse_weight() * FRAC_1_PI)
            }
        }
    }
}
