//! Masking and shadowing of facets.

use super::Distribution;
use crate::half::Half;
use crate::{Direction, ParameterError};
use std::f64::consts::PI;

/// A geometrical attenuation factor G.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attenuation {
    /// G = 1.
    None,
    /// V-shaped grooves, min(1, 2NH·NL/LH, 2NH·NV/VH) (1.37, 2.10).
    VCavity,
    /// (1.38) as printed: He and Torrance's shadowing, g/(1 + g) for each direction,
    /// with the distribution's own width for m. Not Smith's term, although it is named so.
    HeTorrance,
    /// Smith's term for uncorrelated masking and shadowing, G1(L)·G1(V), in the closed
    /// forms of B. Walter and others (2007); for Beckmann and Trowbridge only.
    Smith,
}

impl Attenuation {
    pub(super) fn check(self, distribution: &Distribution) -> Result<(), ParameterError> {
        let fits = match self {
            Self::None | Self::VCavity => true,
            Self::HeTorrance => matches!(distribution, Distribution::Beckmann { .. }),
            Self::Smith => matches!(
                distribution,
                Distribution::Beckmann { .. } | Distribution::Trowbridge { .. }
            ),
        };
        if fits {
            return Ok(());
        }
        Err(ParameterError::new(
            "attenuation",
            format!("{self:?} with {distribution:?}"),
            "HeTorrance with Beckmann, or Smith with Beckmann or Trowbridge",
        ))
    }

    /// G/(NL·NV), at most `f64::MAX`.
    pub(super) fn over_cosines(
        self,
        distribution: &Distribution,
        h: &Half,
        l: &Direction,
        v: &Direction,
    ) -> f64 {
        let value = match self {
            Self::None => 1.0 / (l.z * v.z),
            Self::VCavity => {
                // 2NH/LH · min(NL, NV)/(NL·NV) = 2NH/(LH · max(NL, NV)).
                let groove = 2.0 * h.cos / (h.lh * l.z.max(v.z));
                groove.min(1.0 / (l.z * v.z))
            }
            Self::HeTorrance | Self::Smith => {
                self.one_sided_over_cos(distribution, l.z)
                    * self.one_sided_over_cos(distribution, v.z)
            }
        };
        if value.is_nan() {
            f64::MAX
        } else {
            value.min(f64::MAX)
        }
    }

    /// The factor of one direction, 0 … 1, of the separable terms.
    pub fn one_sided(self, distribution: &Distribution, cos: f64) -> f64 {
        let cot = cos / ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
        match (self, distribution) {
            (Self::HeTorrance, Distribution::Beckmann { m }) => {
                let h = cot * cot / (2.0 * m * m);
                if h.is_infinite() {
                    return 1.0;
                }
                let g = (PI * h).sqrt() * (2.0 - libm::erfc(h.sqrt()));
                g / (g + 1.0)
            }
            (Self::Smith, Distribution::Beckmann { m }) => {
                let a = cot / m;
                if a == 0.0 {
                    return 0.0;
                }
                if a > 30.0 {
                    return 1.0;
                }
                let lambda = 0.5 * ((-a * a).exp() / (a * PI.sqrt()) - libm::erfc(a));
                1.0 / (1.0 + lambda)
            }
            (Self::Smith, Distribution::Trowbridge { q }) => {
                if cot == 0.0 {
                    return 0.0;
                }
                let t = q / cot;
                2.0 / (1.0 + (1.0 + t * t).sqrt())
            }
            _ => 1.0,
        }
    }

    /// The factor of one direction over its cosine, with its limit at the horizon.
    fn one_sided_over_cos(self, distribution: &Distribution, cos: f64) -> f64 {
        if cos > 0.0 {
            return self.one_sided(distribution, cos) / cos;
        }
        match (self, distribution) {
            (Self::HeTorrance, Distribution::Beckmann { m }) => (0.5 * PI).sqrt() / m,
            (Self::Smith, Distribution::Beckmann { m }) => 2.0 * PI.sqrt() / m,
            (Self::Smith, Distribution::Trowbridge { q }) => 2.0 / q,
            _ => f64::INFINITY,
        }
    }

    pub(super) fn creases(self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        if self == Self::VCavity
            && let Some(h) = Half::of(l, v)
        {
            out.extend([
                l.z - v.z,
                2.0 * h.cos * l.z - h.lh,
                2.0 * h.cos * v.z - h.lh,
            ]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::{Accuracy, Chart, ChartKind, hemisphere};

    /// ∫ G1(V) (V·H)⁺ D(H) dω must be cosΘV: the visible area seen from V.
    fn seen(attenuation: Attenuation, distribution: &Distribution, degrees: f64) -> f64 {
        let v = Direction::from_degrees(degrees, 0.0);
        let area = hemisphere(
            &Direction::NORMAL,
            &Chart::new(ChartKind::Plane, 0.4),
            false,
            Accuracy::FINE,
            &|h, out| out.push(h.dot(v)),
            // The measure holds cosδ, which isn't in the integral.
            &|h| {
                let half = Half::of(h, h).unwrap();
                distribution.density(&half) * h.dot(v).max(0.0) / h.z
            },
        );
        attenuation.one_sided(distribution, v.z) * area.value / v.z
    }

    #[test]
    fn smiths_term_passes_the_projected_area_test() {
        for degrees in [20.0, 60.0, 85.0] {
            let beckmann = Distribution::beckmann(0.4).unwrap();
            let s = seen(Attenuation::Smith, &beckmann, degrees);
            assert!((s - 1.0).abs() < 1e-8, "Beckmann {degrees}: {s}");
            let trowbridge = Distribution::trowbridge(0.4).unwrap();
            let s = seen(Attenuation::Smith, &trowbridge, degrees);
            assert!((s - 1.0).abs() < 1e-6, "Trowbridge {degrees}: {s}");
        }
    }

    #[test]
    fn the_limits_at_the_horizon_are_met() {
        for (g, d) in [
            (Attenuation::Smith, Distribution::beckmann(0.4).unwrap()),
            (Attenuation::Smith, Distribution::trowbridge(0.4).unwrap()),
            (
                Attenuation::HeTorrance,
                Distribution::beckmann(0.4).unwrap(),
            ),
        ] {
            let (limit, near) = (
                g.one_sided_over_cos(&d, 0.0),
                g.one_sided_over_cos(&d, 1e-7),
            );
            assert!(
                (near / limit - 1.0).abs() < 1e-5,
                "{g:?} {d:?}: {near} {limit}"
            );
        }
    }

    #[test]
    fn the_printed_term_is_not_smiths() {
        let d = Distribution::beckmann(0.4).unwrap();
        let cos = 0.5;
        let smith = Attenuation::Smith.one_sided(&d, cos);
        let printed = Attenuation::HeTorrance.one_sided(&d, cos);
        assert!((smith - 0.9963).abs() < 5e-5, "{smith}");
        assert!((seen(Attenuation::HeTorrance, &d, 60.0) - 1.0).abs() > 0.1);
        assert!(printed < 0.9, "{printed}");
    }
}
