//! The exponential mixture of patches, f = C e^(−s·m) (4.46).

use crate::error::within;
use crate::geometry::{below_horizon, metric_squared};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::TAU;

/// The exponential patch model with sharpness s, 0 … 1e8; s = 0 is Lambert.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchExponential {
    sharpness: f64,
    constant: f64,
}

/// C_max(s) = s²/(2π(1 − (1 + s)e^(−s))) (4.45); 1/π at s = 0.
///
/// Below s = 0.5 the quotient is formed as a series: both parts vanish as s².
pub fn greatest_constant(sharpness: f64) -> f64 {
    let s = sharpness;
    if s >= 0.5 {
        return s * s / (TAU * (1.0 - (1.0 + s) * (-s).exp()));
    }
    // (1 − (1 + s)e^(−s))/s² = Σ (−s)ᵏ (k + 1)/(k + 2)!
    let mut sum = 0.0;
    let mut term = 0.5;
    for k in 0..20 {
        sum += term * f64::from(k + 1);
        term *= -s / f64::from(k + 3);
    }
    1.0 / (TAU * sum)
}

impl PatchExponential {
    /// With the greatest constant that conserves energy (4.45).
    pub fn new(sharpness: f64) -> Result<Self, ParameterError> {
        let sharpness = within("sharpness", sharpness, 0.0, 1e8)?;
        Ok(Self {
            sharpness,
            constant: greatest_constant(sharpness),
        })
    }

    /// The sharpness s.
    pub fn sharpness(&self) -> f64 {
        self.sharpness
    }

    fn lobe(&self, l: &Direction, v: &Direction) -> f64 {
        (-self.sharpness * metric_squared(l, v).sqrt()).exp()
    }
}

impl Brdf for PatchExponential {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * self.lobe(l, v)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [self.lobe(l, v) * l.z; 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, 2.0 / (1.0 + self.sharpness))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, models::Lambert};
    use std::f64::consts::FRAC_1_PI;

    #[test]
    fn albedo_is_one_at_the_normal() {
        for s in [0.0, 1e-9, 0.3, 1.0, 12.0, 512.0, 1e6] {
            let a = directional_albedo_at(&PatchExponential::new(s).unwrap(), 0.0);
            assert!((a.value - 1.0).abs() < 1e-10, "s = {s}: {a:?}");
        }
    }

    #[test]
    fn the_series_meets_the_quotient() {
        let s = 0.5f64;
        let quotient = s * s / (TAU * (1.0 - (1.0 + s) * (-s).exp()));
        assert!((greatest_constant(s - 1e-12) / quotient - 1.0).abs() < 1e-11);
        assert_eq!(greatest_constant(0.0), FRAC_1_PI);
    }

    #[test]
    fn without_sharpness_it_is_lambert() {
        let (m, lambert) = (
            PatchExponential::new(0.0).unwrap(),
            Lambert::grey(1.0).unwrap(),
        );
        let (l, v) = (
            Direction::from_degrees(30.0, 0.0),
            Direction::from_degrees(70.0, 99.0),
        );
        assert_eq!(m.eval(&l, &v), lambert.eval(&l, &v));
    }

    #[test]
    fn the_lobe_is_about_r() {
        let m = PatchExponential::new(20.0).unwrap();
        let l = Direction::from_degrees(60.0, 45.0);
        assert_eq!(m.rho(&l, &l.mirrored())[0], l.z);
        let expected = (-20.0 * 2.0 * 60f64.to_radians().sin()).exp();
        assert!((m.eval(&l, &l) / m.peak() / expected - 1.0).abs() < 1e-12);
    }
}
