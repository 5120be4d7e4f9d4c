//! The basic patch BRDF, f = 1/(π min(1, R²)) where m ≤ R (4.2, 4.7).

use crate::error::above;
use crate::geometry::{below_horizon, metric_squared};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{PatchDisc, PatchMethod};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// The basic patch with radius R, above 0 and at most 2; R = 2 is Lambert.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    radius: f64,
    constant: f64,
}

impl Patch {
    /// With c(R) = 1/(π min(1, R²)) (4.7): albedo 1 at the normal.
    pub fn new(radius: f64) -> Result<Self, ParameterError> {
        let radius = above("radius", radius, 0.0, 2.0)?;
        Ok(Self {
            radius,
            constant: 1.0 / (PI * (radius * radius).min(1.0)),
        })
    }

    /// The radius R.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Whether V's projection is within R of the mirrored projection of L; at R = 2
    /// always, without a comparison.
    fn covers(&self, l: &Direction, v: &Direction) -> bool {
        self.radius == 2.0 || metric_squared(l, v) <= self.radius * self.radius
    }

    /// The albedo (4.8) in closed form: the share of the circle that is inside the base circle.
    pub fn exact_albedo(&self, cos_theta: f64) -> f64 {
        self.constant * lens_area(self.radius, cos_theta)
    }
}

/// The area common to the unit circle and one of radius `r` (above 0) whose centre lies
/// where a direction of cosine `c` (0 … 1) projects, at d = √(1 − c²) (4.9, 4.10).
///
/// 1 − d is formed from the cosine, so that small circles at grazing angles lose nothing.
pub fn lens_area(r: f64, c: f64) -> f64 {
    let d = ((1.0 - c) * (1.0 + c)).max(0.0).sqrt();
    let short = c * c / (1.0 + d);
    if d <= (1.0 - r).abs() && (r >= 1.0 || r <= short) {
        return PI * r.min(1.0).powi(2);
    }
    // Sides 1, r, d of a triangle; the two sectors less the kite.
    let kite = ((short + r) * (r - short) * (d + 1.0 - r) * (d + r + 1.0))
        .max(0.0)
        .sqrt();
    let a = kite.atan2(r * r - c * c);
    let b = kite.atan2(d * d + 1.0 - r * r);
    r * r * a + b - 0.5 * kite
}

impl Brdf for Patch {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) || !self.covers(l, v) {
            0.0
        } else {
            self.constant
        }
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) || !self.covers(l, v) {
            [0.0; 3]
        } else {
            [l.z; 3]
        }
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, self.radius).with_edges(&[self.radius])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch",
    source: "(4.2), (4.7)",
    formula: "1/(π min(1, R²)) where m ≤ R",
    parameters: "R above 0 and at most 2",
    reciprocal: true,
    grazing: "f bounded; albedo at least 0.391",
    examples: || {
        vec![
            example("R = 0.5", Patch::new(0.5).expect("in range"), Conserves),
            example("R = 1", Patch::new(1.0).expect("in range"), Conserves),
        ]
    },
    sampler: Some(|v, visit| {
        for (radius, method) in [
            (0.5, PatchMethod::Rejection),
            (1.2, PatchMethod::Rejection),
            (0.5, PatchMethod::Roulette),
        ] {
            let m = Patch::new(radius).expect("in range");
            visit(&m, &PatchDisc::new(radius, v, method));
        }
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, models::Lambert};

    #[test]
    fn quadrature_equals_the_lens() {
        for r in [1e-3, 0.2, 0.7, 1.0, 1.3, 1.9, 2.0] {
            let m = Patch::new(r).unwrap();
            for degrees in [0.0, 20.0, 44.0, 70.0, 89.9, 90.0] {
                let l = Direction::from_degrees(degrees, 0.0);
                let a = directional_albedo_at(&m, degrees);
                let exact = m.exact_albedo(l.z);
                assert!(
                    (a.value - exact).abs() < 1e-10,
                    "R = {r}, {degrees}: {a:?} {exact}"
                );
            }
        }
    }

    #[test]
    fn radius_two_is_lambert() {
        let (m, lambert) = (Patch::new(2.0).unwrap(), Lambert::grey(1.0).unwrap());
        for degrees in [0.0, 50.0, 90.0] {
            let l = Direction::from_degrees(degrees, 0.0);
            assert_eq!(m.eval(&l, &l), lambert.eval(&l, &l));
            assert_eq!(
                m.reflect(&l, &l.mirrored()),
                lambert.reflect(&l, &l.mirrored())
            );
        }
        assert!(Patch::new(2.0 + 1e-12).is_err() && Patch::new(0.0).is_err());
    }

    #[test]
    fn the_bound_0_391_is_at_the_horizon() {
        // 2/3 − √3/2π at R = 1.
        let m = Patch::new(1.0).unwrap();
        let bound = 2.0 / 3.0 - 3f64.sqrt() / (2.0 * PI);
        assert!((m.exact_albedo(0.0) - bound).abs() < 1e-15);
    }
}
