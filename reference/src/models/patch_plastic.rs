//! Patch plastic, f = a_d/π + (1 − a_d) C e^(−s·m) F(θ') (4.55).

use super::metallic_paint::cos_theta_prime;
use super::patch_exponential::PatchExponential;
use crate::brdf::luminance;
use crate::error::channels_within;
use crate::fresnel::Index;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, index};
use crate::quadrature::Chart;
use crate::sampling::{Choice, Cosine, Mixture, MixtureMethod, Sampler};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::FRAC_1_PI;

/// A Lambertian body under an exponential patch highlight with a (real) index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchPlastic {
    albedo: [f64; 3],
    shape: PatchExponential,
    index: Index,
}

impl PatchPlastic {
    /// a_d of each channel (0 … 1), sharpness (0 … 1e8), index.
    pub fn new(albedo: [f64; 3], sharpness: f64, index: Index) -> Result<Self, ParameterError> {
        Ok(Self {
            albedo: channels_within("albedo", albedo, 0.0, 1.0)?,
            shape: PatchExponential::new(sharpness)?,
            index,
        })
    }
}

impl Brdf for PatchPlastic {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.is_coloured() {
            luminance(f)
        } else {
            f[0]
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let highlight = self.shape.eval(l, v) * self.index.reflectance(cos_theta_prime(l, v));
        self.albedo.map(|a| a * FRAC_1_PI + (1.0 - a) * highlight)
    }

    fn is_coloured(&self) -> bool {
        self.albedo[0] != self.albedo[1] || self.albedo[0] != self.albedo[2]
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.shape.chart(l)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_plastic",
    source: "(4.55)",
    formula: "a_d/π + (1 − a_d) C e^(−s·m) F(θ')",
    parameters: "a_d 0 … 1 of each channel; s 0 … 1e8; index",
    reciprocal: true,
    grazing: "f bounded",
    examples: || {
        vec![example(
            "a_d = 0.5, 0.3, 0.1, s = 30, glass",
            PatchPlastic::new([0.5, 0.3, 0.1], 30.0, index(1.5, 0.0)).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let glass = index(1.5, 0.0);
        let m = PatchPlastic::new([0.5, 0.3, 0.1], 30.0, glass).expect("in range");
        let highlight = Mixture::exponential(&m.shape, v, MixtureMethod::Redraw);
        let body = luminance(m.albedo);
        let parts: Vec<(f64, Box<dyn Sampler>)> = vec![
            (body, Box::new(Cosine::new(&m, v))),
            ((1.0 - body) * glass.reflectance(v.z), Box::new(highlight)),
        ];
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_white_body_leaves_no_room_for_the_highlight() {
        let glass = Index::new(1.5, 0.0).unwrap();
        let m = PatchPlastic::new([1.0, 0.5, 0.0], 30.0, glass).unwrap();
        let n = Direction::NORMAL;
        let f = m.eval_rgb(&n, &n);
        assert_eq!(f[0], FRAC_1_PI);
        let c = super::super::patch_exponential::greatest_constant(30.0);
        assert!((f[2] - 0.04 * c).abs() < 1e-12);
    }
}
