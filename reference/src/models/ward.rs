//! Ward, isotropic, f = e^(−tan²δ/m²)/(4πm² √(NL·NV)) (1.46 as corrected, 2.8, 3.35 with C = 1).

use crate::error::within;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::entry::Claim::Exceeds;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::PI;

/// Ward with slope deviation m, 1e-4 … 10.
///
/// The albedo grows without bound as 1/√cosΘ at grazing angles: for m = 0.1 it is
/// 1.175 at 89.995° and 3.710 at 89.9995°.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ward {
    m: f64,
}

impl Ward {
    /// The specular part with weight 1.
    pub fn new(m: f64) -> Result<Self, ParameterError> {
        Ok(Self {
            m: within("m", m, 1e-4, 10.0)?,
        })
    }
}

impl Brdf for Ward {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let m2 = self.m * self.m;
        let lobe = Half::of(l, v).map_or(1.0, |h| (-h.tan2 / m2).exp());
        if lobe == 0.0 {
            return 0.0;
        }
        (lobe / (4.0 * PI * m2 * (l.z * v.z).sqrt())).min(f64::MAX)
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Half, self.m)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "ward",
    source: "(1.46), (2.8), (3.35)",
    formula: "e^(−tan²δ/m²)/(4πm² √(NL·NV))",
    parameters: "m 1e-4 … 10",
    reciprocal: true,
    grazing: "albedo grows as 1/√cosΘ: 1.175 at 89.995°, 3.710 at 89.9995° for m = 0.1",
    examples: || {
        vec![
            example("m = 0.1", Ward::new(0.1).expect("in range"), Exceeds),
            example("m = 0.2", Ward::new(0.2).expect("in range"), Exceeds),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_albedo_diverges_at_grazing_angles() {
        let m = Ward::new(0.1).unwrap();
        for (degrees, albedo) in [
            (89.995, 1.174_708_723),
            (89.999, 2.623_602_373),
            (89.9995, 3.709_781_647),
        ] {
            let a = directional_albedo_at(&m, degrees);
            assert!((a.value - albedo).abs() < 1e-8, "{degrees}: {a:?}");
        }
    }
}
