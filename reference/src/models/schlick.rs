//! Schlick, f = Z A G(NL) G(NV)/(4π NL NV) (1.49, 1.50).

use crate::error::above;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// Schlick's model with smoothness r (above 0, at most 1; small is smooth) and isotropy p
/// (above 0, at most 1; 1 is isotropic).
///
/// w, which the text leaves open, is the cosine between the projection of H and +x, as in
/// C. Schlick, *An inexpensive BRDF model for physically-based rendering* (1994).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schlick {
    r: f64,
    p: f64,
}

impl Schlick {
    /// The non-diffuse part without a Fresnel term.
    pub fn new(r: f64, p: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            r: above("r", r, 0.0, 1.0)?,
            p: above("p", p, 0.0, 1.0)?,
        })
    }
}

impl Brdf for Schlick {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let (r, p) = (self.r, self.p);
        let (cos2, w2) = match Half::of(l, v) {
            Some(h) => (h.cos * h.cos, h.azimuth2().0),
            None => (1.0, 1.0),
        };
        let zenith = r / (1.0 - (1.0 - r) * cos2).powi(2);
        let azimuth = (p / (p * p + (1.0 - p * p) * w2)).sqrt();
        // G(x)/x = 1/(r + (1 − r)x): finite at the horizon.
        let shade = (r + (1.0 - r) * l.z) * (r + (1.0 - r) * v.z);
        zenith * azimuth / (4.0 * PI * shade)
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Half, self.r.sqrt())
    }

    fn is_isotropic(&self) -> bool {
        self.p == 1.0
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "schlick",
    source: "(1.49), (1.50), Schlick 1994",
    formula: "Z A/(4π (r + (1 − r)NL)(r + (1 − r)NV))",
    parameters: "r above 0 and at most 1; p above 0 and at most 1",
    reciprocal: true,
    grazing: "f bounded, but the albedo exceeds 1 for small r",
    examples: || {
        vec![
            example(
                "r = 0.1, p = 1",
                Schlick::new(0.1, 1.0).expect("in range"),
                Exceeds,
            ),
            example(
                "r = 0.5, p = 0.6",
                Schlick::new(0.5, 0.6).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_1_PI;

    #[test]
    fn fully_rough_is_a_quarter_of_lambert() {
        // r = p = 1: Z = A = G = 1, f = 1/4π: the diffuse end of (1.50).
        let m = Schlick::new(1.0, 1.0).unwrap();
        let (l, v) = (
            Direction::from_degrees(30.0, 0.0),
            Direction::from_degrees(50.0, 40.0),
        );
        assert!((m.eval(&l, &v) - 0.25 * FRAC_1_PI).abs() < 1e-16);
    }

    #[test]
    fn anisotropy_prefers_half_vectors_across_x() {
        let m = Schlick::new(0.2, 0.3).unwrap();
        let l = Direction::NORMAL;
        let (along, across) = (
            Direction::from_degrees(30.0, 0.0),
            Direction::from_degrees(30.0, 90.0),
        );
        assert!(m.eval(&l, &across) > 3.0 * m.eval(&l, &along));
    }
}
