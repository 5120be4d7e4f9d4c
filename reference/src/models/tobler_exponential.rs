//! Tobler's exponential form, f = 2s/(π(1 − e^(−2s))) e^(−s·m) (1.72 as corrected).

use super::tobler_power::sphere_metric;
use crate::error::within;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{ToblerLobe, ToblerProfile};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::FRAC_1_PI;

/// Tobler's exponential model with sharpness s, 0 … 1e8; s = 0 is Lambert.
/// The albedo is 1 at every angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToblerExponential {
    sharpness: f64,
    constant: f64,
}

impl ToblerExponential {
    /// With the constant that makes the albedo 1.
    pub fn new(sharpness: f64) -> Result<Self, ParameterError> {
        let s = within("sharpness", sharpness, 0.0, 1e8)?;
        let constant = if s == 0.0 {
            FRAC_1_PI
        } else {
            -2.0 * s * FRAC_1_PI / (-2.0 * s).exp_m1()
        };
        Ok(Self {
            sharpness: s,
            constant,
        })
    }

    /// The sharpness s.
    pub fn sharpness(&self) -> f64 {
        self.sharpness
    }
}

impl Brdf for ToblerExponential {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * (-self.sharpness * sphere_metric(l, v)).exp()
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Mirror, 0.4 / (self.sharpness + 1.0).sqrt())
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "tobler_exponential",
    source: "(1.69), (1.70), (1.72)",
    formula: "2s/(π(1 − e^(−2s))) e^(−s(1 − R_S·V_S))",
    parameters: "s 0 … 1e8",
    reciprocal: true,
    grazing: "albedo 1 at every angle; the lobe becomes a ring at the horizon",
    examples: || {
        vec![example(
            "s = 10",
            ToblerExponential::new(10.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = ToblerExponential::new(10.0).expect("in range");
        visit(&m, &ToblerLobe::new(ToblerProfile::Exponential(m), v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_albedo_is_one_at_every_angle() {
        for s in [0.0, 1e-6, 1.0, 30.0] {
            let m = ToblerExponential::new(s).unwrap();
            for degrees in [0.0, 45.0, 80.0, 90.0] {
                let a = directional_albedo_at(&m, degrees);
                assert!((a.value - 1.0).abs() < 1e-9, "s = {s}, {degrees}: {a:?}");
            }
        }
    }
}
