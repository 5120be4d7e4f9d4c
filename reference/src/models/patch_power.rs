//! The power patch, f = (n + 1)(n + 2)/2π ((1 − m)⁺)ⁿ (5.12).

use crate::error::within;
use crate::geometry::{below_horizon, metric_squared};
use crate::models::Metric;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{Mixture, MixtureMethod, ProfileRadii};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::TAU;

/// The patch analogue of Phong's power, exponent 0 … 1e8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchPower {
    exponent: f64,
    constant: f64,
}

impl PatchPower {
    /// With the greatest constant: albedo 1 at the normal.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let n = within("exponent", exponent, 0.0, 1e8)?;
        Ok(Self {
            exponent: n,
            constant: (n + 1.0) * (n + 2.0) / TAU,
        })
    }

    fn lobe(&self, l: &Direction, v: &Direction) -> f64 {
        let m = metric_squared(l, v).sqrt();
        if m >= 1.0 {
            0.0
        } else {
            (self.exponent * (-m).ln_1p()).exp()
        }
    }
}

impl Brdf for PatchPower {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            0.0
        } else {
            self.constant * self.lobe(l, v)
        }
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            [0.0; 3]
        } else {
            [self.lobe(l, v) * l.z; 3]
        }
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, 2.0 / (self.exponent + 2.0)).with_edges(&[1.0])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_power",
    source: "(5.12)",
    formula: "(n + 1)(n + 2)/2π ((1 − m)⁺)ⁿ",
    parameters: "n 0 … 1e8",
    reciprocal: true,
    grazing: "f bounded; albedo about ½ at the horizon",
    examples: || {
        vec![example(
            "n = 12",
            PatchPower::new(12.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = PatchPower::new(12.0).expect("in range");
        for method in [MixtureMethod::Redraw, MixtureMethod::Roulette] {
            let profile = |x: f64| (1.0 - x).max(0.0).powf(m.exponent);
            let radii = ProfileRadii::new(Metric::EUCLIDEAN, profile, m.constant);
            visit(&m, &Mixture::new(&m, Metric::EUCLIDEAN, radii, v, method));
        }
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, models::Patch};

    #[test]
    fn the_albedo_is_one_at_the_normal_and_n_0_is_the_unit_patch() {
        for n in [0.0, 1.0, 20.0, 1e5] {
            let a = directional_albedo_at(&PatchPower::new(n).unwrap(), 0.0);
            assert!((a.value - 1.0).abs() < 1e-10, "n = {n}: {a:?}");
        }
        let (a, b) = (PatchPower::new(0.0).unwrap(), Patch::new(1.0).unwrap());
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(60.0, 150.0),
        );
        assert!((a.eval(&l, &v) - b.eval(&l, &v)).abs() < 1e-15);
    }
}
