//! Phong as first written, f = c (R·V)ⁿ/cosΘL (2.5): not symmetric, so not plausible.

use crate::error::within;
use crate::geometry::{below_horizon, power_lobe, versine};
use crate::models::EXPONENT_MAX;
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example};
use crate::models::phong::published_constant;
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};

/// The original Phong expression: its reflected radiance does not depend on cosΘL.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhongOriginal {
    exponent: f64,
    constant: f64,
}

impl PhongOriginal {
    /// Exponent 0 … 1e8, with reciprocal Phong's constant.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: published_constant(exponent),
        })
    }
}

impl Brdf for PhongOriginal {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let lobe = self.constant * power_lobe(self.exponent, versine(l, v));
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
        Chart::power(ChartKind::Mirror, self.exponent)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "phong_original",
    source: "(2.5)",
    formula: "c_n (R·V)ⁿ/cosΘL",
    parameters: "n 0 … 1e8",
    reciprocal: false,
    grazing: "albedo unbounded",
    examples: || {
        vec![example(
            "n = 20",
            PhongOriginal::new(20.0).expect("in range"),
            Exceeds,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_radiance_of_the_mirror_image_is_the_same_at_every_angle_but_not_symmetric() {
        let m = PhongOriginal::new(10.0).unwrap();
        let c = 12.0 / std::f64::consts::TAU;
        for degrees in [0.0, 60.0, 89.0] {
            let l = Direction::from_degrees(degrees, 0.0);
            assert!((m.reflect(&l, &l.mirrored())[0] / c - 1.0).abs() < 1e-12);
        }
        let (l, v) = (
            Direction::from_degrees(60.0, 0.0),
            Direction::from_degrees(40.0, 180.0),
        );
        assert!((m.eval(&l, &v) / m.eval(&v, &l) - v.z / l.z).abs() < 1e-12);
    }
}
