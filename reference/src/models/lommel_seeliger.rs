//! Hapke–Lommel–Seeliger, f = ρ/π · B(γ) S(γ)/(NL + NV) (1.52 to 1.54 as corrected).
//!
//! The retrodirective function B is B. Hapke, *A theoretical photometric function for
//! the lunar surface*, J. Geophys. Res. 68 (1963) 4571–4586; γ is the phase angle
//! between L and V and h his compactness, which the print calls g both times.

use crate::error::within;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// The scattering of a single grain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scattering {
    /// S = 1.
    Isotropic,
    /// S = 4/9 (1 − ½ cosγ) (1.53).
    Forward,
    /// S = (sinγ + (π − γ) cosγ)/π (1.54 as corrected): 1 at γ = 0.
    Backward,
}

/// Hapke–Lommel–Seeliger with ρ (0 … 1), compactness h (0 … 10; 0 for B = 1) and scattering.
///
/// It does not conserve energy: with ρ = S = B = 1 the albedo is
/// 2(1 − cosΘ ln(1 + 1/cosΘ)), above 1 for cosΘ < 0.398 and 2 at the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LommelSeeliger {
    rho: f64,
    compactness: f64,
    scattering: Scattering,
}

impl LommelSeeliger {
    /// A compactness of 0 leaves the opposition effect out.
    pub fn new(rho: f64, compactness: f64, scattering: Scattering) -> Result<Self, ParameterError> {
        Ok(Self {
            rho: within("rho", rho, 0.0, 1.0)?,
            compactness: within("compactness", compactness, 0.0, 10.0)?,
            scattering,
        })
    }

    /// The albedo for ρ = S = B = 1 in closed form.
    pub fn plain_albedo(cos_theta: f64) -> f64 {
        if cos_theta == 0.0 {
            return 2.0;
        }
        2.0 * (1.0 - cos_theta * (1.0 / cos_theta).ln_1p())
    }

    fn retrodirective(&self, phase: f64) -> f64 {
        let h = self.compactness;
        if h == 0.0 || phase >= FRAC_PI_2 {
            return 1.0;
        }
        if phase == 0.0 {
            return 2.0;
        }
        let t = phase.tan();
        let e = (-h / t).exp();
        2.0 - t / (2.0 * h) * (1.0 - e) * (3.0 - e)
    }

    fn scatter(&self, phase: f64) -> f64 {
        match self.scattering {
            Scattering::Isotropic => 1.0,
            Scattering::Forward => 4.0 / 9.0 * (1.0 - 0.5 * phase.cos()),
            Scattering::Backward => (phase.sin() + (PI - phase) * phase.cos()) / PI,
        }
    }
}

impl Brdf for LommelSeeliger {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        // The angle from the chord: exact near the opposition.
        let chord2 = 2.0 * crate::geometry::retro_versine(l, v);
        let phase = 2.0 * (0.5 * chord2.sqrt()).min(1.0).asin();
        let value = self.rho * FRAC_1_PI * self.retrodirective(phase) * self.scatter(phase);
        if value == 0.0 {
            0.0
        } else {
            (value / (l.z + v.z)).min(f64::MAX)
        }
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        if self.compactness > 0.0 {
            // B has a kink at a phase angle of 90°.
            out.push(l.dot(*v));
        }
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "lommel_seeliger",
    source: "(1.52) to (1.54), Hapke 1963",
    formula: "ρ/π · B(γ) S(γ)/(NL + NV)",
    parameters: "ρ 0 … 1; compactness 0 … 10; isotropic, forward or backward S",
    reciprocal: true,
    grazing: "f unbounded; the albedo tends to 2 for ρ = S = B = 1",
    examples: || {
        vec![
            example(
                "ρ = 1, S = B = 1",
                LommelSeeliger::new(1.0, 0.0, Scattering::Isotropic).expect("in range"),
                Exceeds,
            ),
            example(
                "ρ = 1, h = 0.4, backward",
                LommelSeeliger::new(1.0, 0.4, Scattering::Backward).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo;

    #[test]
    fn the_plain_form_has_its_closed_albedo() {
        let m = LommelSeeliger::new(1.0, 0.0, Scattering::Isotropic).unwrap();
        for c in [0.01, 0.2, 0.398, 1.0] {
            let a = directional_albedo(&m, c);
            assert!(
                (a.value - LommelSeeliger::plain_albedo(c)).abs() < 1e-9,
                "{c}: {a:?}"
            );
        }
        assert!(LommelSeeliger::plain_albedo(0.398) > 1.0 - 1e-3);
        assert!(LommelSeeliger::plain_albedo(0.399) < 1.0);
        assert!((LommelSeeliger::plain_albedo(1e-12) - 2.0).abs() < 1e-9);
    }

    #[test]
    fn opposition_doubles_and_joins_at_90_degrees() {
        let m = LommelSeeliger::new(1.0, 0.4, Scattering::Backward).unwrap();
        assert_eq!(m.retrodirective(0.0), 2.0);
        assert!((m.retrodirective(1e-9) - 2.0).abs() < 1e-8);
        assert!((m.retrodirective(FRAC_PI_2 - 1e-9) - 1.0).abs() < 1e-6);
        // The printed minus would make grains scatter negatively.
        assert!((m.scatter(0.01) - 0.999_95).abs() < 1e-5 && m.scatter(3.0) > 0.0);
    }
}
