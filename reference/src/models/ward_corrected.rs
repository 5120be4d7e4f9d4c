//! Ward divided by cosΘmin, f = C/(4πσxσy) e^(−…)/max(NL, NV) (3.36), isotropic and not.

use super::ward_anisotropic::exponent;
use crate::albedo::greatest_albedo;
use crate::error::within;
use crate::geometry::{below_horizon, bounded_ratio, over_cos_theta_min};
use crate::half::Half;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// The corrected Ward model with slope deviations along x and y, each 1e-4 … 10.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WardCorrected {
    x: f64,
    y: f64,
    constant: f64,
}

impl WardCorrected {
    /// Isotropic, with C_max, 1 over the greatest albedo, found numerically (Table 3.2).
    pub fn new(m: f64) -> Result<Self, ParameterError> {
        Self::anisotropic(m, m)
    }

    /// Anisotropic, with C_max found numerically.
    pub fn anisotropic(sigma_x: f64, sigma_y: f64) -> Result<Self, ParameterError> {
        let mut model = Self::unnormalised(sigma_x, sigma_y)?;
        model.constant /= greatest_albedo(&model).1.value;
        Ok(model)
    }

    /// With C = 1, which loses a little energy.
    pub fn unnormalised(sigma_x: f64, sigma_y: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            x: within("sigma_x", sigma_x, 1e-4, 10.0)?,
            y: within("sigma_y", sigma_y, 1e-4, 10.0)?,
            constant: 1.0 / (4.0 * PI * sigma_x * sigma_y),
        })
    }

    /// C_max: the peak times 4πσxσy.
    pub fn greatest_constant(&self) -> f64 {
        self.constant * 4.0 * PI * self.x * self.y
    }

    fn lobe(&self, l: &Direction, v: &Direction) -> f64 {
        match Half::of(l, v) {
            Some(h) if h.z > 0.0 => (-exponent(&h, self.x, self.y)).exp(),
            Some(_) => 0.0,
            None => 1.0,
        }
    }
}

impl Brdf for WardCorrected {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        over_cos_theta_min(self.constant * self.lobe(l, v), l, v, 1.0)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [self.lobe(l, v) * bounded_ratio(l, v, 1.0); 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Half, (self.x * self.y).sqrt())
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(l.z - v.z);
    }

    fn is_isotropic(&self) -> bool {
        self.x == self.y
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "ward_corrected",
    source: "(3.36), Table 3.2",
    formula: "C/(4πσxσy) e^(−tan²δ(…))/max(NL, NV)",
    parameters: "σx, σy 1e-4 … 10",
    reciprocal: true,
    grazing: "radiance bounded; albedo falls",
    examples: || {
        vec![
            example(
                "m = 0.2",
                WardCorrected::new(0.2).expect("in range"),
                Conserves,
            ),
            example(
                "σ = 0.3, 0.1",
                WardCorrected::anisotropic(0.3, 0.1).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_constant_is_one_plus_four_m_squared() {
        for m in [0.02, 0.01] {
            let c = WardCorrected::new(m).unwrap().greatest_constant();
            assert!(
                (c - 1.0 - 4.0 * m * m).abs() < 3.0 * m.powi(4),
                "m = {m}: {c}"
            );
        }
    }

    #[test]
    fn the_albedo_stays_below_one_at_grazing_angles() {
        let m = WardCorrected::new(0.1).unwrap();
        for degrees in [80.0, 89.0, 89.99, 89.9995, 90.0] {
            assert!(directional_albedo_at(&m, degrees).value < 1.0, "{degrees}");
        }
    }
}
