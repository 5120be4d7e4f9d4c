//! Metallic Phong, f = c_n cosⁿα / cosΘmin (3.7, 3.10), the thesis' model for metals.

use crate::geometry::{below_horizon, power_lobe, versine};
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::models::{Energy, PModel};
use crate::quadrature::Chart;
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// Metallic Phong with exponent n, 0 … 1e8: the p-model at p = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MetallicPhong(PModel);

impl MetallicPhong {
    /// With c_n as published, or divided by the greatest albedo (`strict`).
    pub fn new(exponent: f64, energy: Energy) -> Result<Self, ParameterError> {
        Ok(Self(PModel::new(exponent, 1.0, energy)?))
    }

    /// The exponent n.
    pub fn exponent(&self) -> f64 {
        self.0.exponent()
    }

    /// The albedo at exactly 90°, (n + 2)/(2n + 2) (3.27).
    pub fn grazing_albedo(exponent: f64) -> f64 {
        (exponent + 2.0) / (2.0 * exponent + 2.0)
    }

    /// The albedo for large n at an angle Θ short of 90°, within 0.601/n
    /// (0.60094/n as n → ∞, at z = 1.08; tested for n = 20 … 1e8):
    /// Φ(z) − (1 − exp(−z²/2))/(z√(2π)), z = √n cotΘ.
    pub fn albedo_for_large_exponents(exponent: f64, cos_theta: f64) -> f64 {
        let sine = ((1.0 - cos_theta) * (1.0 + cos_theta)).sqrt();
        let z = exponent.sqrt() * cos_theta / sine;
        if z == 0.0 {
            return 0.5;
        }
        if !z.is_finite() {
            return 1.0;
        }
        let root = (2.0 * std::f64::consts::PI).sqrt();
        crate::special::normal_cdf(z) + (-0.5 * z * z).exp_m1() / (z * root)
    }

    /// The mean albedo for large n, 1 − √(π/8n).
    pub fn mean_albedo_for_large_exponents(exponent: f64) -> f64 {
        1.0 - (std::f64::consts::PI / (8.0 * exponent)).sqrt()
    }
}

impl Brdf for MetallicPhong {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        self.0.eval(l, v)
    }

    fn peak(&self) -> f64 {
        self.0.peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let greatest = l.z.max(v.z);
        if below_horizon(l, v) || greatest == 0.0 {
            return [0.0; 3];
        }
        [power_lobe(self.exponent(), versine(l, v)) * (l.z / greatest); 3]
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.0.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.0.creases(l, v, out);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "metallic_phong",
    source: "(3.7), (3.10)",
    formula: "c_n cosⁿα/cosΘmin, c_n = (n + 2)/2π",
    parameters: "n 0 … 1e8; published or strict energy",
    reciprocal: true,
    grazing: "radiance of the mirror image constant; albedo (n + 2)/(2n + 2) at 90°, \
              short of it within 0.601/n of Φ(z) − (1 − e^(−z²/2))/(z√2π), z = √n cotΘ, for n from 20",
    examples: || {
        let new = |n, energy| MetallicPhong::new(n, energy).expect("in range");
        vec![
            example("n = 20", new(20.0, Energy::Published), Conserves),
            example("n = 1e8", new(1e8, Energy::Published), Conserves),
            example("n = 1, published", new(1.0, Energy::Published), Exceeds),
            example("n = 0.5, published", new(0.5, Energy::Published), Exceeds),
            example("n = 0.5, strict", new(0.5, Energy::Strict), Conserves),
        ]
    },
    sampler: Some(|v, visit| {
        let m = MetallicPhong::new(20.0, Energy::Published).expect("in range");
        visit(&m, &PhongLobe::new(&m, 20.0, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    fn model(n: f64) -> MetallicPhong {
        MetallicPhong::new(n, Energy::Published).unwrap()
    }

    #[test]
    fn grazing_albedo_is_the_closed_form() {
        for n in [0.0, 1.0, 2.0, 20.0, 1e3, 1e5, 1e8] {
            let a = directional_albedo_at(&model(n), 90.0);
            let exact = MetallicPhong::grazing_albedo(n);
            assert!((a.value - exact).abs() < 1e-10, "n = {n}: {a:?} {exact}");
            assert!(a.error < 1e-10, "n = {n}: {a:?}");
        }
    }

    #[test]
    fn the_closed_form_for_large_exponents_holds_to_first_order() {
        for n in [20.0, 100.0, 1e3, 1e4, 1e6, 1e8] {
            for degrees in [0.5, 5.0, 30.0, 60.0, 80.0, 88.0, 89.5, 89.9, 89.99] {
                let l = Direction::from_degrees(degrees, 0.0);
                let a = crate::directional_albedo(&model(n), l.z);
                let form = MetallicPhong::albedo_for_large_exponents(n, l.z);
                let bound = 0.601 / n + 1e-11;
                assert!(
                    (a.value - form).abs() <= bound,
                    "n = {n}, {degrees}: {a:?} {form}"
                );
            }
        }
    }

    #[test]
    fn the_bound_of_the_closed_form_is_tight() {
        let n = 1e4f64;
        let cot = 1.0822 / n.sqrt();
        let c = cot / (1.0 + cot * cot).sqrt();
        let a = crate::directional_albedo(&model(n), c);
        let excess = n * (a.value - MetallicPhong::albedo_for_large_exponents(n, c));
        assert!(excess > 0.6 && excess < 0.601, "{excess}");
    }

    #[test]
    fn mirror_value_and_sideways_lobe() {
        let m = model(20.0);
        let l = Direction::from_degrees(80.0, 0.0);
        let c = 22.0 / std::f64::consts::TAU;
        assert!((m.eval(&l, &l.mirrored()) * l.z / c - 1.0).abs() < 1e-12);
        // Turned 0.05 rad sideways at the horizon's cosine, R·V to the 20th is 0.976;
        // the half-vector shortcut would give 0.448.
        let v = Direction::from_degrees(80.0, 180.0 + 0.05f64.to_degrees());
        assert!(
            (m.rho(&l, &v)[0] - 0.976).abs() < 5e-4,
            "{:?}",
            m.rho(&l, &v)
        );
        assert_eq!(m.eval(&l, &l), 0.0);
    }

    #[test]
    fn reciprocity_is_bit_equal() {
        let m = model(33.0);
        let a = Direction::from_degrees(25.0, 10.0);
        let b = Direction::from_degrees(48.0, 160.0);
        assert_eq!(m.eval(&a, &b).to_bits(), m.eval(&b, &a).to_bits());
        assert!(m.eval(&a, &b) > 0.0);
    }
}
