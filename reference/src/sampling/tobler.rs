//! Sampling of Tobler's models on the inscribed sphere: all weights are 1.

use super::phong_lobe::around;
use super::{Sampled, Sampler};
use crate::models::{ToblerExponential, ToblerPower};
use crate::{Brdf, Direction};
use std::f64::consts::TAU;

/// Which of the two models.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToblerProfile {
    /// (1.71).
    Power(ToblerPower),
    /// (1.72).
    Exponential(ToblerExponential),
}

/// Doubled directions drawn about the doubled R of V, then halved. Since the doubled
/// solid angle is 4 cosΘ dω, the density is f cosΘ exactly.
pub struct ToblerLobe {
    profile: ToblerProfile,
    v: Direction,
}

impl ToblerLobe {
    /// For one of the models.
    pub fn new(profile: ToblerProfile, v: Direction) -> Self {
        Self { profile, v }
    }
}

impl Sampler for ToblerLobe {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let u = random();
        // m = 1 − R_S·L_S, 0 … 2 (0 … 1 for the power).
        let m = match self.profile {
            ToblerProfile::Power(p) => -((1.0 - u).ln() / (p.exponent() + 1.0)).exp_m1(),
            ToblerProfile::Exponential(e) => {
                let s = e.sharpness();
                if s == 0.0 {
                    2.0 * u
                } else {
                    -(u * (-2.0 * s).exp_m1()).ln_1p() / s
                }
            }
        };
        let r = self.v.mirrored();
        let axis = Direction::new(2.0 * r.z * r.x, 2.0 * r.z * r.y, 2.0 * r.z * r.z - 1.0);
        let sine = (m * (2.0 - m)).max(0.0).sqrt();
        let doubled = around(axis, m, sine, TAU * random());
        let direction = Direction::new(doubled.x, doubled.y, doubled.z + 1.0).normalised();
        Some(Sampled::spread(direction, [1.0; 3]))
    }

    fn pdf(&self, l: &Direction) -> f64 {
        let f = match self.profile {
            ToblerProfile::Power(p) => p.eval(l, &self.v),
            ToblerProfile::Exponential(e) => e.eval(l, &self.v),
        };
        f * l.z
    }
}
