//! The basic patch in the p-th power norm (4.38).

use super::Metric;
use crate::error::above;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind, Estimate, adaptive};
use crate::sampling::MetricPatch;
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A constant where V's projection is in a ball of the p-norm about R's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchPNorm {
    radius: f64,
    p: f64,
    metric: Metric,
    constant: f64,
}

impl PatchPNorm {
    /// Radius above 0 and at most 2, B/A above 0 and at most 1, p of 1 … 100.
    ///
    /// The constant is 1 over the area inside the base circle at L = N, where the albedo of
    /// a convex symmetric patch is greatest; found by quadrature.
    pub fn new(radius: f64, ratio: f64, p: f64) -> Result<Self, ParameterError> {
        let radius = above("radius", radius, 0.0, 2.0)?;
        let metric = Metric::power(ratio, p)?;
        // In polar coordinates the ball reaches to radius/‖(cosφ, sinφ)‖.
        let area = adaptive(
            &mut |phi| {
                let reach = radius / metric.length(phi.cos(), phi.sin());
                Estimate {
                    value: 2.0 * reach.min(1.0).powi(2),
                    error: 0.0,
                }
            },
            &[0.0, FRAC_PI_4, FRAC_PI_2],
            1e-13,
            400,
        );
        Ok(Self {
            radius,
            p,
            metric,
            constant: 1.0 / area.value,
        })
    }
}

impl Brdf for PatchPNorm {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) || self.metric.distance(l, v) > self.radius {
            0.0
        } else {
            self.constant
        }
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, self.radius).with_edges(&[self.radius])
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(self.metric.distance(l, v) - self.radius);
    }

    fn is_isotropic(&self) -> bool {
        self.p == 2.0 && self.metric.is_isotropic()
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_p_norm",
    source: "(4.38)",
    formula: "c where ((B/A |x|)ᵖ + |y|ᵖ)^(1/p) ≤ R",
    parameters: "R above 0 and at most 2; B/A above 0 and at most 1; p 1 … 100",
    reciprocal: true,
    grazing: "f bounded",
    examples: || {
        vec![example(
            "R = 0.5, B/A = 0.7, p = 4",
            PatchPNorm::new(0.5, 0.7, 4.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        for (ratio, p) in [(0.7, 4.0), (0.4, 1.0)] {
            let m = PatchPNorm::new(0.5, ratio, p).expect("in range");
            visit(&m, &MetricPatch::new(&m, m.metric, m.radius, v));
        }
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::PatchElliptic;

    #[test]
    fn p_2_is_elliptic_and_p_1_a_rhombus() {
        let (a, b) = (
            PatchPNorm::new(0.5, 0.4, 2.0).unwrap(),
            PatchElliptic::new(0.5, 0.4).unwrap(),
        );
        assert!((a.peak() / b.peak() - 1.0).abs() < 1e-11);
        // Half diagonals 0.25 and 0.25.
        let rhombus = PatchPNorm::new(0.25, 1.0, 1.0).unwrap();
        assert!((rhombus.peak() - 8.0).abs() < 1e-11);
        // Sides 0.4 in the limit of large p.
        let square = PatchPNorm::new(0.2, 1.0, 100.0).unwrap();
        assert!((square.peak() * 0.16 - 1.0).abs() < 1e-3);
    }
}
