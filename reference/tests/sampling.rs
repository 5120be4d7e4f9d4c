//! Sampling against density: chi-square with fixed seeds, and the mean weight against the
//! albedo, for every model that has a sampler.
//!
//! Bins hold equal shares of the samples of a pilot run: rings about the lobe's centre (about
//! R, or in the patch's plane), and sectors of each ring. Their expected shares are integrals
//! of the sampler's own pdf over what of them is above the horizon. What is rejected is one
//! more outcome, and so is the direction of a Dirac part.

use microbrdf_reference::albedo::directional_albedo_for;
use microbrdf_reference::brdf::luminance;
use microbrdf_reference::models::{ALL, ModelEntry, PatchExponential};
use microbrdf_reference::quadrature::{Accuracy, Chart, ChartKind, chart_cell};
use microbrdf_reference::sampling::{Mixture, MixtureMethod, Random, Sampled, Sampler, TwoStep};
use microbrdf_reference::{Brdf, Direction};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::f64::consts::PI;

const ANGLES: [f64; 5] = [0.0, 30.0, 60.0, 85.0, 89.9];
/// Samples for each angle: a million for each model.
const SAMPLES: usize = 200_000;
const RINGS: usize = 12;
const SECTORS: usize = 8;
/// Significance of each half of the models, 0.01 for both; each test gets its share
/// (Bonferroni).
const LEVEL: f64 = 0.005;

/// The chart of a model, in a kind that has bins: microfacet lobes don't occur here.
fn chart_of(model: &dyn Brdf, v: &Direction) -> Chart {
    let chart = model.chart(v);
    assert_ne!(chart.kind, ChartKind::Half, "no bins about the half vector");
    chart
}

/// Samples of the pilot run that places the bins.
const PILOT: usize = 50_000;
/// The outcomes that are not bins.
const REJECTED: usize = RINGS * SECTORS;
const DIRAC: usize = REJECTED + 1;
const OUTCOMES: usize = DIRAC + 1;

struct Bins {
    v: Direction,
    chart: Chart,
    rings: Vec<f64>,
    /// The ends of the sectors of each ring, −π and π included.
    sectors: Vec<Vec<f64>>,
}

/// The values that part sorted `values` into `parts` of equal number.
fn quantiles(values: &[f64], parts: usize) -> Vec<f64> {
    (1..parts)
        .filter_map(|i| values.get(i * values.len() / parts).copied())
        .collect()
}

impl Bins {
    fn new(sampler: &dyn Sampler, v: Direction, chart: Chart, random: &mut Random) -> Self {
        let mut pilot: Vec<(f64, f64)> = (0..PILOT)
            .filter_map(|_| sampler.sample(&mut || random.uniform()))
            .filter(|s| !s.is_dirac)
            .map(|s| chart.coordinates(&v, &s.direction))
            .collect();
        pilot.sort_by(|a, b| a.0.total_cmp(&b.0));
        let radii: Vec<f64> = pilot.iter().map(|p| p.0).collect();
        let rings = quantiles(&radii, RINGS);
        let sectors = (0..RINGS)
            .map(|i| {
                let (from, to) = (i * pilot.len() / RINGS, (i + 1) * pilot.len() / RINGS);
                let mut azimuths: Vec<f64> = pilot[from..to].iter().map(|p| p.1).collect();
                azimuths.sort_by(f64::total_cmp);
                let mut ends = vec![-PI];
                ends.extend(quantiles(&azimuths, SECTORS));
                ends.resize(SECTORS, PI);
                ends.push(PI);
                ends
            })
            .collect();
        Self {
            v,
            chart,
            rings,
            sectors,
        }
    }

    fn index(&self, l: &Direction) -> usize {
        let (t, phi) = self.chart.coordinates(&self.v, l);
        let ring = self.rings.partition_point(|e| *e <= t);
        let sector = self.sectors[ring][1..SECTORS].partition_point(|e| *e <= phi);
        ring * SECTORS + sector
    }

    /// The outcome of one sample.
    fn outcome(&self, sampled: Option<&Sampled>) -> usize {
        match sampled {
            None => REJECTED,
            Some(s) if s.is_dirac => DIRAC,
            Some(s) => self.index(&s.direction),
        }
    }

