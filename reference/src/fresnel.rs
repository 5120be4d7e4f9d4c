//! The exact Fresnel equations for unpolarised light.

use crate::ParameterError;
use crate::error::{above, within};
use num_complex::Complex64;

/// A complex index of refraction η + iκ relative to air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    eta: f64,
    k: f64,
}

impl Index {
    /// η above 0, k at least 0 (0 for a dielectric), both finite and at most 1000.
    pub fn new(eta: f64, k: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            eta: above("eta", eta, 0.0, 1000.0)?,
            k: within("k", k, 0.0, 1000.0)?,
        })
    }

    /// The real part η.
    pub fn eta(self) -> f64 {
        self.eta
    }

    /// The imaginary part k.
    pub fn k(self) -> f64 {
        self.k
    }

    /// Reflectance at `cos_theta` (clamped to 0 … 1) from the normal.
    pub fn reflectance(self, cos_theta: f64) -> f64 {
        if self.k == 0.0 {
            dielectric(self.eta, cos_theta)
        } else {
            conductor(self.eta, self.k, cos_theta)
        }
    }
}

/// Reflectance of a conductor with index η + ik at `cos_theta` (clamped to 0 … 1), 0 … 1.
///
/// With γ = √(κ² − sin²Θ) in complex arithmetic: (|(c−γ)/(c+γ)|² + |(κ²c−γ)/(κ²c+γ)|²)/2,
/// which is (1.41) and (1.42) as corrected: absolute squares of complex amplitudes.
/// Exactly 1 at grazing incidence. With k = 0 it equals [`dielectric`].
pub fn conductor(eta: f64, k: f64, cos_theta: f64) -> f64 {
    let c = cos_theta.clamp(0.0, 1.0);
    if c == 0.0 {
        return 1.0;
    }
    let index2 = Complex64::new(eta, k) * Complex64::new(eta, k);
    let gamma = root(index2 - (1.0 - c) * (1.0 + c));
    let share = |a: Complex64| (a - gamma).norm_sqr() / (a + gamma).norm_sqr();
    0.5 * (share(c.into()) + share(index2 * c))
}

/// The square root of a complex number with an imaginary part of at least 0. What is a
/// difference comes from what is a sum, so nothing cancels; no angle is formed, as the
/// library's root does, which takes several times as long.
fn root(z: Complex64) -> Complex64 {
    let greater = (0.5 * (z.norm() + z.re.abs())).sqrt();
    if greater == 0.0 {
        return Complex64::ZERO;
    }
    let less = 0.5 * z.im / greater;
    if z.re >= 0.0 {
        Complex64::new(greater, less)
    } else {
        Complex64::new(less, greater)
    }
}

/// Reflectance of a dielectric of index `eta` relative to the side of incidence,
/// at `cos_theta` (clamped to 0 … 1), 0 … 1 (1.44). Total reflection gives 1.
pub fn dielectric(eta: f64, cos_theta: f64) -> f64 {
    let c = cos_theta.clamp(0.0, 1.0);
    if c == 0.0 {
        return 1.0;
    }
    let g2 = eta * eta - (1.0 - c) * (1.0 + c);
    if g2 <= 0.0 {
        return 1.0;
    }
    let g = g2.sqrt();
    let perpendicular = (c - g) / (c + g);
    let parallel = (eta * eta * c - g) / (eta * eta * c + g);
    0.5 * (perpendicular * perpendicular + parallel * parallel)
}

/// Schlick's approximation F0 + (1 − F0)(1 − cosΘ)⁵ (1.48), for F0 in 0 … 1.
pub fn schlick(f0: f64, cos_theta: f64) -> f64 {
    let u = 1.0 - cos_theta.clamp(0.0, 1.0);
    f0 + (1.0 - f0) * u.powi(5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_squared_is_what_it_is_of() {
        for re in [-20.0, -1.0, -1e-9, 0.0, 1e-9, 0.3, 7.0] {
            for im in [0.0, 1e-12, 0.4, 30.0] {
                let z = Complex64::new(re, im);
                let r = root(z);
                assert!(r.re >= 0.0 && r.im >= 0.0, "{z}: {r}");
                assert!((r * r - z).norm() <= 1e-15 * z.norm(), "{z}: {r}");
                assert!((r - z.sqrt()).norm() <= 1e-15 * r.norm(), "{z}: {r}");
            }
        }
    }

    #[test]
    fn conductor_without_absorption_is_a_dielectric() {
        for eta in [0.4, 0.9, 1.0, 1.33, 1.5, 2.42] {
            for i in 0..=1000 {
                let c = f64::from(i) / 1000.0;
                let (a, b) = (conductor(eta, 0.0, c), dielectric(eta, c));
                assert!((a - b).abs() < 2e-15, "eta {eta} cos {c}: {a} {b}");
            }
        }
    }

    #[test]
    fn aluminium_at_60_degrees_has_the_absolute_square() {
        // Index of Table 1.2. The plain square of the complex amplitude has the real part
        // 0.912; the absolute square is 0.957.
        let (eta, k, c) = (0.93, 6.33, 0.5);
        let index2 = Complex64::new(eta, k) * Complex64::new(eta, k);
        let gamma = (index2 - 0.75).sqrt();
        let s = (c - gamma) / (c + gamma);
        let p = (index2 * c - gamma) / (index2 * c + gamma);
        assert!(((s * s).re - 0.912).abs() < 5e-4);
        assert!((s.norm_sqr() - 0.957).abs() < 5e-4);
        let expected = 0.5 * (s.norm_sqr() + p.norm_sqr());
        assert!((conductor(eta, k, c) - expected).abs() < 1e-15);
    }

    #[test]
    fn parallel_light_vanishes_at_brewsters_angle() {
        let eta = 1.5f64;
        let c = 1.0 / (1.0 + eta * eta).sqrt();
        let s = (eta * eta - 1.0) / (eta * eta + 1.0);
        assert!((dielectric(eta, c) - 0.5 * s * s).abs() < 1e-15);
    }

    #[test]
    fn grazing_reflects_all_and_index_one_nothing() {
        assert_eq!(conductor(0.18, 3.64, 0.0), 1.0);
        assert_eq!(dielectric(1.5, 0.0), 1.0);
        assert!(dielectric(1.0, 0.3) < 1e-30);
    }

    #[test]
    fn bad_indices_are_named() {
        let e = Index::new(f64::NAN, 1.0).unwrap_err();
        assert_eq!(e.parameter, "eta");
        assert_eq!(Index::new(1.5, -0.1).unwrap_err().parameter, "k");
    }
}
