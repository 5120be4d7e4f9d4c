//! A metal of patches, f = C ξ(m) F(Θmin): (4.51) with the angle of (3.29).

use super::patch::Patch;
use super::patch_exponential::PatchExponential;
use super::tint::Tint;
use crate::brdf::luminance;
use crate::geometry::{below_horizon, cos_theta_min};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, gold};
use crate::quadrature::Chart;
use crate::sampling::{Mixture, MixtureMethod, Weighted};
use crate::{Brdf, Direction, ParameterError};

/// The basic patch or the exponential mixture, coloured by Fresnel's reflectance at Θmin.
///
/// It equals [`super::MetallicPaint`] in the mirror direction, where θ' = Θmin.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchMetal {
    shape: PatchShape,
    tint: Tint,
}

#[derive(Debug, Clone, PartialEq)]
enum PatchShape {
    Basic(Patch),
    Exponential(PatchExponential),
}

impl PatchMetal {
    /// The basic patch of a radius above 0 and at most 2.
    pub fn basic(radius: f64, tint: impl Into<Tint>) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PatchShape::Basic(Patch::new(radius)?),
            tint: tint.into(),
        })
    }

    /// The exponential mixture of sharpness 0 … 1e8.
    pub fn exponential(sharpness: f64, tint: impl Into<Tint>) -> Result<Self, ParameterError> {
        Ok(Self {
            shape: PatchShape::Exponential(PatchExponential::new(sharpness)?),
            tint: tint.into(),
        })
    }

    fn shape(&self) -> &dyn Brdf {
        match &self.shape {
            PatchShape::Basic(patch) => patch,
            PatchShape::Exponential(mixture) => mixture,
        }
    }
}

impl Brdf for PatchMetal {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        luminance(self.eval_rgb(l, v))
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let f = self.shape().eval(l, v);
        self.tint.at(cos_theta_min(l, v)).map(|r| f * r)
    }

    fn is_coloured(&self) -> bool {
        self.tint.is_coloured()
    }

    fn peak(&self) -> f64 {
        self.shape().peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let rho = self.shape().rho(l, v)[0];
        self.tint.at(cos_theta_min(l, v)).map(|r| rho * r)
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.shape().chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(l.z - v.z);
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_metal",
    source: "(4.51), (3.29)",
    formula: "C ξ(m) F(Θmin)",
    parameters: "R above 0 and at most 2, or s 0 … 1e8; a metal's name, or η and k of each channel",
    reciprocal: true,
    grazing: "f bounded; albedo at least 0.391 of F's",
    examples: || {
        vec![
            example(
                "gold's indices, s = 10",
                PatchMetal::exponential(10.0, gold()).expect("in range"),
                Conserves,
            ),
            example(
                "gold's indices, R = 0.5",
                PatchMetal::basic(0.5, gold()).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let m = PatchMetal::exponential(10.0, gold()).expect("in range");
        let shape = PatchExponential::new(10.0).expect("in range");
        let mixture = Mixture::exponential(&shape, v, MixtureMethod::Redraw);
        visit(&m, &Weighted::new(&m, v, Box::new(mixture)));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::MetallicPaint;

    #[test]
    fn it_is_the_paint_in_the_mirror_direction_only() {
        let (metal, paint) = (
            PatchMetal::exponential(8.0, gold()).unwrap(),
            MetallicPaint::new(8.0, gold()).unwrap(),
        );
        let l = Direction::from_degrees(70.0, 0.0);
        let both = |v: &Direction| (metal.eval_rgb(&l, v)[2], paint.eval_rgb(&l, v)[2]);
        let (a, b) = both(&l.mirrored());
        assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
        let (a, b) = both(&Direction::from_degrees(20.0, 160.0));
        assert!((a / b - 1.0).abs() > 1e-3, "{a} {b}");
    }

    #[test]
    fn fresnel_is_taken_at_the_smaller_angle() {
        let m = PatchMetal::basic(2.0, gold()).unwrap();
        let (l, v) = (
            Direction::from_degrees(20.0, 0.0),
            Direction::from_degrees(75.0, 180.0),
        );
        for (f, index) in m.eval_rgb(&l, &v).into_iter().zip(gold()) {
            let expected = std::f64::consts::FRAC_1_PI * index.reflectance(l.z);
            assert!((f / expected - 1.0).abs() < 1e-14);
        }
        assert_eq!(m.eval_rgb(&l, &v), m.eval_rgb(&v, &l));
    }
}
