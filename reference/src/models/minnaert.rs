//! Minnaert, f = (k + 2)/2π (NL·NV)ᵏ (1.32), with the plausible normalisation for k ≥ 0.

use crate::error::within;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::TAU;

/// Minnaert with exponent k, 0 … 100; k = 0 is Lambert.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Minnaert {
    k: f64,
    constant: f64,
}

impl Minnaert {
    /// With the constant (k + 2)/2π: the albedo is cosᵏΘ, 1 at the normal.
    ///
    /// Negative k (the moon: −0.4 … −0.2) can't conserve energy with any constant and is refused.
    pub fn new(k: f64) -> Result<Self, ParameterError> {
        let k = within("k", k, 0.0, 100.0)?;
        Ok(Self {
            k,
            constant: (k + 2.0) / TAU,
        })
    }
}

impl Brdf for Minnaert {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * (l.z * v.z).powf(self.k)
    }

    fn peak(&self) -> f64 {
        self.constant
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "minnaert",
    source: "(1.31), (1.32)",
    formula: "(k + 2)/2π (NL·NV)ᵏ",
    parameters: "k 0 … 100",
    reciprocal: true,
    grazing: "albedo cosᵏΘ; negative k is refused, its albedo is unbounded",
    examples: || {
        vec![example(
            "k = 1",
            Minnaert::new(1.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo;

    #[test]
    fn the_albedo_is_a_power_of_the_cosine() {
        for k in [0.0, 0.5, 1.0, 7.0] {
            let m = Minnaert::new(k).unwrap();
            for c in [0.05, 0.5, 1.0] {
                let a = directional_albedo(&m, c);
                assert!(
                    (a.value - f64::powf(c, k)).abs() < 1e-10,
                    "k = {k}, {c}: {a:?}"
                );
            }
        }
        assert_eq!(Minnaert::new(-0.2).unwrap_err().parameter, "k");
    }
}
