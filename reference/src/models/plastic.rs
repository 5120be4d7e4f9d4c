//! Plastic, f = (r, g, b)/π + a_s c_n cosⁿα / cosΘmin (3.31).

use crate::error::channels_within;
use crate::geometry::{below_horizon, bounded_ratio, over_cos_theta_min, power_lobe, versine};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::models::phong::published_constant;
use crate::models::{EXPONENT_MAX, Energy, PModel};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{Choice, Cosine, PhongLobe, Sampler};
use crate::{Brdf, Direction, ParameterError, brdf::luminance};
use std::f64::consts::FRAC_1_PI;

/// A Lambertian body under a metallic Phong highlight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plastic {
    albedo: [f64; 3],
    specular: [f64; 3],
    exponent: f64,
    constant: f64,
    peak: f64,
}

impl Plastic {
    /// Diffuse albedo and specular weight, each channel 0 … 1, exponent 0 … 1e8.
    ///
    /// The greatest specular weight and the greatest albedo must not exceed 1 together.
    /// The peak is the sum of both parts' greatest values.
    pub fn new(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
    ) -> Result<Self, ParameterError> {
        let albedo = channels_within("albedo", albedo, 0.0, 1.0)?;
        let specular = channels_within("specular", specular, 0.0, 1.0)?;
        let exponent = crate::error::within("exponent", exponent, 0.0, EXPONENT_MAX)?;
        let greatest = |c: [f64; 3]| c[0].max(c[1]).max(c[2]);
        let room = 1.0 - greatest(albedo);
        // One rounding step of room: 0.7 + 0.3 must pass.
        if greatest(specular) > room + f64::EPSILON {
            return Err(ParameterError::new(
                "specular",
                greatest(specular),
                format!("at most 1 less the greatest albedo, {room}"),
            ));
        }
        let constant = published_constant(exponent);
        Ok(Self {
            albedo,
            specular,
            exponent,
            constant,
            peak: greatest(albedo) * FRAC_1_PI + greatest(specular) * constant,
        })
    }

    /// With one specular weight for all channels.
    pub fn white_highlight(
        albedo: [f64; 3],
        specular: f64,
        exponent: f64,
    ) -> Result<Self, ParameterError> {
        Self::new(albedo, [specular; 3], exponent)
    }

    fn highlight(&self) -> PModel {
        PModel::new(self.exponent, 1.0, Energy::Published).expect("checked at construction")
    }
}

impl Brdf for Plastic {
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
        let lobe = self.constant * power_lobe(self.exponent, versine(l, v));
        [0, 1, 2].map(|i| {
            let diffuse = self.albedo[i] * FRAC_1_PI;
            (diffuse + over_cos_theta_min(self.specular[i] * lobe, l, v, 1.0)).min(f64::MAX)
        })
    }

    fn is_coloured(&self) -> bool {
        [self.albedo, self.specular]
            .iter()
            .any(|c| c[0] != c[1] || c[0] != c[2])
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

    fn reflect(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let lobe = power_lobe(self.exponent, versine(l, v)) * bounded_ratio(l, v, 1.0);
        [0, 1, 2]
            .map(|i| self.albedo[i] * FRAC_1_PI * l.z + self.specular[i] * self.constant * lobe)
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Mirror, self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.highlight().creases(l, v, out);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "plastic",
    source: "(3.31)",
    formula: "(r, g, b)/π + a_s c_n cosⁿα/cosΘmin",
    parameters: "albedo and specular 0 … 1 with a greatest sum of 1; n 0 … 1e8",
    reciprocal: true,
    grazing: "the highlight keeps its radiance",
    examples: || {
        vec![example(
            "albedo 0.6, 0.3, 0.1, specular 0.3, n = 50",
            Plastic::white_highlight([0.6, 0.3, 0.1], 0.3, 50.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = Plastic::white_highlight([0.6, 0.3, 0.1], 0.3, 50.0).expect("in range");
        let parts: Vec<(f64, Box<dyn Sampler>)> = vec![
            (luminance(m.albedo), Box::new(Cosine::new(&m, v))),
            (
                luminance(m.specular),
                Box::new(PhongLobe::new(&m, m.exponent, v)),
            ),
        ];
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{directional_albedo_at, models::MetallicPhong};

    #[test]
    fn the_albedo_is_the_sum_of_the_parts() {
        let m = Plastic::white_highlight([0.5; 3], 0.3, 500.0).unwrap();
        let lobe = MetallicPhong::new(500.0, Energy::Published).unwrap();
        for degrees in [0.0, 60.0, 88.0, 90.0] {
            let (a, b) = (
                directional_albedo_at(&m, degrees),
                directional_albedo_at(&lobe, degrees),
            );
            assert!(
                (a.value - 0.5 - 0.3 * b.value).abs() < 1e-9,
                "{degrees}: {a:?} {b:?}"
            );
        }
    }

    #[test]
    fn together_at_most_one() {
        assert!(Plastic::white_highlight([0.7, 0.1, 0.1], 0.3, 20.0).is_ok());
        let e = Plastic::white_highlight([0.7, 0.1, 0.1], 0.31, 20.0).unwrap_err();
        assert_eq!(e.parameter, "specular");
    }
}
