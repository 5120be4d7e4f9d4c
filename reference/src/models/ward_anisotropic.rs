//! Ward, anisotropic (1.47), f = e^(−tan²δ(cos²φ/σx² + sin²φ/σy²))/(4πσxσy √(NL·NV)).

use crate::error::within;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// Ward with slope deviations along x and y, each 1e-4 … 10; equal ones are [`super::Ward`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WardAnisotropic {
    x: f64,
    y: f64,
}

impl WardAnisotropic {
    /// The specular part with weight 1.
    pub fn new(sigma_x: f64, sigma_y: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            x: within("sigma_x", sigma_x, 1e-4, 10.0)?,
            y: within("sigma_y", sigma_y, 1e-4, 10.0)?,
        })
    }
}

/// The exponent tan²δ(cos²φ/σx² + sin²φ/σy²), from the components of h.
pub(crate) fn exponent(h: &Half, x: f64, y: f64) -> f64 {
    let (a, b) = (h.h[0] / (h.z * x), h.h[1] / (h.z * y));
    a * a + b * b
}

impl Brdf for WardAnisotropic {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let lobe = match Half::of(l, v) {
            Some(h) if h.z > 0.0 => (-exponent(&h, self.x, self.y)).exp(),
            Some(_) => 0.0,
            None => 1.0,
        };
        if lobe == 0.0 {
            return 0.0;
        }
        (lobe / (4.0 * PI * self.x * self.y * (l.z * v.z).sqrt())).min(f64::MAX)
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
    name: "ward_anisotropic",
    source: "(1.47)",
    formula: "e^(−tan²δ(cos²φ/σx² + sin²φ/σy²))/(4πσxσy √(NL·NV))",
    parameters: "σx, σy 1e-4 … 10",
    reciprocal: true,
    grazing: "as Ward's",
    examples: || {
        vec![example(
            "σ = 0.3, 0.1",
            WardAnisotropic::new(0.3, 0.1).expect("in range"),
            Exceeds,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lobe_is_wider_along_the_rougher_axis() {
        let m = WardAnisotropic::new(0.4, 0.1).unwrap();
        let n = Direction::NORMAL;
        let (x, y) = (
            Direction::from_degrees(30.0, 0.0),
            Direction::from_degrees(30.0, 90.0),
        );
        let t2 = 15f64.to_radians().tan().powi(2);
        let ratio = m.eval(&n, &x) / m.eval(&n, &y);
        assert!((ratio / (t2 * (100.0 - 6.25)).exp() - 1.0).abs() < 1e-12);
    }
}
