//! Metallic paint, f = C e^(−s·m) F(θ') (4.51, 4.54), θ' from the retro-reflective metric (4.53).

use super::patch_exponential::PatchExponential;
use super::tint::Tint;
use crate::brdf::luminance;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, gold};
use crate::quadrature::Chart;
use crate::sampling::{Mixture, MixtureMethod, Weighted};
use crate::{Brdf, Direction, ParameterError};

/// cosθ' with sinθ' = |L_P − V_P|/2 (4.53), by |h_P|²/4 + (NL² + NV²)/2: no cancellation.
pub fn cos_theta_prime(l: &Direction, v: &Direction) -> f64 {
    let h2 = crate::geometry::metric_squared(l, v);
    (0.25 * h2 + 0.5 * (l.z * l.z + v.z * v.z)).sqrt().min(1.0)
}

/// The exponential patch model coloured by Fresnel's reflectance.
///
/// The constant is (4.45)'s; the print's s²/2π (4.48) is 0.05 % below it at s = 10.
#[derive(Debug, Clone, PartialEq)]
pub struct MetallicPaint {
    shape: PatchExponential,
    tint: Tint,
}

impl MetallicPaint {
    /// Sharpness 0 … 1e8 (above 10 in the text), and one index for each channel or a metal.
    pub fn new(sharpness: f64, tint: impl Into<Tint>) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PatchExponential::new(sharpness)?,
            tint: tint.into(),
        })
    }

    fn fresnel(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.tint.at(cos_theta_prime(l, v))
    }
}

impl Brdf for MetallicPaint {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        luminance(self.eval_rgb(l, v))
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let f = self.shape.eval(l, v);
        self.fresnel(l, v).map(|r| f * r)
    }

    fn is_coloured(&self) -> bool {
        self.tint.is_coloured()
    }

    fn peak(&self) -> f64 {
        self.shape.peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let rho = self.shape.rho(l, v)[0];
        self.fresnel(l, v).map(|r| rho * r)
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.shape.chart(l)
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "metallic_paint",
    source: "(4.51) to (4.54)",
    formula: "C e^(−s·m) F(θ'), sinθ' = |L_P − V_P|/2",
    parameters: "s 0 … 1e8; a metal's name, or η and k of each channel",
    reciprocal: true,
    grazing: "f bounded; albedo at least half of F's",
    examples: || {
        vec![example(
            "gold's indices, s = 12",
            MetallicPaint::new(12.0, gold()).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let m = MetallicPaint::new(12.0, gold()).expect("in range");
        let shape = PatchExponential::new(12.0).expect("in range");
        let mixture = Mixture::exponential(&shape, v, MixtureMethod::Redraw);
        visit(&m, &Weighted::new(&m, v, Box::new(mixture)));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fresnel::Index;

    #[test]
    fn the_angle_is_that_of_the_retro_metric() {
        for (t, p) in [(20.0, 30.0), (85.0, 180.0), (60.0, 0.0)] {
            let (l, v) = (
                Direction::from_degrees(50.0, 0.0),
                Direction::from_degrees(t, p),
            );
            let m = crate::geometry::retro_metric_squared(&l, &v).sqrt();
            let expected = (0.5 * m).asin().cos();
            assert!((cos_theta_prime(&l, &v) - expected).abs() < 1e-12);
        }
        // In the mirror direction it is the angle of incidence.
        let l = Direction::from_degrees(70.0, 10.0);
        assert!((cos_theta_prime(&l, &l.mirrored()) - l.z).abs() < 1e-15);
        assert!((cos_theta_prime(&l, &l) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_peak_is_coloured_by_the_angle_of_incidence() {
        let i = [0.3, 0.6, 1.5].map(|eta| Index::new(eta, 2.5).unwrap());
        let m = MetallicPaint::new(20.0, i).unwrap();
        let l = Direction::from_degrees(65.0, 0.0);
        for (k, f) in m.eval_rgb(&l, &l.mirrored()).into_iter().enumerate() {
            assert!((f / (m.peak() * i[k].reflectance(l.z)) - 1.0).abs() < 1e-13);
        }
    }
}
