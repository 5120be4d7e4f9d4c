//! Ward's convenient form with a diffuse part (1.48):
//! a_D/π + a_S e^(−2((Hu/σx)² + (Hv/σy)²)/(1 + NH)) / (4πσxσy √(NL·NV)).

use crate::error::within;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, PI};

/// The approximation of tan²δ by 2 sin²δ/(1 + cosδ), with weights a_D + a_S ≤ 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WardConvenient {
    diffuse: f64,
    specular: f64,
    x: f64,
    y: f64,
}

impl WardConvenient {
    /// Weights 0 … 1 with a sum of at most 1; slope deviations 1e-4 … 10.
    pub fn new(
        diffuse: f64,
        specular: f64,
        sigma_x: f64,
        sigma_y: f64,
    ) -> Result<Self, ParameterError> {
        let diffuse = within("diffuse", diffuse, 0.0, 1.0)?;
        Ok(Self {
            diffuse,
            specular: within("specular", specular, 0.0, 1.0 - diffuse + f64::EPSILON)?,
            x: within("sigma_x", sigma_x, 1e-4, 10.0)?,
            y: within("sigma_y", sigma_y, 1e-4, 10.0)?,
        })
    }
}

impl Brdf for WardConvenient {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let lobe = Half::of(l, v).map_or(1.0, |h| {
            let length = 2.0 * h.lh;
            let (u, w) = (h.h[0] / (length * self.x), h.h[1] / (length * self.y));
            (-2.0 * (u * u + w * w) / (1.0 + h.cos)).exp()
        });
        let diffuse = self.diffuse * FRAC_1_PI;
        if lobe == 0.0 || self.specular == 0.0 {
            return diffuse;
        }
        let specular = self.specular * lobe / (4.0 * PI * self.x * self.y * (l.z * v.z).sqrt());
        (diffuse + specular).min(f64::MAX)
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Half, (self.x * self.y).sqrt())
    }

    fn is_isotropic(&self) -> bool {
        self.x == self.y
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "ward_convenient",
    source: "(1.48)",
    formula: "a_D/π + a_S e^(−2((Hu/σx)² + (Hv/σy)²)/(1 + NH))/(4πσxσy √(NL·NV))",
    parameters: "a_D + a_S at most 1; σx, σy 1e-4 … 10",
    reciprocal: true,
    grazing: "as Ward's",
    examples: || {
        vec![example(
            "a_D = 0.3, a_S = 0.7, σ = 0.3, 0.1",
            WardConvenient::new(0.3, 0.7, 0.3, 0.1).expect("in range"),
            Exceeds,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::WardAnisotropic;

    #[test]
    fn near_the_peak_it_is_wards() {
        let (a, b) = (
            WardConvenient::new(0.0, 1.0, 0.1, 0.05).unwrap(),
            WardAnisotropic::new(0.1, 0.05).unwrap(),
        );
        let (l, v) = (
            Direction::from_degrees(30.0, 0.0),
            Direction::from_degrees(33.0, 178.0),
        );
        assert!((a.eval(&l, &v) / b.eval(&l, &v) - 1.0).abs() < 2e-3);
        assert!(WardConvenient::new(0.5, 0.6, 0.1, 0.1).is_err());
    }
}
