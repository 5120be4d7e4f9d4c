//! Plastic with a Fresnel term, f = a_d/π + a_s c_n cosⁿα/cosΘmin F(Θmin) (3.30).

use crate::brdf::luminance;
use crate::error::channels_within;
use crate::fresnel::Index;
use crate::geometry::{below_horizon, cos_theta_min};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, index};
use crate::models::{Energy, PModel};
use crate::quadrature::Chart;
use crate::sampling::{Choice, Cosine, PhongLobe, Sampler};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::FRAC_1_PI;

/// A Lambertian body under a highlight with a (usually real) index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticFresnel {
    albedo: [f64; 3],
    specular: [f64; 3],
    index: Index,
    shape: PModel,
    peak: f64,
}

impl PlasticFresnel {
    /// a_d and a_s of each channel, 0 … 1 with greatest sum 1, the index, exponent 0 … 1e8.
    ///
    /// The peak is the sum of both parts' greatest values, with F at its greatest, 1.
    pub fn new(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
        index: Index,
    ) -> Result<Self, ParameterError> {
        let albedo = channels_within("albedo", albedo, 0.0, 1.0)?;
        let greatest = |c: [f64; 3]| c[0].max(c[1]).max(c[2]);
        let room = 1.0 - greatest(albedo);
        // One rounding step of room: 0.7 + 0.3 must pass.
        let specular = channels_within("specular", specular, 0.0, room + f64::EPSILON)?;
        let shape = PModel::new(exponent, 1.0, Energy::Published)?;
        Ok(Self {
            albedo,
            specular,
            index,
            shape,
            peak: greatest(albedo) * FRAC_1_PI + greatest(specular) * shape.peak(),
        })
    }
}

impl Brdf for PlasticFresnel {
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
        let fresnel = self.index.reflectance(cos_theta_min(l, v));
        let highlight = fresnel * self.shape.eval(l, v);
        [0, 1, 2].map(|i| (self.albedo[i] * FRAC_1_PI + self.specular[i] * highlight).min(f64::MAX))
    }

    fn reflect(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let fresnel = self.index.reflectance(cos_theta_min(l, v));
        let highlight = fresnel * self.shape.reflect(l, v)[0];
        [0, 1, 2].map(|i| self.albedo[i] * FRAC_1_PI * l.z + self.specular[i] * highlight)
    }

    fn peak(&self) -> f64 {
        self.peak
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if self.peak == 0.0 {
            return [0.0; 3];
        }
        self.reflect(l, v).map(|r| r / self.peak)
    }

    fn is_coloured(&self) -> bool {
        [self.albedo, self.specular]
            .iter()
            .any(|c| c[0] != c[1] || c[0] != c[2])
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.shape.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.shape.creases(l, v, out);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "plastic_fresnel",
    source: "(3.30)",
    formula: "a_d/π + a_s c_n cosⁿα/cosΘmin F(Θmin)",
    parameters: "a_d and a_s with a greatest sum of 1; n 0 … 1e8; index",
    reciprocal: true,
    grazing: "the highlight grows with F",
    examples: || {
        vec![example(
            "a_d = 0.3, a_s = 0.7, n = 50, glass",
            PlasticFresnel::new([0.3; 3], [0.7; 3], 50.0, index(1.5, 0.0)).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = PlasticFresnel::new([0.3; 3], [0.7; 3], 50.0, index(1.5, 0.0)).expect("in range");
        let highlight = luminance(m.specular) * m.index.reflectance(v.z);
        let parts: Vec<(f64, Box<dyn Sampler>)> = vec![
            (luminance(m.albedo), Box::new(Cosine::new(&m, v))),
            (
                highlight,
                Box::new(PhongLobe::new(&m, m.shape.exponent(), v)),
            ),
        ];
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_highlight_brightens_towards_grazing() {
        let glass = Index::new(1.5, 0.0).unwrap();
        let m = PlasticFresnel::new([0.3, 0.2, 0.1], [0.7; 3], 100.0, glass).unwrap();
        let highlight = |degrees: f64| {
            let l = Direction::from_degrees(degrees, 0.0);
            m.reflect(&l, &l.mirrored())[2] - 0.1 * FRAC_1_PI * l.z
        };
        let c = 102.0 / std::f64::consts::TAU;
        assert!((highlight(0.0) - 0.7 * 0.04 * c).abs() < 1e-12);
        assert!(highlight(85.0) > 10.0 * highlight(0.0));
        assert!(PlasticFresnel::new([0.4; 3], [0.7; 3], 9.0, glass).is_err());
    }
}
