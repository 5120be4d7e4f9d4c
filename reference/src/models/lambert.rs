//! Lambert: ideal diffuse reflection, f = a/π (1.28 as corrected).

use crate::error::channels_within;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::sampling::Cosine;
use crate::{Brdf, Direction, ParameterError, brdf::luminance};
use std::f64::consts::FRAC_1_PI;

/// f = a/π with an albedo a of 0 … 1 for each channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lambert {
    albedo: [f64; 3],
}

impl Lambert {
    /// A matt surface of the given albedo for red, green and blue, each 0 … 1.
    pub fn new(albedo: [f64; 3]) -> Result<Self, ParameterError> {
        Ok(Self {
            albedo: channels_within("albedo", albedo, 0.0, 1.0)?,
        })
    }

    /// A grey one.
    pub fn grey(albedo: f64) -> Result<Self, ParameterError> {
        Self::new([albedo; 3])
    }

    /// The albedo of each channel.
    pub fn albedo(&self) -> [f64; 3] {
        self.albedo
    }
}

impl Brdf for Lambert {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if self.is_coloured() {
            luminance(self.eval_rgb(l, v))
        } else {
            self.eval_rgb(l, v)[0]
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        self.albedo.map(|a| a * FRAC_1_PI)
    }

    fn is_coloured(&self) -> bool {
        self.albedo[0] != self.albedo[1] || self.albedo[0] != self.albedo[2]
    }

    fn peak(&self) -> f64 {
        FRAC_1_PI
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        self.albedo.map(|a| a * l.z)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "lambert",
    source: "(1.27), (1.28)",
    formula: "a/π",
    parameters: "a 0 … 1",
    reciprocal: true,
    grazing: "albedo constant",
    examples: || {
        vec![example(
            "a = 1",
            Lambert::grey(1.0).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = Lambert::new([0.9, 0.5, 0.2]).expect("in range");
        visit(&m, &Cosine::new(&m, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn albedo_is_the_parameter_at_every_angle() {
        let m = Lambert::grey(0.8).unwrap();
        for degrees in [0.0, 45.0, 89.9, 90.0] {
            let a = directional_albedo_at(&m, degrees);
            assert!((a.value - 0.8).abs() < 1e-12, "{degrees}: {a:?}");
        }
    }

    #[test]
    fn parameters_are_checked() {
        assert!(Lambert::grey(1.0 + 1e-9).is_err());
        assert!(Lambert::new([0.1, f64::NAN, 0.1]).is_err());
    }
}
