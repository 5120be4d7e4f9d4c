//! Oren–Nayar, the full form with interreflections (1.57 to 1.59 as corrected).

use super::oren_nayar::{coefficients, plane_dot};
use crate::error::within;
use crate::geometry::{below_horizon, cos_theta_min};
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// The full form with albedo ρ (0 … 1) and slope deviation σ (radians, 0 … π/2).
///
/// With ρ = 1 its albedo reaches 1.050 (σ = 0.3, 89.9°): it does not conserve energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrenNayarFull {
    rho: f64,
    sigma: f64,
    a: f64,
    b: f64,
}

impl OrenNayarFull {
    /// σ = 0 is Lambert.
    pub fn new(rho: f64, sigma: f64) -> Result<Self, ParameterError> {
        let rho = within("rho", rho, 0.0, 1.0)?;
        let sigma = within("sigma", sigma, 0.0, FRAC_PI_2)?;
        let (a, b) = coefficients(sigma);
        Ok(Self { rho, sigma, a, b })
    }
}

/// The angle to N, exact near the horizon.
fn angle(d: &Direction) -> f64 {
    d.x.hypot(d.y).atan2(d.z)
}

impl Brdf for OrenNayarFull {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let greatest = cos_theta_min(l, v);
        if greatest == 0.0 {
            // tanβ is infinite; the factor (1 − (2β/π)³) or the retro part decides nothing.
            return if self.b == 0.0 {
                self.rho * FRAC_1_PI
            } else {
                f64::MAX
            };
        }
        let (tl, tv) = (angle(l), angle(v));
        let (alpha, beta) = (tl.max(tv), tl.min(tv));
        let dot = plane_dot(l, v);
        let sines = l.x.hypot(l.y) * v.x.hypot(v.y);
        let cos_phi = if sines > 0.0 {
            (dot / sines).clamp(-1.0, 1.0)
        } else {
            0.0
        };
        let tan_beta = (1.0 - greatest * greatest).max(0.0).sqrt() / greatest;
        let shade = 2.0 * beta / PI;
        let mut first = self.a + self.b * dot / greatest;
        if cos_phi < 0.0 {
            first -= self.b * cos_phi * shade.powi(3) * tan_beta;
        }
        let spread = (4.0 * alpha * beta / (PI * PI)).powi(2);
        first +=
            5.0 / 18.0 * self.b * (1.0 - cos_phi.abs()) * spread * (0.5 * (alpha + beta)).tan();
        let s2 = self.sigma * self.sigma;
        let second = 0.17 * self.rho * s2 / (s2 + 0.13) * (1.0 - cos_phi * shade * shade);
        (self.rho * FRAC_1_PI * (first + second)).clamp(0.0, f64::MAX)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.extend([l.z - v.z, plane_dot(l, v)]);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "oren_nayar_full",
    source: "(1.57) to (1.59), Oren and Nayar 1994",
    formula: "ρ/π (A + B … + C₃ … ) + interreflections",
    parameters: "ρ 0 … 1; σ 0 … π/2 radians",
    reciprocal: true,
    grazing: "f unbounded; albedo up to 1.05",
    examples: || {
        vec![
            example(
                "ρ = 1, σ = 0.3",
                OrenNayarFull::new(1.0, 0.3).expect("in range"),
                Exceeds,
            ),
            example(
                "ρ = 0.8, σ = 0.5",
                OrenNayarFull::new(0.8, 0.5).expect("in range"),
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
    fn sigma_zero_is_lambert() {
        let m = OrenNayarFull::new(0.7, 0.0).unwrap();
        let (l, v) = (
            Direction::from_degrees(70.0, 0.0),
            Direction::from_degrees(20.0, 150.0),
        );
        assert!((m.eval(&l, &v) - 0.7 * FRAC_1_PI).abs() < 1e-16);
    }

    #[test]
    fn interreflections_darken_with_the_square_of_the_albedo() {
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(50.0, 90.0),
        );
        let f = |rho| OrenNayarFull::new(rho, 0.6).unwrap().eval(&l, &v) / rho;
        // f/ρ = first + ρ·second: linear in ρ.
        let (low, middle, high) = (f(0.2), f(0.5), f(0.8));
        assert!(high > low && (low + high - 2.0 * middle).abs() < 1e-14);
    }
}
