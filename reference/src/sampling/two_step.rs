//! The printed sampler of patch mixtures (4.4), for comparison: one radius for all tries.

use super::patch::{PatchDisc, PatchMethod};
use super::{Sampled, Sampler};
use crate::Direction;
use crate::models::PatchExponential;
use crate::models::patch::lens_area;
use crate::quadrature::{Estimate, adaptive};
use std::f64::consts::FRAC_1_PI;

/// One radius, then points until one is accepted: the weights a_R vary between 0.39 and 1,
/// and the density is not f cosΘ/a.
pub struct TwoStep {
    model: PatchExponential,
    v: Direction,
}

impl TwoStep {
    /// For the exponential mixture.
    pub fn new(model: PatchExponential, v: Direction) -> Self {
        Self { model, v }
    }
}

impl Sampler for TwoStep {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let radius = self.model.inverse(random()).max(f64::MIN_POSITIVE);
        PatchDisc::new(radius, self.v, PatchMethod::Rejection).sample(random)
    }

    fn pdf(&self, l: &Direction) -> f64 {
        if l.z < 0.0 {
            return 0.0;
        }
        let m = crate::geometry::metric_squared(l, &self.v).sqrt();
        let mut breaks = vec![m.min(2.0), 2.0];
        if m < 1.0 {
            breaks.insert(1, 1.0);
        }
        let patches = adaptive(
            &mut |r| Estimate {
                value: self.model.density(r) / lens_area(r, self.v.z),
                error: 0.0,
            },
            &breaks,
            1e-9,
            50,
        );
        l.z * (patches.value + self.model.diffuse_weight() * FRAC_1_PI)
    }
}
