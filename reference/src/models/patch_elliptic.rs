//! The elliptic basic patch (4.32 to 4.36).

use super::Metric;
use crate::error::above;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::MetricPatch;
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_PI_2, PI};

/// A constant where V's projection is in an ellipse about R's, with the half axes b along
/// y and b·A/B along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchElliptic {
    b: f64,
    ratio: f64,
    metric: Metric,
    constant: f64,
}

impl PatchElliptic {
    /// b above 0 and at most 2, B/A above 0 and at most 1 (1 is [`super::Patch`]).
    ///
    /// The constant is 1 over the area of the ellipse that is inside the base circle
    /// when L = N, where the albedo is greatest.
    pub fn new(b: f64, ratio: f64) -> Result<Self, ParameterError> {
        let b = above("b", b, 0.0, 2.0)?;
        let metric = Metric::elliptic(ratio)?;
        Ok(Self {
            b,
            ratio,
            metric,
            constant: 1.0 / centred_area(b, ratio),
        })
    }

    /// The half axis b along y.
    pub fn b(&self) -> f64 {
        self.b
    }

    /// The metric whose ball of radius b the patch is.
    pub fn metric(&self) -> Metric {
        self.metric
    }

    /// The half axis along x.
    pub fn a(&self) -> f64 {
        self.b / self.ratio
    }
}

/// The area of the unit circle inside a concentric ellipse of half axes b/ratio and b.
pub fn centred_area(b: f64, ratio: f64) -> f64 {
    let a = b / ratio;
    if a <= 1.0 {
        return PI * a * b;
    }
    if b >= 1.0 {
        return PI;
    }
    // Where the outlines cross; the circle bounds the sectors about ±x, the ellipse the rest.
    let y2 = (1.0 - 1.0 / (a * a)) / (1.0 / (b * b) - 1.0 / (a * a));
    let phi = y2.sqrt().asin();
    let t = (a * phi.sin()).atan2(b * phi.cos());
    2.0 * phi + 2.0 * a * b * (FRAC_PI_2 - t)
}

impl Brdf for PatchElliptic {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) || self.metric.distance(l, v) > self.b {
            0.0
        } else {
            self.constant
        }
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, self.b).with_edges(&[self.b, self.a()])
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(self.metric.distance(l, v) - self.b);
    }

    fn is_isotropic(&self) -> bool {
        self.ratio == 1.0
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_elliptic",
    source: "(4.32) to (4.36)",
    formula: "c(b) where √((B/A x)² + y²) ≤ b",
    parameters: "b above 0 and at most 2; B/A above 0 and at most 1",
    reciprocal: true,
    grazing: "f bounded",
    examples: || {
        vec![example(
            "b = 0.4, B/A = 0.5",
            PatchElliptic::new(0.4, 0.5).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = PatchElliptic::new(0.4, 0.5).expect("in range");
        visit(&m, &MetricPatch::new(&m, m.metric(), m.b(), v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo, models::Patch};

    #[test]
    fn the_albedo_is_one_at_the_normal() {
        for (b, ratio) in [(0.2, 0.5), (0.5, 0.4), (0.9, 0.3), (1.4, 0.6)] {
            let m = PatchElliptic::new(b, ratio).unwrap();
            let a = directional_albedo(&m, 1.0);
            assert!((a.value - 1.0).abs() < 1e-9, "b = {b}, {ratio}: {a:?}");
        }
    }

    #[test]
    fn a_circle_is_the_basic_patch_and_an_ellipse_is_long_along_x() {
        let (a, b) = (
            PatchElliptic::new(0.4, 1.0).unwrap(),
            Patch::new(0.4).unwrap(),
        );
        let l = Direction::from_degrees(30.0, 70.0);
        assert_eq!(a.eval(&l, &l.mirrored()), b.eval(&l, &l.mirrored()));
        let m = PatchElliptic::new(0.3, 0.5).unwrap();
        let n = Direction::NORMAL;
        assert!(m.eval(&n, &Direction::from_degrees(30.0, 0.0)) > 0.0);
        assert_eq!(m.eval(&n, &Direction::from_degrees(30.0, 90.0)), 0.0);
    }
}
