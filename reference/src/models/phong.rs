//! Reciprocal Phong, f = c_n cosⁿα (3.5).

use crate::error::within;
use crate::geometry::{below_horizon, power_lobe, versine};
use crate::models::EXPONENT_MAX;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::TAU;

/// c_n = (n + 2)/2π (3.6), the greatest constant that conserves energy for p = 0.
pub fn published_constant(exponent: f64) -> f64 {
    (exponent + 2.0) / TAU
}

/// Reciprocal Phong with exponent n, 0 … 1e8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phong {
    exponent: f64,
    constant: f64,
}

impl Phong {
    /// With the published constant (n + 2)/2π; the albedo is exactly 1 at the normal.
    pub fn new(exponent: f64) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        Ok(Self {
            exponent,
            constant: published_constant(exponent),
        })
    }

    /// The exponent n.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl Brdf for Phong {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * power_lobe(self.exponent, versine(l, v))
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [power_lobe(self.exponent, versine(l, v)) * l.z; 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Mirror, self.exponent)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "phong",
    source: "(1.33), (3.5), (3.6)",
    formula: "c_n cosⁿα, c_n = (n + 2)/2π",
    parameters: "n 0 … 1e8",
    reciprocal: true,
    grazing: "albedo tends to cosΘ for large n, radiance to 0",
    examples: || {
        vec![example(
            "n = 20",
            Phong::new(20.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = Phong::new(1e8).expect("in range");
        visit(&m, &PhongLobe::new(&m, 1e8, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn albedo_is_one_at_the_normal_for_every_exponent() {
        for n in [0.0, 0.5, 1.0, 20.0, 1e4, 1e8] {
            let a = directional_albedo_at(&Phong::new(n).unwrap(), 0.0);
            assert!((a.value - 1.0).abs() < 1e-10, "n = {n}: {a:?}");
        }
    }

    #[test]
    fn the_lobe_is_about_r_and_ends_at_90_degrees() {
        let m = Phong::new(7.0).unwrap();
        let l = Direction::from_degrees(60.0, 30.0);
        assert!((m.eval(&l, &l.mirrored()) - 9.0 / TAU).abs() < 1e-14);
        assert_eq!(m.eval(&l, &l), 0.0);
        let flat = Phong::new(0.0).unwrap();
        assert_eq!(flat.eval(&l, &l), 0.0);
    }
}
