//! Variance and cost of the ways to sample, measured.

use super::{Cosine, Mixture, MixtureMethod, PatchDisc, PatchMethod, Random, Sampler};
use crate::Direction;
use crate::models::{Patch, PatchExponential};

/// Mean and variance of one sample's contribution, and what it costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Efficiency {
    /// Mean of weight · radiance.
    pub mean: f64,
    /// Variance of one sample.
    pub variance: f64,
    /// Random numbers for one sample, the measure of cost here.
    pub numbers: f64,
}

impl Efficiency {
    /// Variance times cost: smaller is better.
    pub fn product(&self) -> f64 {
        self.variance * self.numbers
    }
}

/// Measures a sampler under a radiance L_in, with seeded random numbers.
pub fn efficiency(
    sampler: &dyn Sampler,
    radiance: &dyn Fn(&Direction) -> f64,
    samples: u32,
    seed: u64,
) -> Efficiency {
    let mut random = Random::new(seed);
    // Welford's running sums: equal weights give a variance of 0, not of rounding.
    let (mut mean, mut square) = (0.0, 0.0);
    for i in 1..=samples {
        let value = sampler
            .sample(&mut || random.uniform())
            .map_or(0.0, |s| s.weight[0] * radiance(&s.direction));
        let before = value - mean;
        mean += before / f64::from(i);
        square += before * (value - mean);
    }
    Efficiency {
        mean,
        variance: square / f64::from(samples),
        numbers: random.count() as f64 / f64::from(samples),
    }
}

/// A row of the table: what was sampled, how, under which light, and the result.
pub type VarianceRow = (String, &'static str, &'static str, Efficiency);

/// Radiance from each direction.
type Radiance = Box<dyn Fn(&Direction) -> f64>;

/// The ways to sample a basic patch and an exponential mixture, under uniform light and
/// under a lamp (cos⁸ about 50° from the normal), `samples` samples each.
pub fn variance_table(samples: u32) -> Vec<VarianceRow> {
    let lamp = Direction::from_degrees(50.0, 180.0);
    let lights: [(&'static str, Radiance); 2] = [
        ("uniform", Box::new(|_| 1.0)),
        ("lamp", Box::new(move |l| l.dot(lamp).max(0.0).powi(8))),
    ];
    let mut rows = Vec::new();
    for degrees in [30.0, 80.0] {
        let v = Direction::from_degrees(degrees, 0.0);
        let patch = Patch::new(0.5).expect("radius in range");
        let mixture = PatchExponential::new(4.0).expect("sharpness in range");
        let samplers: Vec<(&str, &'static str, Box<dyn Sampler + '_>)> = vec![
            (
                "patch R = 0.5",
                "rejection",
                Box::new(PatchDisc::new(0.5, v, PatchMethod::Rejection)),
            ),
            (
                "patch R = 0.5",
                "roulette",
                Box::new(PatchDisc::new(0.5, v, PatchMethod::Roulette)),
            ),
            ("patch R = 0.5", "cosine", Box::new(Cosine::new(&patch, v))),
            (
                "mixture s = 4",
                "redraw",
                Box::new(Mixture::new(mixture, v, MixtureMethod::Redraw)),
            ),
            (
                "mixture s = 4",
                "two-step",
                Box::new(Mixture::new(mixture, v, MixtureMethod::TwoStep)),
            ),
            (
                "mixture s = 4",
                "roulette",
                Box::new(Mixture::new(mixture, v, MixtureMethod::Roulette)),
            ),
            (
                "mixture s = 4",
                "cosine",
                Box::new(Cosine::new(&mixture, v)),
            ),
        ];
        for (i, (model, way, sampler)) in samplers.iter().enumerate() {
            for (light, radiance) in &lights {
                let e = efficiency(sampler.as_ref(), radiance, samples, 1000 + i as u64);
                rows.push((format!("{model}, {degrees}°"), *way, *light, e));
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find<'a>(rows: &'a [VarianceRow], model: &str, way: &str, light: &str) -> &'a Efficiency {
        let row = rows
            .iter()
            .find(|r| r.0 == model && r.1 == way && r.2 == light);
        &row.expect("a row of the table").3
    }

    #[test]
    fn corrected_patch_sampling_has_constant_weights() {
        let rows = variance_table(20_000);
        for degrees in ["30°", "80°"] {
            for (model, way) in [("patch R = 0.5", "rejection"), ("mixture s = 4", "redraw")] {
                let model = format!("{model}, {degrees}");
                let e = find(&rows, &model, way, "uniform");
                assert_eq!(e.variance, 0.0, "{model}");
                let lamp = find(&rows, &model, way, "lamp");
                let cosine = find(&rows, &model, "cosine", "lamp");
                assert!(
                    lamp.product() < cosine.product(),
                    "{model}: {lamp:?} {cosine:?}"
                );
            }
            let printed = find(
                &rows,
                &format!("mixture s = 4, {degrees}"),
                "two-step",
                "uniform",
            );
            assert!(printed.variance > 1e-4, "{printed:?}");
            let roulette = find(
                &rows,
                &format!("mixture s = 4, {degrees}"),
                "roulette",
                "uniform",
            );
            let bernoulli = roulette.mean * (1.0 - roulette.mean);
            assert!((roulette.variance - bernoulli).abs() < 1e-12);
        }
    }
}
