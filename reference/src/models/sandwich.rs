//! The sandwich of infinitely many lacquer layers, C f_base/(2 + k(1/NL + 1/NV))ⁿ (1.62, 1.63).

use crate::albedo::greatest_constant;
use crate::brdf::luminance;
use crate::error::within;
use crate::geometry::below_horizon;
use crate::models::Lambert;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::Chart;
use crate::{Brdf, Direction, ParameterError};

/// Any base model behind layers with ratio k (0 … 1000) and order n (0 … 100).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sandwich<B> {
    base: B,
    k: f64,
    order: f64,
    constant: f64,
}

impl<B: Brdf> Sandwich<B> {
    /// As printed, without the enhancing constant: at least 2ⁿ times darker than the base.
    pub fn printed(base: B, k: f64, order: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            base,
            k: within("k", k, 0.0, 1000.0)?,
            order: within("order", order, 0.0, 100.0)?,
            constant: 1.0,
        })
    }

    /// Multiplied by 1 over the greatest albedo, found numerically.
    pub fn enhanced(base: B, k: f64, order: f64) -> Result<Self, ParameterError> {
        let mut model = Self::printed(base, k, order)?;
        model.constant = greatest_constant(&model);
        Ok(model)
    }

    fn factor(&self, l: &Direction, v: &Direction) -> f64 {
        if self.k == 0.0 {
            return self.constant * 0.5f64.powf(self.order);
        }
        // Written so that a cosine of 0 gives 0.
        let product = l.z * v.z;
        let path = 2.0 * product + self.k * (l.z + v.z);
        if path == 0.0 {
            return 0.0;
        }
        self.constant * (product / path).powf(self.order)
    }
}

impl<B: Brdf> Brdf for Sandwich<B> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.is_coloured() {
            luminance(f)
        } else {
            f[0]
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let factor = self.factor(l, v);
        self.base
            .eval_rgb(l, v)
            .map(|f| if factor == 0.0 { 0.0 } else { factor * f })
    }

    fn is_coloured(&self) -> bool {
        self.base.is_coloured()
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.base.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.base.creases(l, v, out);
    }

    fn is_isotropic(&self) -> bool {
        self.base.is_isotropic()
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "sandwich",
    source: "(1.62), (1.63)",
    formula: "C f_base/(2 + k(1/NL + 1/NV))ⁿ",
    parameters: "k 0 … 1000; n 0 … 100; any base; printed or enhanced",
    reciprocal: true,
    grazing: "falls to 0 for k above 0",
    examples: || {
        let base = Lambert::grey(0.8).expect("in range");
        vec![example(
            "k = 0.5, n = 2 over Lambert",
            Sandwich::enhanced(base, 0.5, 2.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, models::Lambert};
    use std::f64::consts::FRAC_1_PI;

    #[test]
    fn the_value_is_the_printed_one() {
        let m = Sandwich::printed(Lambert::grey(1.0).unwrap(), 0.5, 2.0).unwrap();
        let (l, v) = (
            Direction::from_degrees(60.0, 0.0),
            Direction::from_degrees(0.0, 0.0),
        );
        // 1/NL + 1/NV = 3.
        assert!((m.eval(&l, &v) - FRAC_1_PI / 3.5f64.powi(2)).abs() < 1e-15);
        assert_eq!(m.eval(&l, &Direction::from_cosine(0.0, 0.0)), 0.0);
    }

    #[test]
    fn enhanced_reaches_one_at_the_normal() {
        let m = Sandwich::enhanced(Lambert::grey(0.6).unwrap(), 0.5, 3.0).unwrap();
        assert!((directional_albedo_at(&m, 0.0).value - 1.0).abs() < 1e-9);
        assert!(directional_albedo_at(&m, 50.0).value < 1.0);
    }
}