    /// The pdf's integral over each bin, what is missing from 1, and the Dirac part.
    fn shares(&self, model: &dyn Brdf, sampler: &dyn Sampler) -> Vec<f64> {
        let accuracy = Accuracy {
            tolerance: 1e-7,
            outer_panels: 60,
            inner_panels: 30,
        };
        let density = |l: &Direction| {
            if l.z > 0.0 { sampler.pdf(l) / l.z } else { 0.0 }
        };
        let mut shares = Vec::new();
        for (ring, ends) in self.sectors.iter().enumerate() {
            let low = if ring == 0 {
                0.0
            } else {
                self.rings.get(ring - 1).copied().unwrap_or(0.0)
            };
            let high = self.rings.get(ring).copied().unwrap_or(f64::INFINITY);
            for sector in ends.windows(2) {
                let e = chart_cell(
                    &self.v,
                    &self.chart,
                    (low, high),
                    (sector[0], sector[1]),
                    accuracy,
                    &|l, out| model.creases(&self.v, l, out),
                    &density,
                );
                shares.push(e.value);
            }
        }
        let total = shares.iter().sum::<f64>() + sampler.dirac();
        assert!(total <= 1.0 + 1e-5, "the density's integral is {total}");
        shares.push((1.0 - total).max(0.0));
        shares.push(sampler.dirac());
        shares
    }
}

/// A weight must be f cosΘ over the density, or the Dirac part's weight over its probability.
fn check_weight(
    model: &dyn Brdf,
    sampler: &dyn Sampler,
    v: &Direction,
    delta: [f64; 3],
    s: &Sampled,
) {
    let expected = if s.is_dirac {
        delta.map(|w| w / sampler.dirac())
    } else {
        let pdf = sampler.pdf(&s.direction);
        model.reflect(&s.direction, v).map(|r| r / pdf)
    };
    for (a, b) in s.weight.iter().zip(expected) {
        assert!(
            (a - b).abs() <= 1e-7 * b.abs(),
            "weight {a}, not {b}: {s:?}"
        );
    }
}

struct Outcome {
    /// Probability of a chi-square at least as large.
    p: f64,
    /// Deviation of the mean weight from the albedo, in standard errors.
    z: f64,
}

/// The chi-square of `counts` against `shares`; thin bins are put together.
fn chi_square(counts: &[usize], shares: &[f64]) -> f64 {
    let n: usize = counts.iter().sum();
    let (mut chi2, mut cells) = (0.0, 0);
    let mut rest = (0.0, 0.0);
    for (count, share) in counts.iter().zip(shares) {
        let (count, e) = (*count as f64, share * n as f64);
        if e < 20.0 {
            rest = (rest.0 + count, rest.1 + e);
        } else {
            chi2 += (count - e) * (count - e) / e;
            cells += 1;
        }
    }
    if rest.1 >= 5.0 {
        chi2 += (rest.0 - rest.1) * (rest.0 - rest.1) / rest.1;
        cells += 1;
    } else if rest.0 > rest.1 + 20.0 {
        // Samples where the density is (almost) 0.
        return 0.0;
    }
    if cells == 1 {
        // One sure outcome; whatever else happened was caught above.
        return 1.0;
    }
    ChiSquared::new(f64::from(cells - 1))
        .expect("one degree of freedom or more")
        .sf(chi2)
}

fn run(model: &dyn Brdf, sampler: &dyn Sampler, v: Direction, seed: u64) -> Outcome {
    let mut random = Random::new(seed);
    let bins = Bins::new(sampler, v, chart_of(model, &v), &mut random);
    let delta = model.delta_weight(&v);
    let mut counts = vec![0usize; OUTCOMES];
    let (mut mean, mut square) = (0.0, 0.0);
    for i in 1..=SAMPLES {
        let sampled = sampler.sample(&mut || random.uniform());
        counts[bins.outcome(sampled.as_ref())] += 1;
        let weight = sampled.map_or(0.0, |s| {
            assert!(s.direction.z >= 0.0, "{:?}", s.direction);
            if i % 64 == 0 {
                check_weight(model, sampler, &v, delta, &s);
            }
            luminance(s.weight)
        });
        let before = weight - mean;
        mean += before / i as f64;
        square += before * (weight - mean);
    }
    let albedo = directional_albedo_for(
        model,
        &v,
        Accuracy {
            tolerance: 1e-9,
            ..Accuracy::FINE
        },
    );
    let error = square.sqrt() / SAMPLES as f64;
    let difference = mean - albedo.value;
    // Equal weights have no variance: then only rounding and the quadrature's error count.
    let z = if error > 1e-12 {
        difference / error
    } else {
        difference / (1e-8 + albedo.error)
    };
    Outcome {
        p: chi_square(&counts, &bins.shares(model, sampler)),
        z,
    }
}

