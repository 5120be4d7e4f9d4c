//! Linear mixtures of any models, f = Σ cₖ fₖ with Σ cₖ ≤ 1 (5.3).

use crate::brdf::luminance;
use crate::error::within;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::models::{Energy, Lambert, MetallicPhong};
use crate::quadrature::Chart;
use crate::sampling::{Choice, Cosine, PhongLobe, Sampler};
use crate::{Brdf, Direction, ParameterError};

/// Any number of models with weights.
pub struct Mixed {
    parts: Vec<(f64, Box<dyn Brdf>)>,
}

impl Mixed {
    /// At least one part; weights 0 … 1 with a sum of at most 1.
    pub fn new(parts: Vec<(f64, Box<dyn Brdf>)>) -> Result<Self, ParameterError> {
        let mut sum = 0.0;
        for (w, _) in &parts {
            sum += within("weight", *w, 0.0, 1.0)?;
        }
        if parts.is_empty() || sum > 1.0 + 4.0 * f64::EPSILON {
            let given = format!("{sum} over {} parts", parts.len());
            return Err(ParameterError::new(
                "weights",
                given,
                "a sum of at most 1, one part or more",
            ));
        }
        Ok(Self { parts })
    }

    fn sum(&self, f: impl Fn(&dyn Brdf) -> [f64; 3]) -> [f64; 3] {
        let mut total = [0.0; 3];
        for (w, part) in self.parts.iter().filter(|(w, _)| *w > 0.0) {
            for (t, f) in total.iter_mut().zip(f(part.as_ref())) {
                *t += w * f;
            }
        }
        total.map(|t: f64| t.min(f64::MAX))
    }
}

impl Brdf for Mixed {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.is_coloured() {
            luminance(f)
        } else {
            f[0]
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.sum(|b| b.eval_rgb(l, v))
    }

    fn reflect(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.sum(|b| b.reflect(l, v))
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.reflect(l, v)
    }

    fn is_coloured(&self) -> bool {
        self.parts.iter().any(|(_, b)| b.is_coloured())
    }

    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        self.sum(|b| b.delta_weight(l))
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.parts
            .iter()
            .map(|(_, b)| b.chart(l))
            .min_by(|a, b| a.scale.total_cmp(&b.scale))
            .unwrap_or_else(Chart::cosine)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        for (_, b) in &self.parts {
            b.creases(l, v, out);
        }
    }

    fn is_isotropic(&self) -> bool {
        self.parts.iter().all(|(_, b)| b.is_isotropic())
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "mixed",
    source: "(5.3), (5.4)",
    formula: "Σ cₖ fₖ",
    parameters: "weights 0 … 1 with a sum of at most 1; any models",
    reciprocal: true,
    grazing: "the sum of its parts'",
    examples: || {
        vec![example(
            "0.5 Lambert and 0.5 metallic Phong, n = 20",
            Mixed::new(vec![
                (0.5, Box::new(Lambert::grey(1.0).expect("in range"))),
                (
                    0.5,
                    Box::new(MetallicPhong::new(20.0, Energy::Published).expect("in range")),
                ),
            ])
            .expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let lobe = || MetallicPhong::new(20.0, Energy::Published).expect("in range");
        let m = Mixed::new(vec![
            (
                0.5,
                Box::new(Lambert::grey(1.0).expect("in range")) as Box<dyn Brdf>,
            ),
            (0.5, Box::new(lobe())),
        ])
        .expect("in range");
        let part = lobe();
        let parts: Vec<(f64, Box<dyn Sampler>)> = vec![
            (0.5, Box::new(Cosine::new(&m, v))),
            (0.5, Box::new(PhongLobe::new(&part, 20.0, v))),
        ];
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;
    use crate::models::{Lambert, Phong};

    #[test]
    fn albedos_add() {
        let phong = Phong::new(40.0).unwrap();
        let m = Mixed::new(vec![
            (0.25, Box::new(Lambert::grey(0.8).unwrap())),
            (0.5, Box::new(phong)),
        ])
        .unwrap();
        for degrees in [0.0, 70.0] {
            let a = directional_albedo_at(&m, degrees).value;
            let expected = 0.2 + 0.5 * directional_albedo_at(&phong, degrees).value;
            assert!((a - expected).abs() < 1e-9, "{degrees}: {a} {expected}");
        }
        assert!(Mixed::new(vec![(1.5, Box::new(phong) as Box<dyn Brdf>)]).is_err());
    }
}
