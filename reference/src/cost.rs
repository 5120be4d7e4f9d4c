//! What an evaluation costs, for counting by callgrind.
//!
//! The example `cost` evaluates one model a number of times; the example `count_cost` runs
//! it under callgrind twice with different numbers: the difference is exact and free of
//! everything that happens once.

use crate::models::*;
use crate::sampling::Random;
use crate::{Brdf, Direction};

/// A model that costs nothing: what is left is the loop.
struct Nothing;

impl Brdf for Nothing {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        l.z + v.z
    }
}

/// Instructions for one evaluation of each model, as they were counted by `count_cost`.
pub const DATA: &str = include_str!("../data/cost.csv");

/// The rows of [`DATA`]: a model's name and its count.
pub fn kept() -> Vec<(String, f64)> {
    DATA.lines()
        .filter(|l| !l.starts_with('#') && !l.starts_with("model"))
        .filter_map(|l| l.split_once(','))
        .filter_map(|(name, n)| Some((name.to_owned(), n.trim().parse().ok()?)))
        .collect()
}

/// The name of the loop without a model.
pub const OVERHEAD: &str = "overhead";

/// Pairs that lie in the lobes: V within some 0.25 of R and, for every other one, of L.
fn pairs() -> Vec<(Direction, Direction)> {
    let mut random = Random::new(3);
    (0..64)
        .map(|i| {
            let l = Direction::from_cosine(0.2 + 0.8 * random.uniform(), 6.3 * random.uniform());
            let centre = if i % 2 == 0 { l.mirrored() } else { l };
            let step = |x: f64, u: f64| x + 0.25 * (u - 0.5);
            let v = Direction::new(
                step(centre.x, random.uniform()),
                step(centre.y, random.uniform()),
                step(centre.z, random.uniform()).abs(),
            );
            (l, v.normalised())
        })
        .collect()
}

/// The model whose evaluation is counted: the first example, but without a search for the
/// greatest albedo, which would take minutes under callgrind and doesn't change the cost.
fn model(name: &str) -> Option<Box<dyn Brdf>> {
    const RANGE: &str = "in range";
    let lobe = || AnisotropicPhong::unnormalised([0.8, 1.0, 1.0], 20.0, 1.0).expect(RANGE);
    Some(match name {
        OVERHEAD => Box::new(Nothing),
        "anisotropic_phong" => Box::new(lobe()),
        "anisotropic_sum" => {
            Box::new(AnisotropicSum::new(&[(0.4, lobe()), (0.6, lobe())]).expect(RANGE))
        }
        "bisector_phong" => {
            Box::new(BisectorPhong::unchecked(20.0, Bisector::Spherical).expect(RANGE))
        }
        "blinn_cos" => Box::new(BlinnCos::new(20.0).expect(RANGE)),
        "metallic_phong" => Box::new(MetallicPhong::new(20.0, Energy::Published).expect(RANGE)),
        "p_model" => Box::new(PModel::new(20.0, 0.5, Energy::Published).expect(RANGE)),
        "patch_profile" => {
            let xi = |m: f64| 1.0 / (1.0 + 30.0 * m * m);
            Box::new(PatchProfile::new(xi, Metric::EUCLIDEAN).expect(RANGE))
        }
        "pumped" => {
            let phong = Phong::new(20.0).expect(RANGE);
            Box::new(Pumped::with_cells(phong, PumpRule::Full, 2, 16).expect(RANGE))
        }
        "sandwich" => {
            let base = Lambert::grey(0.8).expect(RANGE);
            Box::new(Sandwich::printed(base, 0.5, 2.0).expect(RANGE))
        }
        "ward_corrected" => Box::new(WardCorrected::unnormalised(0.2, 0.2).expect(RANGE)),
        _ => (registry::find(name)?.examples)().into_iter().next()?.model,
    })
}

/// Evaluates the first example of a model (or [`OVERHEAD`]) `rounds` times over 64 pairs.
/// Nothing if there is no such model.
pub fn evaluate(name: &str, rounds: u32) -> Option<f64> {
    let model = model(name)?;
    let pairs = pairs();
    let mut sum = 0.0;
    for _ in 0..rounds {
        for (l, v) in &pairs {
            sum += std::hint::black_box(model.as_ref()).eval(l, v);
        }
    }
    Some(sum)
}

/// Evaluations in one round.
pub const PAIRS: u32 = 64;

/// The number of instructions in callgrind's report ("Collected : …").
pub fn instructions(report: &str) -> Option<u64> {
    report
        .lines()
        .filter_map(|l| l.split_once("Collected"))
        .filter_map(|(_, rest)| {
            rest.trim()
                .trim_start_matches(':')
                .split_whitespace()
                .next()
        })
        .find_map(|n| n.parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_model_was_counted() {
        let counted: Vec<String> = kept().into_iter().map(|(name, _)| name).collect();
        let models: Vec<&str> = ALL.iter().map(|m| m.name).collect();
        assert_eq!(counted, models);
    }

    #[test]
    fn reports_are_read() {
        let report =
            "==1== Callgrind, a call-graph\n==1== Events    : Ir\n==1== Collected : 5142993\n";
        assert_eq!(instructions(report), Some(5_142_993));
        assert_eq!(instructions("==1== nothing"), None);
    }

    #[test]
    fn pairs_are_in_the_lobes_of_most_models() {
        assert!(evaluate("phong", 1).unwrap() > 1.0);
        assert!(evaluate("retro_phong", 1).unwrap() > 1.0);
        assert!(evaluate("patch", 1).unwrap() > 1.0);
        assert!(evaluate("none", 1).is_none());
    }
}
