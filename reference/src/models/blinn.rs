//! Blinn, f = C_n (N·H)ⁿ (1.34, 3.33), with the greatest constant in closed form.

use crate::error::within;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::EXPONENT_MAX;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// C_n = (n + 2)(n + 4)/(8π(n + 2^(−n/2))): albedo 1 at the normal.
pub fn greatest_constant(exponent: f64) -> f64 {
    let n = exponent;
    (n + 2.0) * (n + 4.0) / (8.0 * PI * (n + (-0.5 * n).exp2()))
}

/// Blinn with exponent n, 0 … 1e8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blinn {
    exponent: f64,
    constant: f64,
}

impl Blinn {
    /// With the greatest constant that conserves energy.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: greatest_constant(exponent),
        })
    }

    /// The albedo at exactly 90°, 1/(n + 2^(−n/2)).
    pub fn grazing_albedo(exponent: f64) -> f64 {
        1.0 / (exponent + (-0.5 * exponent).exp2())
    }

    /// The mean albedo, (n + 2)/(2(n + 2^(−n/2))).
    pub fn exact_mean_albedo(exponent: f64) -> f64 {
        (exponent + 2.0) / (2.0 * (exponent + (-0.5 * exponent).exp2()))
    }
}

/// The chart of a lobe cosⁿδ about the half vector.
pub(crate) fn half_chart(exponent: f64) -> Chart {
    Chart::new(ChartKind::Half, 1.0 / (exponent + 1.0).sqrt())
}

impl Brdf for Blinn {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        // At L = −V the half vector is taken to be N.
        self.constant * Half::of(l, v).map_or(1.0, |h| h.cos_power(self.exponent))
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        half_chart(self.exponent)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "blinn",
    source: "(1.34), (3.33), constant in closed form",
    formula: "C_n (N·H)ⁿ, C_n = (n + 2)(n + 4)/(8π(n + 2^(−n/2)))",
    parameters: "n 0 … 1e8",
    reciprocal: true,
    grazing: "albedo falls to 1/(n + 2^(−n/2)), radiance to 0",
    examples: || {
        vec![example(
            "n = 20",
            Blinn::new(20.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, mean_albedo};

    #[test]
    fn closed_forms_hold() {
        for n in [0.0, 1.0, 2.0, 5.5, 32.0, 512.0, 1e5] {
            let m = Blinn::new(n).unwrap();
            let normal = directional_albedo_at(&m, 0.0);
            assert!((normal.value - 1.0).abs() < 1e-10, "n = {n}: {normal:?}");
            let grazing = directional_albedo_at(&m, 90.0);
            let exact = Blinn::grazing_albedo(n);
            assert!(
                (grazing.value - exact).abs() < 1e-10,
                "n = {n}: {grazing:?} {exact}"
            );
        }
        let mean = mean_albedo(&Blinn::new(8.0).unwrap());
        assert!(
            (mean.value - Blinn::exact_mean_albedo(8.0)).abs() < 1e-9,
            "{mean:?}"
        );
    }
}
