//! Tobler's power form, f = 2(n + 1)/π (R_S·V_S)⁺ⁿ (1.71 as corrected).

use crate::error::within;
use crate::geometry::{below_horizon, power_lobe};
use crate::models::EXPONENT_MAX;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{ToblerLobe, ToblerProfile};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::FRAC_1_PI;

/// m = 1 − R_S·V_S (1.70), with the directions doubled onto the inscribed sphere (1.69);
/// half the squared length of the difference, so that nothing cancels.
pub(crate) fn sphere_metric(l: &Direction, v: &Direction) -> f64 {
    let (x, y) = (l.z * l.x + v.z * v.x, l.z * l.y + v.z * v.y);
    let z = (l.z - v.z) * (l.z + v.z);
    2.0 * (x * x + y * y + z * z)
}

/// Tobler's power model with exponent n, 0 … 1e8. The albedo is 1 at every angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToblerPower {
    exponent: f64,
    constant: f64,
}

impl ToblerPower {
    /// With the constant that makes the albedo 1.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: 2.0 * (exponent + 1.0) * FRAC_1_PI,
        })
    }

    /// The exponent n.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl Brdf for ToblerPower {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * power_lobe(self.exponent, sphere_metric(l, v))
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Mirror, 0.4 / (self.exponent + 1.0).sqrt())
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(1.0 - sphere_metric(l, v));
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "tobler_power",
    source: "(1.69) to (1.71)",
    formula: "2(n + 1)/π (R_S·V_S)⁺ⁿ",
    parameters: "n 0 … 1e8",
    reciprocal: true,
    grazing: "albedo 1 at every angle",
    examples: || {
        vec![example(
            "n = 10",
            ToblerPower::new(10.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = ToblerPower::new(10.0).expect("in range");
        visit(&m, &ToblerLobe::new(ToblerProfile::Power(m), v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_albedo_is_one_at_every_angle() {
        for n in [1.0, 4.0, 40.0] {
            let m = ToblerPower::new(n).unwrap();
            for degrees in [0.0, 30.0, 60.0, 85.0] {
                let a = directional_albedo_at(&m, degrees);
                assert!((a.value - 1.0).abs() < 1e-8, "n = {n}, {degrees}: {a:?}");
            }
        }
    }

    #[test]
    fn the_metric_is_the_printed_product() {
        let (l, v) = (
            Direction::from_degrees(35.0, 20.0),
            Direction::from_degrees(50.0, 150.0),
        );
        let doubled =
            |d: Direction| Direction::new(2.0 * d.z * d.x, 2.0 * d.z * d.y, 2.0 * d.z * d.z - 1.0);
        let expected = 1.0 - doubled(l.mirrored()).dot(doubled(v));
        assert!((sphere_metric(&l, &v) - expected).abs() < 1e-14);
    }
}
