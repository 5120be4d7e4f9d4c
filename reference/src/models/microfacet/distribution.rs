//! Distributions of the facets' normals, each with ∫ D cosδ dω = 1.

use crate::ParameterError;
use crate::error::within;
use crate::half::Half;
use crate::quadrature::{Chart, ChartKind, Estimate, adaptive};
use std::f64::consts::{FRAC_PI_2, LN_2, PI, TAU};

/// A distribution with its parameter and constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Beckmann: e^(−tan²δ/m²)/(πm² cos⁴δ) (2.9 without the 4).
    Beckmann {
        /// RMS slope m.
        m: f64,
    },
    /// Torrance's Gaussian: const · e^(−(sδ)²), the constant found numerically.
    Gaussian {
        /// Sharpness s.
        s: f64,
        /// The constant.
        constant: f64,
    },
    /// Trowbridge–Reitz: q²/π · (1 + (q² − 1)cos²δ)⁻².
    Trowbridge {
        /// Width q, 1 for a sphere.
        q: f64,
    },
    /// Blinn's: (t + 2)/2π · cosᵗδ.
    Blinn {
        /// Exponent t.
        t: f64,
    },
    /// Ashikhmin–Shirley's: √((ex + 2)(ey + 2))/2π · cosδ^(ex cos²φ + ey sin²φ).
    AshikhminShirley {
        /// Exponent along x.
        x: f64,
        /// Exponent along y.
        y: f64,
    },
}

impl Distribution {
    /// Beckmann with m of 1e-4 … 10.
    pub fn beckmann(m: f64) -> Result<Self, ParameterError> {
        Ok(Self::Beckmann {
            m: within("m", m, 1e-4, 10.0)?,
        })
    }

    /// Gaussian with s of 0 … 1e4.
    pub fn gaussian(s: f64) -> Result<Self, ParameterError> {
        let s = within("s", s, 0.0, 1e4)?;
        let width = (8.0 / s.max(1e-9)).min(FRAC_PI_2);
        let integral = adaptive(
            &mut |d| Estimate {
                value: TAU * (-(s * d).powi(2)).exp() * d.cos() * d.sin(),
                error: 0.0,
            },
            &[0.0, width],
            1e-16,
            100,
        );
        Ok(Self::Gaussian {
            s,
            constant: 1.0 / integral.value,
        })
    }

    /// Trowbridge with q of 1e-4 … 1.
    pub fn trowbridge(q: f64) -> Result<Self, ParameterError> {
        Ok(Self::Trowbridge {
            q: within("q", q, 1e-4, 1.0)?,
        })
    }

    /// Blinn with t of 0 … 1e8.
    pub fn blinn(t: f64) -> Result<Self, ParameterError> {
        Ok(Self::Blinn {
            t: within("t", t, 0.0, 1e8)?,
        })
    }

    /// Ashikhmin–Shirley with both exponents of 0 … 1e8.
    pub fn ashikhmin_shirley(x: f64, y: f64) -> Result<Self, ParameterError> {
        Ok(Self::AshikhminShirley {
            x: within("ex", x, 0.0, 1e8)?,
            y: within("ey", y, 0.0, 1e8)?,
        })
    }

    /// The parameters (m, s, q, t) with which Beckmann, Gaussian, Trowbridge and Blinn fall
    /// to half of their peak at the angle `half_width` (radians, 0 … π/4), as corrected.
    pub fn of_half_width(half_width: f64) -> [f64; 4] {
        let (g, c) = (half_width, half_width.cos());
        let m = g.tan() / (LN_2 - 4.0 * c.ln()).sqrt();
        let s = LN_2.sqrt() / g;
        let q = ((c * c - 1.0) / (c * c - 2f64.sqrt())).sqrt();
        let t = -LN_2 / c.ln();
        [m, s, q, t]
    }

