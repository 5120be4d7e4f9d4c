//! The p-model, f = c_n cosⁿα / cosᵖΘmin (3.12): from reciprocal Phong (p = 0) to
//! metallic Phong (p = 1).

use crate::albedo::directional_albedo;
use crate::error::within;
use crate::geometry::{below_horizon, bounded_ratio, over_cos_theta_min, power_lobe, versine};
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::models::phong::published_constant;
use crate::models::{EXPONENT_MAX, Energy};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// The p-model with exponent n (0 … 1e8) and p (0 … 1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PModel {
    exponent: f64,
    p: f64,
    constant: f64,
}

impl PModel {
    /// With c_n as published, or divided by the greatest albedo (`strict`).
    pub fn new(exponent: f64, p: f64, energy: Energy) -> Result<Self, ParameterError> {
        let exponent = within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        let p = within("p", p, 0.0, 1.0)?;
        let mut model = Self {
            exponent,
            p,
            constant: published_constant(exponent),
        };
        if energy == Energy::Strict {
            model.constant /= model.greatest_albedo().1;
        }
        Ok(model)
    }

    /// The exponent n.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The transition parameter p.
    pub fn p(&self) -> f64 {
        self.p
    }

    /// The cosine at which the albedo is greatest, and that albedo, at least 1.
    ///
    /// From n = 2 on, and for p = 0, it is 1 at the normal (`measures` of the overshoot
    /// are in the tests); below, it is searched numerically.
    pub fn greatest_albedo(&self) -> (f64, f64) {
        if self.exponent >= 2.0 || self.p == 0.0 {
            return (1.0, 1.0);
        }
        let (c, a) = crate::albedo::greatest(&|c| directional_albedo(self, c).value);
        if a > 1.0 { (c, a) } else { (1.0, 1.0) }
    }
}

impl Brdf for PModel {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let lobe = self.constant * power_lobe(self.exponent, versine(l, v));
        over_cos_theta_min(lobe, l, v, self.p)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [power_lobe(self.exponent, versine(l, v)) * bounded_ratio(l, v, self.p); 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Mirror, self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        if self.p > 0.0 {
            out.push(l.z - v.z);
        }
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "p_model",
    source: "(3.12)",
    formula: "c_n cosⁿα/cosᵖΘmin",
    parameters: "n 0 … 1e8; p 0 … 1; published or strict energy",
    reciprocal: true,
    grazing: "between Phong's (p = 0) and metallic Phong's (p = 1)",
    examples: || {
        let new = |n, p, energy| PModel::new(n, p, energy).expect("in range");
        vec![
            example(
                "n = 20, p = 0.5",
                new(20.0, 0.5, Energy::Published),
                Conserves,
            ),
            example(
                "n = 1, p = 0.9",
                new(1.0, 0.9, Energy::Published),
                Conserves,
            ),
            example("n = 1, p = 1", new(1.0, 1.0, Energy::Published), Exceeds),
        ]
    },
    sampler: Some(|v, visit| {
        let m = PModel::new(7.0, 0.5, Energy::Published).expect("in range");
        visit(&m, &PhongLobe::new(&m, 7.0, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn overshoot_is_as_measured() {
        // Greatest excess over 1 and its angle in degrees.
        for (n, excess, angle, tolerance) in [
            (1.0, 2.886e-4, 12.9, 1e-7),
            (0.5, 1.064e-2, 30.0, 1e-5),
            (0.25, 3.4e-2, 38.5, 5e-4),
            (0.0, 8.6e-2, 90.0, 5e-4),
        ] {
            let m = PModel::new(n, 1.0, Energy::Published).unwrap();
            let (c, a) = m.greatest_albedo();
            assert!((a - 1.0 - excess).abs() < tolerance, "n = {n}: {a}");
            if n > 0.0 {
                assert!((c.acos().to_degrees() - angle).abs() < 0.1, "n = {n}: {c}");
            }
        }
    }

    #[test]
    fn strict_never_exceeds_one() {
        for (n, p) in [(0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (0.25, 0.5), (1.5, 0.9)] {
            let m = PModel::new(n, p, Energy::Strict).unwrap();
            let mut greatest = 0.0f64;
            for degrees in 0..=90 {
                let a = directional_albedo_at(&m, f64::from(degrees));
                assert!(a.value <= 1.0 + 1e-9, "n = {n}, p = {p}, {degrees}: {a:?}");
                greatest = greatest.max(a.value);
            }
            assert!(greatest > 0.9999, "n = {n}, p = {p}: {greatest}");
        }
    }

    #[test]
    fn corners() {
        let m = PModel::new(20.0, 1.0, Energy::Published).unwrap();
        let horizon = Direction::new(1.0, 0.0, 0.0);
        let opposite = Direction::new(-1.0, 0.0, 0.0);
        assert_eq!(m.eval(&horizon, &opposite), f64::MAX);
        assert_eq!(m.reflect(&horizon, &opposite), [0.0; 3]);
        let low = Direction::from_cosine(1e-8, 0.0);
        let far = Direction::new(-low.x, 0.0, 0.0);
        assert!(m.rho(&low, &far)[0] > 0.999_999);
        assert_eq!(m.rho(&far, &low)[0], 0.0);
        let below = Direction::new(-1.0, 0.0, -1e-300);
        assert_eq!(m.eval(&horizon, &below), 0.0);
        assert_eq!(m.rho(&low, &below), [0.0; 3]);
    }
}
