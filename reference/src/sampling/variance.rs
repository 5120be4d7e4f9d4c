//! Variance and cost of the ways to sample, measured.

use super::{
    Choice, Cosine, DensityRadii, MetricPatch, Mixture, MixtureMethod, PatchDisc, PatchMethod,
    ProfileRadii, Random, Sampler, Specular, TwoStep,
};
use crate::Direction;
use crate::models::{Metric, Patch, PatchElliptic, PatchExponential, PatchMixture, PatchProfile};

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

/// A row of the table: what was sampled, how, and the result under each light.
pub struct VarianceRow {
    /// The model and the angle of V.
    pub model: String,
    /// The way of sampling.
    pub way: &'static str,
    /// Under uniform light, radiance 1.
    pub uniform: Efficiency,
    /// Under a lamp, cos⁸ about 50° from the normal.
    pub lamp: Efficiency,
}

/// The ways to sample each kind of patch model, `samples` samples each.
pub fn variance_table(samples: u32) -> Vec<VarianceRow> {
    let round = Metric::EUCLIDEAN;
    let patch = Patch::new(0.5).expect("in range");
    let elliptic = PatchElliptic::new(0.4, 0.5).expect("in range");
    let exponential = PatchExponential::new(4.0).expect("in range");
    let density = PatchMixture::new(|r: f64| 0.375 * r * (2.0 - r), 0.2, 0.3).expect("in range");
    let profile = PatchProfile::new(|m: f64| 1.0 / (1.0 + 30.0 * m * m), round).expect("in range");
    let profile_radii = || ProfileRadii::of(&profile).expect("it nowhere increases");
    let (redraw, roulette) = (MixtureMethod::Redraw, MixtureMethod::Roulette);

    let mut rows = Rows {
        samples,
        rows: Vec::new(),
    };
    for degrees in [30.0, 80.0] {
        let v = Direction::from_degrees(degrees, 0.0);
        let mixed = |method| Mixture::exponential(&exponential, v, method);
        let by_density =
            |method| Mixture::new(&density, round, DensityRadii::new(&density), v, method);
        let by_profile = |method| Mixture::new(&profile, round, profile_radii(), v, method);
        let mut add = |model: &str, way, sampler: &dyn Sampler| {
            rows.add(format!("{model}, {degrees}°"), way, sampler);
        };

        let model = "patch R = 0.5";
        add(
            model,
            "redraw",
            &PatchDisc::new(0.5, v, PatchMethod::Rejection),
        );
        add(
            model,
            "roulette",
            &PatchDisc::new(0.5, v, PatchMethod::Roulette),
        );
        add(model, "cosine", &Cosine::new(&patch, v));

        let model = "ellipse b = 0.4, B/A = 0.5";
        add(
            model,
            "redraw",
            &MetricPatch::new(&elliptic, elliptic.metric(), elliptic.b(), v),
        );
        add(model, "cosine", &Cosine::new(&elliptic, v));

        let model = "exponential s = 4";
        add(model, "redraw", &mixed(redraw));
        add(model, "two-step", &TwoStep::new(exponential, v));
        add(model, "roulette", &mixed(roulette));
        add(model, "cosine", &Cosine::new(&exponential, v));

        let model = "p = 0.375 R(2 − R), mirror 0.2, Lambert 0.3";
        add(model, "redraw", &by_density(redraw));
        add(model, "roulette", &by_density(roulette));
        let mirror: Vec<(f64, Box<dyn Sampler>)> = vec![
            (0.8, Box::new(Cosine::new(&density, v))),
            (0.2, Box::new(Specular::new(&density, v))),
        ];
        add(
            model,
            "cosine and mirror",
            &Choice::new(&density, v, mirror),
        );

        let model = "ξ = 1/(1 + 30m²)";
        add(model, "redraw", &by_profile(redraw));
        add(model, "roulette", &by_profile(roulette));
        add(model, "cosine", &Cosine::new(&profile, v));
    }
    rows.rows
}

struct Rows {
    samples: u32,
    rows: Vec<VarianceRow>,
}

impl Rows {
    fn add(&mut self, model: String, way: &'static str, sampler: &dyn Sampler) {
        let lamp = Direction::from_degrees(50.0, 180.0);
        let seed = 1000 + self.rows.len() as u64;
        let measure =
            |light: &dyn Fn(&Direction) -> f64| efficiency(sampler, light, self.samples, seed);
        let row = VarianceRow {
            model,
            way,
            uniform: measure(&|_| 1.0),
            lamp: measure(&|l| l.dot(lamp).max(0.0).powi(8)),
        };
        self.rows.push(row);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::albedo::directional_albedo_for;
    use crate::quadrature::Accuracy;

    #[test]
    fn corrected_patch_sampling_has_constant_weights() {
        let rows = variance_table(20_000);
        let mut redrawn = 0;
        for row in rows.iter().filter(|r| r.way == "redraw") {
            redrawn += 1;
            assert_eq!(row.uniform.variance, 0.0, "{}", row.model);
            let cosine = (rows.iter())
                .find(|r| r.model == row.model && r.way.starts_with("cosine"))
                .expect("a row for the cosine");
            let (own, other) = (row.lamp.product(), cosine.lamp.product());
            assert!(own < other, "{}: {own} {other}", row.model);
        }
        assert_eq!(redrawn, 10);
        let way = |name: &'static str| rows.iter().filter(move |r| r.way == name);
        for row in way("two-step") {
            assert!(row.uniform.variance > 1e-4, "{}", row.model);
        }
        for row in way("roulette") {
            // Weights are 0 or 1.
            let e = row.uniform;
            let bernoulli = e.mean * (1.0 - e.mean);
            assert!((e.variance - bernoulli).abs() < 1e-12, "{}", row.model);
        }
    }

    #[test]
    fn all_ways_have_the_same_mean() {
        // The weights of "redraw" are an albedo by quadrature: roulette and the cosine, whose
        // weights are not, must agree with it.
        let rows = variance_table(20_000);
        for row in &rows {
            let own = (rows.iter())
                .find(|r| r.model == row.model && r.way == "redraw")
                .expect("a row for redrawing");
            for (a, b) in [(row.uniform, own.uniform), (row.lamp, own.lamp)] {
                let error = ((a.variance + b.variance) / 20_000.0).sqrt();
                assert!(
                    (a.mean - b.mean).abs() < 4.0 * error + 1e-9,
                    "{}, {}: {} {}",
                    row.model,
                    row.way,
                    a.mean,
                    b.mean
                );
            }
        }
        let v = Direction::from_degrees(30.0, 0.0);
        let patch = Patch::new(0.5).unwrap();
        let a = directional_albedo_for(&patch, &v, Accuracy::FINE).value;
        assert!((rows[0].uniform.mean - a).abs() < 1e-9);
    }
}
