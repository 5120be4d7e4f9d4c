//! The exponential mixture of patches, f = C e^(−s·m) (4.46).

use crate::error::within;
use crate::geometry::{below_horizon, metric_squared};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{Mixture, MixtureMethod};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{PI, TAU};

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

    /// The weight of the ideal diffuse part, π C e^(−2s) (Table 4.1).
    pub fn diffuse_weight(&self) -> f64 {
        PI * self.constant * (-2.0 * self.sharpness).exp()
    }

    /// p(R) = π C s e^(−s·R) min(1, R²) (4.47), a density on 0 < R < 2 whose mass is
    /// 1 − [`Self::diffuse_weight`]; the rest is at R = 2.
    pub fn density(&self, r: f64) -> f64 {
        let s = self.sharpness;
        PI * self.constant * s * (-s * r).exp() * (r * r).min(1.0)
    }

    /// F(R) = ∫₀ᴿ p (4.27) for R of 0 … 2, before the jump to 1 at R = 2.
    pub fn cumulative(&self, r: f64) -> f64 {
        let s = self.sharpness;
        if s == 0.0 || r <= 0.0 {
            return 0.0;
        }
        let x = s * r.min(1.0);
        // ∫₀ˣ t²e^(−t) dt = 2 − e^(−x)(x² + 2x + 2), by its series for small x.
        let gamma = if x > 1.0 {
            2.0 - (-x).exp() * (x * x + 2.0 * x + 2.0)
        } else {
            let mut term = x * x * x / 6.0;
            let mut sum = 0.0;
            for k in 4..30 {
                sum += term;
                term *= x / f64::from(k);
            }
            2.0 * (-x).exp() * sum
        };
        let below = gamma / (s * s);
        let above = if r > 1.0 {
            (-s).exp() - (-s * r.min(2.0)).exp()
        } else {
            0.0
        };
        PI * self.constant * (below + above)
    }

    /// F⁻¹(u) for u of 0 … 1: the radius to draw; 2 for u beyond 1 − [`Self::diffuse_weight`].
    pub fn inverse(&self, u: f64) -> f64 {
        if u >= self.cumulative(2.0) {
            return 2.0;
        }
        crate::quadrature::find_root(&mut |r| self.cumulative(r) - u, 0.0, 2.0)
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

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_exponential",
    source: "(4.45) to (4.47)",
    formula: "s²/(2π(1 − (1 + s)e^(−s))) e^(−s·m)",
    parameters: "s 0 … 1e8",
    reciprocal: true,
    grazing: "f bounded, radiance falls to 0; albedo at least about ½",
    examples: || {
        vec![
            example(
                "s = 12",
                PatchExponential::new(12.0).expect("in range"),
                Conserves,
            ),
            example(
                "s = 1",
                PatchExponential::new(1.0).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        for (s, method) in [
            (4.0, MixtureMethod::Redraw),
            (40.0, MixtureMethod::Redraw),
            (1.0, MixtureMethod::Roulette),
        ] {
            let m = PatchExponential::new(s).expect("in range");
            visit(&m, &Mixture::exponential(&m, v, method));
        }
    }),
};

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
    fn the_cumulative_density_is_the_densitys_integral() {
        for s in [1e-6, 0.25, 2.0, 12.0, 300.0] {
            let m = PatchExponential::new(s).unwrap();
            for (a, b) in [(0.0, 0.01), (0.01, 0.3), (0.3, 1.0), (1.0, 1.7), (1.7, 2.0)] {
                let e = crate::quadrature::adaptive(
                    &mut |r| crate::Estimate {
                        value: m.density(r),
                        error: 0.0,
                    },
                    &[a, b],
                    1e-15,
                    100,
                );
                let difference = m.cumulative(b) - m.cumulative(a);
                assert!((e.value - difference).abs() < 1e-13, "s = {s}, {a} to {b}");
            }
            assert!(
                (m.cumulative(2.0) + m.diffuse_weight() - 1.0).abs() < 1e-13,
                "s = {s}"
            );
            for u in [0.1, 0.5, 0.9, 1.0] {
                let r = m.inverse(u);
                assert!(r == 2.0 || (m.cumulative(r) - u).abs() < 1e-14);
            }
        }
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
