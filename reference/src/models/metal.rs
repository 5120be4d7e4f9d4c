//! Metal, f = c_n cosⁿα F(Θmin) / cosΘmin = cosⁿα / g(Θmin) (3.29), with the exact
//! Fresnel equations for each channel.

use crate::brdf::luminance;
use crate::colour::MetalName;
use crate::geometry::{below_horizon, cos_theta_min};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::models::{Energy, PModel, Tint};
use crate::quadrature::Chart;
use crate::sampling::PhongLobe;
use crate::{Brdf, Direction, ParameterError};

/// A metal: metallic Phong, coloured by the Fresnel reflectance at Θmin.
#[derive(Debug, Clone, PartialEq)]
pub struct Metal {
    shape: PModel,
    tint: Tint,
}

impl Metal {
    /// From the complex index η + ik of each channel.
    pub fn from_indices(exponent: f64, eta: [f64; 3], k: [f64; 3]) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PModel::new(exponent, 1.0, Energy::Published)?,
            tint: Tint::from_indices(eta, k)?,
        })
    }

    /// From a metal's measured spectrum, integrated to linear sRGB under D65.
    ///
    /// The channels are not clipped (see [`crate::colour::metal_rgb`]).
    pub fn named(exponent: f64, metal: MetalName) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PModel::new(exponent, 1.0, Energy::Published)?,
            tint: Tint::named(metal),
        })
    }

    /// F(Θmin) for each channel at the given cosine.
    pub fn fresnel(&self, cos_theta: f64) -> [f64; 3] {
        self.tint.at(cos_theta)
    }
}

impl Brdf for Metal {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        luminance(self.eval_rgb(l, v))
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let f = self.shape.eval(l, v);
        self.fresnel(cos_theta_min(l, v))
            .map(|r| (f * r).clamp(-f64::MAX, f64::MAX))
    }

    fn is_coloured(&self) -> bool {
        true
    }

    fn peak(&self) -> f64 {
        self.shape.peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let rho = self.shape.rho(l, v)[0];
        self.fresnel(cos_theta_min(l, v)).map(|r| rho * r)
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
    name: "metal",
    source: "(3.29)",
    formula: "c_n cosⁿα F(Θmin)/cosΘmin = cosⁿα/g(Θmin)",
    parameters: "n 0 … 1e8; a metal's name, or η and k of each channel",
    reciprocal: true,
    grazing: "as metallic Phong; the colour fades to white",
    examples: || {
        vec![
            example(
                "gold (spectrum), n = 20",
                Metal::named(20.0, MetalName::Gold).expect("in range"),
                Conserves,
            ),
            example(
                "η = 1.5, 0.9, 0.2, k = 1.8, 2.4, 3.5, n = 500",
                Metal::from_indices(500.0, [1.5, 0.9, 0.2], [1.8, 2.4, 3.5]).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let m = Metal::named(80.0, MetalName::Copper).expect("in range");
        visit(&m, &PhongLobe::new(&m, 80.0, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fresnel_is_taken_at_the_smaller_angle() {
        let m = Metal::from_indices(4.0, [0.2, 0.5, 1.5], [3.0, 2.0, 1.8]).unwrap();
        let (l, v) = (
            Direction::from_degrees(20.0, 0.0),
            Direction::from_degrees(75.0, 180.0),
        );
        let shape = PModel::new(4.0, 1.0, Energy::Published).unwrap();
        let f = m.eval_rgb(&l, &v);
        for (i, (eta, k)) in [(0.2, 3.0), (0.5, 2.0), (1.5, 1.8)].into_iter().enumerate() {
            let expected = shape.eval(&l, &v) * crate::fresnel::conductor(eta, k, l.z);
            assert!((f[i] / expected - 1.0).abs() < 1e-14, "channel {i}");
        }
        assert_eq!(m.eval_rgb(&l, &v), m.eval_rgb(&v, &l));
    }

    #[test]
    fn gold_is_redder_than_blue_and_white_at_grazing() {
        let m = Metal::named(20.0, MetalName::Gold).unwrap();
        let [r, g, b] = m.fresnel(1.0);
        assert!(r > g && g > b && b < 0.5, "{r} {g} {b}");
        for c in m.fresnel(0.0) {
            assert!((c - 1.0).abs() < 1e-12);
        }
    }
}
