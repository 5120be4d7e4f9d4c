//! The retro-reflective basic patch: as (4.2) with the metric about L (4.29).

use super::Patch;
use crate::error::above;
use crate::geometry::{below_horizon, retro_metric_squared};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{PatchDisc, PatchMethod};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// The basic patch about L with radius R, above 0 and at most 2; its albedo is [`Patch`]'s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchRetro {
    radius: f64,
    constant: f64,
}

impl PatchRetro {
    /// With c(R) = 1/(π min(1, R²)).
    pub fn new(radius: f64) -> Result<Self, ParameterError> {
        let radius = above("radius", radius, 0.0, 2.0)?;
        Ok(Self {
            radius,
            constant: 1.0 / (PI * (radius * radius).min(1.0)),
        })
    }

    /// The albedo in closed form.
    pub fn exact_albedo(&self, cos_theta: f64) -> f64 {
        Patch::new(self.radius)
            .expect("checked")
            .exact_albedo(cos_theta)
    }
}

impl Brdf for PatchRetro {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let r = self.radius;
        let covers = r == 2.0 || retro_metric_squared(l, v) <= r * r;
        if below_horizon(l, v) || !covers {
            0.0
        } else {
            self.constant
        }
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::RetroPlane, self.radius).with_edges(&[self.radius])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_retro",
    source: "(4.29)",
    formula: "1/(π min(1, R²)) where |L_P − V_P| ≤ R",
    parameters: "R above 0 and at most 2",
    reciprocal: true,
    grazing: "as the basic patch's",
    examples: || {
        vec![example(
            "R = 0.5",
            PatchRetro::new(0.5).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = PatchRetro::new(0.5).expect("in range");
        visit(&m, &PatchDisc::retro(0.5, v, PatchMethod::Rejection));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_patch_is_about_the_light() {
        let m = PatchRetro::new(0.5).unwrap();
        let l = Direction::from_degrees(70.0, 0.0);
        assert!(m.eval(&l, &l) > 1.0);
        assert_eq!(m.eval(&l, &l.mirrored()), 0.0);
        let a = directional_albedo_at(&m, 70.0);
        assert!((a.value - m.exact_albedo(l.z)).abs() < 1e-10, "{a:?}");
    }
}