    /// D(H), in sr⁻¹.
    pub fn density(&self, h: &Half) -> f64 {
        match *self {
            Self::Beckmann { m } => {
                let m2 = m * m;
                let lobe = (-h.tan2 / m2).exp();
                // 1/cos⁴δ = (1 + tan²δ)².
                if lobe == 0.0 {
                    0.0
                } else {
                    lobe * (1.0 + h.tan2).powi(2) / (PI * m2)
                }
            }
            Self::Gaussian { s, constant } => {
                let delta = h.tan2.sqrt().atan();
                constant * (-(s * delta).powi(2)).exp()
            }
            Self::Trowbridge { q } => {
                // 1 + (q² − 1)cos²δ = (tan²δ + q²)cos²δ.
                let q2 = q * q;
                let c2 = h.cos * h.cos;
                let s2 = 1.0 - c2;
                let base = if h.tan2.is_finite() {
                    (h.tan2 + q2) * c2
                } else {
                    s2
                };
                q2 / (PI * base * base)
            }
            Self::Blinn { t } => (t + 2.0) / TAU * h.cos_power(t),
            Self::AshikhminShirley { x, y } => {
                let (c2, s2) = h.azimuth2();
                ((x + 2.0) * (y + 2.0)).sqrt() / TAU * h.cos_power(x * c2 + y * s2)
            }
        }
    }

    pub(crate) fn is_isotropic(&self) -> bool {
        match self {
            Self::AshikhminShirley { x, y } => x == y,
            _ => true,
        }
    }

    pub(crate) fn chart(&self) -> Chart {
        let scale = match *self {
            Self::Beckmann { m } => m,
            Self::Gaussian { s, .. } => 1.0 / s.max(1.0),
            Self::Trowbridge { q } => q,
            Self::Blinn { t } => 1.0 / (1.0 + 0.5 * t).sqrt(),
            Self::AshikhminShirley { x, y } => {
                (1.0 + 0.5 * x).powf(-0.25) * (1.0 + 0.5 * y).powf(-0.25)
            }
        };
        Chart::new(ChartKind::Half, scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Direction;
    use crate::quadrature::{Accuracy, hemisphere};

    fn half(degrees: f64, azimuth: f64) -> Half {
        let d = Direction::from_degrees(degrees, azimuth);
        Half::of(&d, &d).unwrap()
    }

    #[test]
    fn the_projected_area_is_one() {
        let all = [
            Distribution::beckmann(0.3).unwrap(),
            Distribution::beckmann(2.0).unwrap(),
            Distribution::gaussian(0.5).unwrap(),
            Distribution::gaussian(9.0).unwrap(),
            Distribution::trowbridge(0.2).unwrap(),
            Distribution::blinn(30.0).unwrap(),
            Distribution::ashikhmin_shirley(10.0, 1000.0).unwrap(),
        ];
        for d in all {
            // H itself plays the part of V in polar coordinates about N.
            let e = hemisphere(
                &Direction::NORMAL,
                &Chart::new(ChartKind::Plane, 0.3),
                false,
                Accuracy::FINE,
                &|_, _| {},
                &|v| d.density(&Half::of(v, v).unwrap()),
            );
            assert!((e.value - 1.0).abs() < 1e-9, "{d:?}: {e:?}");
        }
    }

    #[test]
    fn half_widths_give_half_of_the_peak() {
        for degrees in [3.0, 10.0, 25.0] {
            let [m, s, q, t] = Distribution::of_half_width(f64::to_radians(degrees));
            for d in [
                Distribution::beckmann(m),
                Distribution::gaussian(s),
                Distribution::trowbridge(q),
                Distribution::blinn(t),
            ] {
                let d = d.unwrap();
                let ratio = d.density(&half(degrees, 0.0)) / d.density(&half(0.0, 0.0));
                assert!((ratio - 0.5).abs() < 1e-9, "{d:?} at {degrees}: {ratio}");
            }
        }
    }
}
