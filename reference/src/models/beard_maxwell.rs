//! Beard–Maxwell (1.55), with the first-surface term as in the literature.
//!
//! The print's shadowing term is garbled. This is the form of J. R. Maxwell, J. Beard,
//! S. Weiner, D. Ladd, *Bidirectional reflectance model validation and utilization*,
//! AFAL-TR-73-303 (1973), as H. B. Westlund and G. W. Meyer, *A BRDF database employing
//! the Beard-Maxwell reflection model* (Graphics Interface 2002), give it:
//! F(β)/F(0) · f_ZBS(δ) cos²δ/(NL·NV) · (1 + (δ/Ω) e^(−2β/τ))/(1 + δ/Ω),
//! with β between L and H. The measured zero-bistatic curve f_ZBS(δ) is supplied.

use crate::error::{above, within};
use crate::fresnel::Index;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example, index};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// A painted coating: diffuse, first-surface and volumetric parts.
///
/// Its energy depends on the measured curve; the volumetric part alone is
/// Lommel–Seeliger's, whose albedo grows to twice its value at the normal's side.
#[derive(Debug, Clone, PartialEq)]
pub struct BeardMaxwell {
    diffuse: f64,
    volumetric: f64,
    index: Index,
    tau: f64,
    omega: f64,
    /// f_ZBS at equal steps of δ from 0 to 90°.
    first_surface: Vec<f64>,
}

impl BeardMaxwell {
    /// Diffuse albedo ρ_D (0 … 1), volumetric ρ_V (0 … 1, sr⁻¹), index of the binder,
    /// τ and Ω in radians (above 0), and f_ZBS (≥ 0) at equal steps of δ from 0 to 90°.
    pub fn new(
        diffuse: f64,
        volumetric: f64,
        index: Index,
        tau: f64,
        omega: f64,
        first_surface: &[f64],
    ) -> Result<Self, ParameterError> {
        if first_surface.len() < 2 {
            return Err(ParameterError::new(
                "first_surface",
                format!("{} values", first_surface.len()),
                "at least 2 values, from 0 to 90 degrees",
            ));
        }
        for &f in first_surface {
            within("first_surface", f, 0.0, 1e12)?;
        }
        Ok(Self {
            diffuse: within("diffuse", diffuse, 0.0, 1.0)?,
            volumetric: within("volumetric", volumetric, 0.0, 1.0)?,
            index,
            tau: above("tau", tau, 0.0, f64::INFINITY)?,
            omega: above("omega", omega, 0.0, f64::INFINITY)?,
            first_surface: first_surface.to_vec(),
        })
    }

    fn first(&self, delta: f64) -> f64 {
        let last = self.first_surface.len() - 1;
        let x = (delta / FRAC_PI_2 * last as f64).clamp(0.0, last as f64);
        let i = (x as usize).min(last - 1);
        let t = x - i as f64;
        self.first_surface[i] * (1.0 - t) + self.first_surface[i + 1] * t
    }
}

impl Brdf for BeardMaxwell {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let Some(h) = Half::of(l, v) else {
            return f64::MAX;
        };
        let delta = h.tan2.sqrt().atan();
        let beta = h.lh.min(1.0).acos();
        let shadow = (1.0 + delta / self.omega * (-2.0 * beta / self.tau).exp())
            / (1.0 + delta / self.omega);
        let fresnel = self.index.reflectance(h.lh) / self.index.reflectance(1.0);
        let numerator = fresnel * self.first(delta) * h.cos * h.cos * shadow;
        let surface = if numerator == 0.0 {
            0.0
        } else {
            numerator / (l.z * v.z)
        };
        let volume = if self.volumetric == 0.0 {
            0.0
        } else {
            2.0 * self.volumetric / h.z
        };
        (self.diffuse * FRAC_1_PI + surface + volume).min(f64::MAX)
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Half, 0.3)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "beard_maxwell",
    source: "(1.55), first-surface term from Maxwell et al. 1973, Westlund and Meyer 2002",
    formula: "ρ_D/π + F(β)/F(0) f_ZBS(δ) cos²δ/(NL·NV) · shadowing + 2ρ_V/(NL + NV)",
    parameters: "ρ_D, ρ_V 0 … 1; index; τ, Ω above 0; measured f_ZBS(δ)",
    reciprocal: true,
    grazing: "unbounded: f_ZBS/(NL·NV), and ρ_V/(NL + NV)",
    examples: || {
        vec![example(
            "ρ_D = 0.1, ρ_V = 0.05, glass, τ = 0.3, Ω = 0.5, f_ZBS = 0.3 to 0",
            BeardMaxwell::new(0.1, 0.05, index(1.5, 0.0), 0.3, 0.5, &[0.3, 0.1, 0.02, 0.0])
                .expect("in range"),
            Exceeds,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_bistatic_gives_back_the_measured_curve() {
        let index = Index::new(1.5, 0.0).unwrap();
        let curve = [4.0, 2.0, 0.5, 0.0];
        let m = BeardMaxwell::new(0.0, 0.0, index, 0.3, 0.5, &curve).unwrap();
        // L = V at δ: the Fresnel ratio, the shadowing and cos²δ/cos²δ are 1.
        for (degrees, value) in [(0.0, 4.0), (30.0, 2.0), (45.0, 1.25), (60.0, 0.5)] {
            let d = Direction::from_degrees(degrees, 10.0);
            assert!(
                (m.eval(&d, &d) - value).abs() < 1e-7,
                "{degrees}: {}",
                m.eval(&d, &d)
            );
        }
        assert!(BeardMaxwell::new(0.0, 0.0, index, 0.3, 0.5, &[1.0]).is_err());
    }
}
