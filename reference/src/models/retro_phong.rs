//! Retro-reflective metallic Phong, f = c_n [(L·V)⁺]ⁿ / cosᵖΘmin (3.13; p = 1 there).

use crate::geometry::{
    below_horizon, bounded_ratio, over_cos_theta_min, power_lobe, retro_versine,
};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::models::{Energy, PModel};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// The lobe points back to the light: the p-model with L for R.
///
/// Turning V by 180° about N maps one onto the other, so the albedo is the p-model's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RetroPhong {
    exponent: f64,
    p: f64,
    constant: f64,
}

impl RetroPhong {
    /// Exponent n (0 … 1e8) and p (0 … 1; 1 in the thesis).
    pub fn new(exponent: f64, p: f64, energy: Energy) -> Result<Self, ParameterError> {
        let forward = PModel::new(exponent, p, energy)?;
        Ok(Self {
            exponent,
            p,
            constant: forward.peak(),
        })
    }

    /// The exponent n.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl Brdf for RetroPhong {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let lobe = self.constant * power_lobe(self.exponent, retro_versine(l, v));
        over_cos_theta_min(lobe, l, v, self.p)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        [power_lobe(self.exponent, retro_versine(l, v)) * bounded_ratio(l, v, self.p); 3]
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Retro, self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        if self.p > 0.0 {
            out.push(l.z - v.z);
        }
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "retro_phong",
    source: "(3.13)",
    formula: "c_n [(L·V)⁺]ⁿ/cosᵖΘmin",
    parameters: "n 0 … 1e8; p 0 … 1; published or strict energy",
    reciprocal: true,
    grazing: "as the p-model's",
    examples: || {
        vec![example(
            "n = 20, p = 1",
            RetroPhong::new(20.0, 1.0, Energy::Published).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = RetroPhong::new(20.0, 1.0, Energy::Published).expect("in range");
        visit(&m, &PhongLobe::retro(&m, 20.0, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn albedo_is_the_forward_models_but_the_lobe_is_not() {
        let retro = RetroPhong::new(20.0, 1.0, Energy::Published).unwrap();
        let forward = PModel::new(20.0, 1.0, Energy::Published).unwrap();
        for degrees in [0.0, 30.0, 75.0, 90.0] {
            let (a, b) = (
                directional_albedo_at(&retro, degrees),
                directional_albedo_at(&forward, degrees),
            );
            assert!((a.value - b.value).abs() < 1e-10, "{degrees}: {a:?} {b:?}");
        }
        let l = Direction::from_degrees(50.0, 0.0);
        assert!(retro.eval(&l, &l) > 1.0);
        assert_eq!(retro.eval(&l, &l.mirrored()), 0.0);
    }
}
