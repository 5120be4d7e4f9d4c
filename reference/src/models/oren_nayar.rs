//! Oren–Nayar, the short form (1.56 as corrected): ρ/π (A + B (LV − NL·NV)⁺/max(NL, NV)).

use crate::error::within;
use crate::geometry::{below_horizon, over_cos_theta_min};
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// The coefficients A and B for a slope deviation σ in radians.
pub fn coefficients(sigma: f64) -> (f64, f64) {
    let s2 = sigma * sigma;
    (1.0 - 0.5 * s2 / (s2 + 0.33), 0.45 * s2 / (s2 + 0.09))
}

/// LV − NL·NV = |L_P||V_P| cosΔφ, formed from the projections.
pub(crate) fn plane_dot(l: &Direction, v: &Direction) -> f64 {
    l.x * v.x + l.y * v.y
}

/// The short form with albedo ρ (0 … 1) and slope deviation σ (radians, 0 … π/2).
///
/// With ρ = 1 its albedo reaches 1.015 (σ = 0.2): it does not conserve energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrenNayar {
    rho: f64,
    a: f64,
    b: f64,
}

impl OrenNayar {
    /// σ = 0 is Lambert.
    pub fn new(rho: f64, sigma: f64) -> Result<Self, ParameterError> {
        let rho = within("rho", rho, 0.0, 1.0)?;
        let (a, b) = coefficients(within("sigma", sigma, 0.0, FRAC_PI_2)?);
        Ok(Self { rho, a, b })
    }
}

impl Brdf for OrenNayar {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let retro = over_cos_theta_min(self.b * plane_dot(l, v).max(0.0), l, v, 1.0);
        (self.rho * FRAC_1_PI * (self.a + retro)).min(f64::MAX)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.extend([l.z - v.z, plane_dot(l, v)]);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "oren_nayar",
    source: "(1.56)",
    formula: "ρ/π (A + B (LV − NL·NV)⁺/max(NL, NV))",
    parameters: "ρ 0 … 1; σ 0 … π/2 radians",
    reciprocal: true,
    grazing: "f unbounded for L and V both at the horizon; albedo up to 1.015",
    examples: || {
        vec![
            example(
                "ρ = 1, σ = 0.2",
                OrenNayar::new(1.0, 0.2).expect("in range"),
                Exceeds,
            ),
            example(
                "ρ = 0.9, σ = 0.5",
                OrenNayar::new(0.9, 0.5).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backward_exceeds_forward_and_sigma_zero_is_lambert() {
        let m = OrenNayar::new(0.9, 0.5).unwrap();
        let l = Direction::from_degrees(60.0, 0.0);
        assert!(m.eval(&l, &l) > 1.3 * m.eval(&l, &l.mirrored()));
        let flat = OrenNayar::new(0.9, 0.0).unwrap();
        assert_eq!(flat.eval(&l, &l), 0.9 * FRAC_1_PI);
    }

    #[test]
    fn the_value_is_that_of_the_angles() {
        let (sigma, ti, to, dphi) = (0.35f64, 0.9f64, 0.6f64, 0.7f64);
        let (a, b) = coefficients(sigma);
        let expected = FRAC_1_PI * (a + b * dphi.cos() * ti.sin() * to.tan());
        let m = OrenNayar::new(1.0, sigma).unwrap();
        let f = m.eval(
            &Direction::from_angles(ti, 0.2),
            &Direction::from_angles(to, 0.2 + dphi),
        );
        assert!((f / expected - 1.0).abs() < 1e-14);
    }
}
