//! Blinn divided by cosΘmin, f = C_n (N·H)ⁿ / max(NL, NV) (3.34).

use crate::albedo::{directional_albedo, greatest};
use crate::error::within;
use crate::geometry::{below_horizon, bounded_ratio, over_cos_theta_min};
use crate::half::Half;
use crate::models::EXPONENT_MAX;
use crate::models::blinn::half_chart;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::Chart;
use crate::{Brdf, Direction, ParameterError};

/// The corrected Blinn model with exponent n, 0 … 1e8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlinnCos {
    exponent: f64,
    constant: f64,
}

impl BlinnCos {
    /// With the greatest constant that conserves energy, found numerically below n = 4
    /// (from there on it is Blinn's own: the albedo is greatest at the normal).
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: Self::greatest_constant(exponent).0,
        })
    }

    /// The greatest constant, and the cosine at which its albedo reaches 1.
    pub fn greatest_constant(exponent: f64) -> (f64, f64) {
        let blinn = super::blinn::greatest_constant(exponent);
        if exponent >= 4.0 {
            return (blinn, 1.0);
        }
        let trial = Self {
            exponent,
            constant: blinn,
        };
        let (c, a) = greatest(&|c| directional_albedo(&trial, c).value);
        (blinn / a.max(1.0), c)
    }
}

impl Brdf for BlinnCos {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let lobe = Half::of(l, v).map_or(1.0, |h| h.cos_power(self.exponent));
        over_cos_theta_min(self.constant * lobe, l, v, 1.0)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let lobe = Half::of(l, v).map_or(1.0, |h| h.cos_power(self.exponent));
        [lobe * bounded_ratio(l, v, 1.0); 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        half_chart(self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(l.z - v.z);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "blinn_cos",
    source: "(3.34)",
    formula: "C_n (N·H)ⁿ / max(NL, NV)",
    parameters: "n 0 … 1e8",
    reciprocal: true,
    grazing: "radiance bounded by C_n; albedo still falls, N·H lobes are too wide there",
    examples: || {
        vec![
            example("n = 20", BlinnCos::new(20.0).expect("in range"), Conserves),
            example("n = 2", BlinnCos::new(2.0).expect("in range"), Conserves),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_constant_of_the_table_for_n_2_is_a_misprint() {
        // 0.364, not 0.368: with the latter the albedo reaches 1.0116.
        let (c, cosine) = BlinnCos::greatest_constant(2.0);
        assert!((c - 0.363_782_727_1).abs() < 1e-9, "{c}");
        assert!((cosine.acos().to_degrees() - 41.4).abs() < 0.1);
        let printed = BlinnCos {
            exponent: 2.0,
            constant: 0.368,
        };
        let a = directional_albedo(&printed, cosine).value;
        assert!((a - 1.0116).abs() < 1e-4, "{a}");
    }

    #[test]
    fn the_albedo_never_exceeds_one_for_larger_exponents() {
        for n in [4.0, 5.0, 16.0, 300.0] {
            let m = BlinnCos::new(n).unwrap();
            for degrees in [0.0, 1.0, 5.0, 20.0, 45.0, 80.0] {
                let a = directional_albedo_at(&m, degrees);
                assert!(a.value <= 1.0 + 1e-10, "n = {n}, {degrees}: {a:?}");
            }
        }
    }
}