fn with_samplers() -> Vec<&'static ModelEntry> {
    ALL.iter().filter(|m| m.sampler.is_some()).collect()
}

fn check(part: usize) {
    let mut results = Vec::new();
    for entry in with_samplers().into_iter().skip(part).step_by(2) {
        let visit = entry.sampler.expect("filtered");
        for (k, degrees) in ANGLES.into_iter().enumerate() {
            let v = Direction::from_degrees(degrees, 25.0);
            let mut variant = 0;
            visit(v, &mut |model, sampler| {
                let outcome = run(model, sampler, v, 100 + k as u64);
                results.push((entry.name, variant, degrees, outcome));
                variant += 1;
            });
        }
    }
    let threshold = LEVEL / results.len() as f64;
    for (name, variant, degrees, outcome) in &results {
        let what = format!("{name}, sampler {variant}, {degrees}°");
        assert!(
            outcome.p > threshold,
            "{what}: p = {} (of {})",
            outcome.p,
            results.len()
        );
        assert!(outcome.z.abs() < 4.0, "{what}: z = {}", outcome.z);
    }
}

// Two halves, for two cores.
#[test]
fn samples_follow_their_density_in_the_even_models() {
    check(0);
}

#[test]
fn samples_follow_their_density_in_the_odd_models() {
    check(1);
}

#[test]
fn the_texts_samplers_are_all_here() {
    let names: Vec<_> = with_samplers().iter().map(|m| m.name).collect();
    assert_eq!(
        names,
        [
            "anisotropic_phong",
            "anisotropic_sum",
            "generalised_lambert",
            "lafortune",
            "lambert",
            "metal",
            "metal_half",
            "metallic_paint",
            "metallic_phong",
            "mirror",
            "mixed",
            "p_model",
            "patch",
            "patch_elliptic",
            "patch_exponential",
            "patch_metal",
            "patch_mixture",
            "patch_p_norm",
            "patch_plastic",
            "patch_power",
            "patch_profile",
            "patch_retro",
            "phong",
            "plastic",
            "plastic_fresnel",
            "polished",
            "retro_phong",
            "tobler_exponential",
            "tobler_power",
        ]
    );
}

#[test]
fn the_printed_two_step_sampler_has_another_density() {
    let model = PatchExponential::new(4.0).unwrap();
    let v = Direction::from_degrees(85.0, 0.0);
    let printed = TwoStep::new(model, v);
    let right = Mixture::exponential(&model, v, MixtureMethod::Redraw);
    let mut random = Random::new(5);
    let bins = Bins::new(&right, v, chart_of(&model, &v), &mut random);
    let mut counts = vec![0usize; OUTCOMES];
    for _ in 0..100_000 {
        let sampled = printed.sample(&mut || random.uniform());
        counts[bins.outcome(sampled.as_ref())] += 1;
    }
    let (own, exact) = (bins.shares(&model, &printed), bins.shares(&model, &right));
    assert!(chi_square(&counts, &own) > 1e-3);
    assert!(chi_square(&counts, &exact) < 1e-12);
    let variation: f64 = own
        .iter()
        .zip(&exact)
        .map(|(a, b)| 0.5 * (a - b).abs())
        .sum();
    assert!(variation > 0.02 && variation < 0.1, "{variation}");
}

#[test]
fn a_wrong_density_is_noticed() {
    // The same samples against a lobe that is 3 % too sharp.
    let model = microbrdf_reference::models::Phong::new(20.0).unwrap();
    let v = Direction::from_degrees(30.0, 0.0);
    let (a, b) = (
        microbrdf_reference::sampling::PhongLobe::new(&model, 20.0, v),
        microbrdf_reference::sampling::PhongLobe::new(&model, 20.6, v),
    );
    let mut random = Random::new(6);
    let bins = Bins::new(&a, v, chart_of(&model, &v), &mut random);
    let mut counts = vec![0usize; OUTCOMES];
    for _ in 0..200_000 {
        let sampled = a.sample(&mut || random.uniform());
        counts[bins.outcome(sampled.as_ref())] += 1;
    }
    assert!(chi_square(&counts, &bins.shares(&model, &a)) > 1e-3);
    assert!(chi_square(&counts, &bins.shares(&model, &b)) < 1e-6);
}
