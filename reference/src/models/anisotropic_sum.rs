//! Sums of anisotropic metallic Phong lobes (3.16).

use super::AnisotropicPhong;
use crate::error::within;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::Chart;
use crate::sampling::{Choice, Sampler};
use crate::{Brdf, Direction, ParameterError};

/// Σ wᵢ fᵢ of [`AnisotropicPhong`] lobes, each normalised by itself, with Σ wᵢ ≤ 1.
#[derive(Debug, Clone, PartialEq)]
pub struct AnisotropicSum {
    terms: Vec<(f64, AnisotropicPhong)>,
}

impl AnisotropicSum {
    /// At least one term; weights 0 … 1 with a sum of at most 1.
    pub fn new(terms: &[(f64, AnisotropicPhong)]) -> Result<Self, ParameterError> {
        let mut sum = 0.0;
        for (w, _) in terms {
            sum += within("weight", *w, 0.0, 1.0)?;
        }
        if terms.is_empty() || sum > 1.0 + 4.0 * f64::EPSILON {
            let given = format!("{sum} over {} terms", terms.len());
            return Err(ParameterError::new(
                "weights",
                given,
                "a sum of at most 1, one term or more",
            ));
        }
        Ok(Self {
            terms: terms.to_vec(),
        })
    }
}

impl Brdf for AnisotropicSum {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let sum: f64 = self
            .terms
            .iter()
            .map(|(w, f)| if *w == 0.0 { 0.0 } else { w * f.eval(l, v) })
            .sum();
        sum.min(f64::MAX)
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.terms
            .iter()
            .map(|(_, f)| f.chart(l))
            .min_by(|a, b| a.scale.total_cmp(&b.scale))
            .unwrap_or_else(Chart::cosine)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        out.push(l.z - v.z);
    }

    fn is_isotropic(&self) -> bool {
        self.terms.iter().all(|(_, f)| f.is_isotropic())
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "anisotropic_sum",
    source: "(3.16)",
    formula: "Σ wᵢ fᵢ of anisotropic Phong lobes",
    parameters: "weights wᵢ 0 … 1 with a sum of at most 1",
    reciprocal: true,
    grazing: "the sum of its lobes'",
    examples: || {
        let wide = AnisotropicPhong::new([1.0; 3], 4.0, 1.0).expect("in range");
        let narrow = AnisotropicPhong::new([0.9, 1.0, 1.0], 40.0, 1.0).expect("in range");
        vec![example(
            "0.4 × (1, 1, 1), n = 4 and 0.6 × (0.9, 1, 1), n = 40, p = 1",
            AnisotropicSum::new(&[(0.4, wide), (0.6, narrow)]).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let wide = AnisotropicPhong::new([1.0; 3], 4.0, 1.0).expect("in range");
        let narrow = AnisotropicPhong::new([0.9, 1.0, 1.0], 40.0, 1.0).expect("in range");
        let m = AnisotropicSum::new(&[(0.4, wide), (0.6, narrow)]).expect("in range");
        let parts: Vec<(f64, Box<dyn Sampler>)> = (m.terms.iter())
            .map(|(w, f)| (*w, Box::new(f.directions(&m, v)) as Box<dyn Sampler>))
            .collect();
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_is_the_weighted_sum() {
        let (a, b) = (
            AnisotropicPhong::new([1.0; 3], 8.0, 1.0).unwrap(),
            AnisotropicPhong::new([0.9, 1.0, 1.0], 30.0, 0.5).unwrap(),
        );
        let m = AnisotropicSum::new(&[(0.3, a), (0.7, b)]).unwrap();
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(60.0, 170.0),
        );
        let expected = 0.3 * a.eval(&l, &v) + 0.7 * b.eval(&l, &v);
        assert!((m.eval(&l, &v) - expected).abs() < 1e-14);
        assert!(AnisotropicSum::new(&[(0.6, a), (0.6, b)]).is_err());
        assert!(AnisotropicSum::new(&[]).is_err());
    }
}
