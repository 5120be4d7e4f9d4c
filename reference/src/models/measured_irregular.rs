//! Measured data as irregular isotropic samples (Chuang's slides, after pbrt).

use crate::geometry::below_horizon;
use crate::models::Phong;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::{Brdf, Direction, ParameterError, brdf::luminance};
use std::f64::consts::PI;

/// One measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Towards the light.
    pub l: Direction,
    /// Towards the viewer.
    pub v: Direction,
    /// f in sr⁻¹ for red, green and blue.
    pub f: [f64; 3],
}

/// Samples, weighted by e^(−100d²) of their distance in (sinΘL sinΘV, Δφ/π, cosΘL cosΘV).
///
/// The radius starts at d² = 0.001 and doubles until it holds more than two samples (or
/// reaches the whole range). Both directions and both signs of Δφ give the same point, so
/// the model is reciprocal and isotropic whatever the samples are.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredIrregular {
    points: Vec<([f64; 3], [f64; 3])>,
}

impl MeasuredIrregular {
    /// At least one sample, all values finite; negative ones count as 0.
    pub fn new(samples: &[Sample]) -> Result<Self, ParameterError> {
        if samples.is_empty() {
            return Err(ParameterError::new("samples", "none", "at least one"));
        }
        if let Some(bad) = samples.iter().flat_map(|s| s.f).find(|f| !f.is_finite()) {
            return Err(ParameterError::new("samples", bad, "finite"));
        }
        let points = samples.iter().map(|s| (remap(&s.l, &s.v), s.f)).collect();
        Ok(Self { points })
    }
}

fn remap(l: &Direction, v: &Direction) -> [f64; 3] {
    let (sl, sv) = (l.x.hypot(l.y), v.x.hypot(v.y));
    let cos = l.x * v.x + l.y * v.y;
    let sin = (l.x * v.y - l.y * v.x).abs();
    let difference = if sl > 0.0 && sv > 0.0 {
        sin.atan2(cos) / PI
    } else {
        0.0
    };
    [sl * sv, difference, l.z * v.z]
}

impl Brdf for MeasuredIrregular {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        luminance(self.eval_rgb(l, v))
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let at = remap(l, v);
        let distance2 = |p: &[f64; 3]| (0..3).map(|i| (p[i] - at[i]).powi(2)).sum::<f64>();
        let mut reach = 0.001;
        loop {
            let (mut sum, mut weights, mut found) = ([0.0; 3], 0.0, 0);
            for (p, f) in &self.points {
                let d2 = distance2(p);
                if d2 <= reach {
                    let w = (-100.0 * d2).exp();
                    for (s, f) in sum.iter_mut().zip(f) {
                        *s += w * f;
                    }
                    weights += w;
                    found += 1;
                }
            }
            if found > 2 || reach > 1.5 {
                return if weights > 0.0 {
                    sum.map(|s| (s / weights).max(0.0))
                } else {
                    [0.0; 3]
                };
            }
            reach *= 2.0;
        }
    }

    fn is_coloured(&self) -> bool {
        true
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "measured_irregular",
    source: "slides, after pbrt",
    formula: "samples weighted by e^(−100d²) in (sinΘL sinΘV, Δφ/π, cosΘL cosΘV)",
    parameters: "samples (L, V, f)",
    reciprocal: true,
    grazing: "as measured",
    examples: || {
        let phong = Phong::new(3.0).expect("in range");
        let mut samples = Vec::new();
        for i in 0..5 {
            for j in 0..5 {
                for k in 0..4 {
                    let l = Direction::from_degrees(f64::from(i) * 20.0, 0.0);
                    let v = Direction::from_degrees(f64::from(j) * 20.0, f64::from(k) * 60.0);
                    samples.push(Sample {
                        l,
                        v,
                        f: [0.6 * phong.eval(&l, &v); 3],
                    });
                }
            }
        }
        vec![example(
            "100 samples of 0.6 × Phong, n = 3",
            MeasuredIrregular::new(&samples).expect("samples"),
            Conserves,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> MeasuredIrregular {
        let mut samples = Vec::new();
        for i in 0..9 {
            for j in 0..9 {
                for k in 0..7 {
                    let l = Direction::from_degrees(f64::from(i) * 10.0, 0.0);
                    let v = Direction::from_degrees(f64::from(j) * 10.0, f64::from(k) * 30.0);
                    samples.push(Sample {
                        l,
                        v,
                        f: [l.z * v.z, 0.25, -1.0],
                    });
                }
            }
        }
        MeasuredIrregular::new(&samples).unwrap()
    }

    #[test]
    fn a_smooth_function_is_found_again() {
        let m = grid();
        let (l, v) = (
            Direction::from_degrees(35.0, 12.0),
            Direction::from_degrees(47.0, 71.0),
        );
        let f = m.eval_rgb(&l, &v);
        assert!((f[0] - l.z * v.z).abs() < 0.05, "{f:?}");
        assert!((f[1] - 0.25).abs() < 1e-12);
        assert_eq!(f[2], 0.0);
        assert_eq!(f, m.eval_rgb(&v, &l));
    }
}
