//! Lafortune, f = ρ/π + Σ (Cx LxVx + Cy LyVy + Cz LzVz)ⁿ (1.66; the slides' sum of lobes).

use crate::error::within;
use crate::geometry::below_horizon;
use crate::models::EXPONENT_MAX;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::{Choice, Cosine, PhongLobe, Sampler};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::FRAC_1_PI;

/// One lobe: the diagonal of the matrix and the exponent. A negative base gives 0.
///
/// (−1, −1, 1) is a Phong lobe, (1, 1, 1) retro-reflective, (−1, −1, ½) off-specular.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LafortuneLobe {
    /// Cx, Cy, Cz, each finite and −100 … 100.
    pub weights: [f64; 3],
    /// The exponent n, 0 … 1e8.
    pub exponent: f64,
}

/// A diffuse part and any number of lobes, with the constants as given.
///
/// Nothing bounds its albedo but the constants: see [`crate::albedo::greatest_albedo`].
#[derive(Debug, Clone, PartialEq)]
pub struct Lafortune {
    diffuse: f64,
    lobes: Vec<LafortuneLobe>,
}

impl Lafortune {
    /// Diffuse albedo (0 … 1) and lobes.
    pub fn new(diffuse: f64, lobes: &[LafortuneLobe]) -> Result<Self, ParameterError> {
        for lobe in lobes {
            for w in lobe.weights {
                within("weights", w, -100.0, 100.0)?;
            }
            within("exponent", lobe.exponent, 0.0, EXPONENT_MAX)?;
        }
        Ok(Self {
            diffuse: within("diffuse", diffuse, 0.0, 1.0)?,
            lobes: lobes.to_vec(),
        })
    }

    /// One Phong lobe with the energy-conserving constant, as a special case.
    pub fn phong(exponent: f64) -> Result<Self, ParameterError> {
        within("exponent", exponent, 1e-3, EXPONENT_MAX)?;
        let c = super::phong::published_constant(exponent).powf(1.0 / exponent);
        Self::new(
            0.0,
            &[LafortuneLobe {
                weights: [-c, -c, c],
                exponent,
            }],
        )
    }
}

impl Brdf for Lafortune {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let lobes: f64 = self
            .lobes
            .iter()
            .map(|lobe| {
                let [x, y, z] = lobe.weights;
                let base = x * (l.x * v.x) + y * (l.y * v.y) + z * (l.z * v.z);
                if base > 0.0 {
                    base.powf(lobe.exponent)
                } else {
                    0.0
                }
            })
            .sum();
        self.diffuse * FRAC_1_PI + lobes
    }

    fn chart(&self, _l: &Direction) -> Chart {
        let sharpest = self.lobes.iter().map(|l| l.exponent).fold(0.0, f64::max);
        let retro = self.lobes.iter().any(|l| l.weights[0] > 0.0);
        Chart::power(
            if retro {
                ChartKind::Retro
            } else {
                ChartKind::Mirror
            },
            sharpest,
        )
    }

    fn is_isotropic(&self) -> bool {
        self.lobes.iter().all(|l| l.weights[0] == l.weights[1])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "lafortune",
    source: "(1.66), slides",
    formula: "ρ/π + Σ ((Cx LxVx + Cy LyVy + Cz LzVz)⁺)ⁿ",
    parameters: "ρ 0 … 1; Cx, Cy, Cz, n 0 … 1e8 of each lobe: energy is in the constants",
    reciprocal: true,
    grazing: "f bounded: radiance falls to 0",
    examples: || {
        vec![
            example(
                "one Phong lobe, n = 20",
                Lafortune::phong(20.0).expect("in range"),
                Conserves,
            ),
            example(
                "(−1.02, −1.02, 0.8), n = 12: off-specular",
                Lafortune::new(
                    0.0,
                    &[LafortuneLobe {
                        weights: [-1.02, -1.02, 0.8],
                        exponent: 12.0,
                    }],
                )
                .expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let lobe = LafortuneLobe {
            weights: [-1.02, -0.9, 0.8],
            exponent: 12.0,
        };
        let retro = LafortuneLobe {
            weights: [0.7, 0.7, 0.7],
            exponent: 5.0,
        };
        let m = Lafortune::new(0.2, &[lobe, retro]).expect("in range");
        let mut parts: Vec<(f64, Box<dyn Sampler>)> =
            vec![(m.diffuse, Box::new(Cosine::new(&m, v)))];
        for lobe in &m.lobes {
            let directions = PhongLobe::weighted(&m, lobe.weights, lobe.exponent, v);
            parts.push((0.4, Box::new(directions)));
        }
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Phong;

    #[test]
    fn a_phong_lobe_is_phong() {
        let (a, b) = (Lafortune::phong(12.0).unwrap(), Phong::new(12.0).unwrap());
        let l = Direction::from_degrees(40.0, 20.0);
        for (t, p) in [(40.0, 200.0), (60.0, 180.0), (10.0, 100.0)] {
            let v = Direction::from_degrees(t, p);
            let (x, y) = (a.eval(&l, &v), b.eval(&l, &v));
            assert!((x / y - 1.0).abs() < 1e-12, "{x} {y}");
        }
        let low = Direction::from_degrees(60.0, 20.0);
        assert_eq!(a.eval(&low, &low), 0.0);
    }

    #[test]
    fn signs_of_the_weights_turn_the_lobe() {
        let retro = LafortuneLobe {
            weights: [1.0; 3],
            exponent: 9.0,
        };
        let m = Lafortune::new(0.0, &[retro]).unwrap();
        let l = Direction::from_degrees(60.0, 0.0);
        assert!((m.eval(&l, &l) - 1.0).abs() < 1e-12);
        assert_eq!(m.eval(&l, &l.mirrored()), 0.0);
        let off = LafortuneLobe {
            weights: [-1.0, -1.0, 0.5],
            exponent: 9.0,
        };
        let m = Lafortune::new(0.0, &[off]).unwrap();
        let lower = Direction::from_degrees(75.0, 180.0);
        assert!(m.eval(&l, &lower) > m.eval(&l, &l.mirrored()));
    }
}
