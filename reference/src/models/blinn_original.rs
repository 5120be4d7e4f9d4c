//! Blinn as first written, f = C (N·H)ⁿ/cosΘL (2.5): not symmetric, so not plausible.

use crate::error::within;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::EXPONENT_MAX;
use crate::models::blinn::{greatest_constant, half_chart};
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::Chart;
use crate::{Brdf, Direction, ParameterError};

/// The original Blinn expression, with the reciprocal form's constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlinnOriginal {
    exponent: f64,
    constant: f64,
}

impl BlinnOriginal {
    /// Exponent 0 … 1e8.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: greatest_constant(exponent),
        })
    }
}

impl Brdf for BlinnOriginal {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let lobe = self.constant * Half::of(l, v).map_or(1.0, |h| h.cos_power(self.exponent));
        if lobe == 0.0 {
            0.0
        } else {
            (lobe / l.z).min(f64::MAX)
        }
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
    name: "blinn_original",
    source: "(2.5)",
    formula: "C_n (N·H)ⁿ / cosΘL",
    parameters: "n 0 … 1e8",
    reciprocal: false,
    grazing: "albedo unbounded",
    examples: || {
        vec![example(
            "n = 20",
            BlinnOriginal::new(20.0).expect("in range"),
            Exceeds,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Blinn;

    #[test]
    fn it_is_blinn_over_the_cosine_of_the_light() {
        let (a, b) = (BlinnOriginal::new(6.0).unwrap(), Blinn::new(6.0).unwrap());
        let (l, v) = (
            Direction::from_degrees(60.0, 0.0),
            Direction::from_degrees(40.0, 170.0),
        );
        assert!((a.eval(&l, &v) * l.z / b.eval(&l, &v) - 1.0).abs() < 1e-14);
    }
}
