//! Samplers of the core: drawn as their density says, weighted as the model
//! reflects, and in range whatever comes in.

use std::collections::BTreeSet;

use microbrdf::Rgb;
use microbrdf::arithmetic::{F32, Q31};
use microbrdf::brdf::{Brdf as _, Metallic, Mirror};
use microbrdf::fixed::types::{I2F30, U0F32};
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf::sampling::{Drawn, Sample};
use microbrdf_reference::albedo::directional_albedo_for;
use microbrdf_reference::brdf::{Brdf, Channel};
use microbrdf_reference::quadrature::Accuracy;
use microbrdf_reference::sampling::{Mixture, MixtureMethod, Sampler as _};
use microbrdf_scene::{Material, PatchShape};
use microbrdf_tests::arithmetic::{Tested, rounded, value_of};
use microbrdf_tests::sampling::{
    Bins, Drawing, Numbers, OUTCOMES, chi_square, density, sampler, view,
};
use microbrdf_tests::{in_arithmetic, registry};

in_arithmetic!(
    f32,
    microbrdf::arithmetic::F32,
    samples_follow_their_density,
    densities_are_the_references,
    weight_times_density_is_what_is_reflected,
    half_of_a_lobe_is_rejected_at_the_horizon,
    a_sharp_lobe_has_many_cosines,
    a_mixture_rejects_nothing,
    the_ends_of_random_numbers_and_views_are_in_range,
    below_the_horizon_nothing_is_drawn
);
in_arithmetic!(
    q31,
    microbrdf::arithmetic::Q31,
    samples_follow_their_density,
    densities_are_the_references,
    weight_times_density_is_what_is_reflected,
    half_of_a_lobe_is_rejected_at_the_horizon,
    a_sharp_lobe_has_many_cosines,
    a_mixture_rejects_nothing,
    the_ends_of_random_numbers_and_views_are_in_range,
    below_the_horizon_nothing_is_drawn
);

/// Samples at each angle.
const SAMPLES: usize = 200_000;
/// Significance of all chi-square tests of an arithmetic together: each gets
/// its share (Bonferroni).
const LEVEL: f64 = 0.01;
/// From the normal to the horizon.
const COSINES: [f64; 5] = [1.0, 0.7, 0.17, 1.7e-3, 1e-8];

/// Every family at its ends.
const MATERIALS: [&str; 19] = [
    "model = \"lambert\", albedo = [0.9, 0.5, 0.1]",
    "model = \"metallic-phong\", exponent = 0",
    "model = \"metallic-phong\", exponent = 1",
    "model = \"metallic-phong\", exponent = 20",
    "model = \"metallic-phong\", exponent = 5e3",
    "model = \"metallic-phong\", exponent = 1e8",
    "model = \"phong\", exponent = 20",
    "model = \"phong\", exponent = 20, p = 0.5",
    "model = \"retro-phong\", exponent = 20",
    "model = \"patch\", radius = 1e-4",
    "model = \"patch\", radius = 0.3",
    "model = \"patch\", radius = 1",
    "model = \"patch\", radius = 1.5",
    "model = \"patch-exponential\", sharpness = 0",
    "model = \"patch-exponential\", sharpness = 0.3",
    "model = \"patch-exponential\", sharpness = 0.7",
    "model = \"patch-exponential\", sharpness = 4",
    "model = \"patch-exponential\", sharpness = 4096",
    "model = \"metal\", metal = \"gold\", exponent = 20",
];

fn material<A: Tested>(toml: &str) -> Material {
    Material::from_argument(toml)
        .expect("a material")
        .rounded::<A>()
}

/// Running mean and sum of squared deviations (Welford).
#[derive(Default)]
struct Mean {
    count: f64,
    mean: f64,
    square: f64,
}

impl Mean {
    fn add(&mut self, value: f64) {
        self.count += 1.0;
        let before = value - self.mean;
        self.mean += before / self.count;
        self.square += before * (value - self.mean);
    }

    /// Standard error of the mean.
    fn error(&self) -> f64 {
        self.square.sqrt() / self.count
    }
}

fn weights<A: Drawing>(drawn: Option<&Drawn<A>>) -> [f64; 3] {
    drawn.map_or([0.0; 3], |drawn| {
        drawn.weight.to_array().map(A::radiance_value)
    })
}

/// Chi-square of the directions, and the mean weight against the albedo.
fn samples_follow_their_density<A: Drawing>() {
    let mut faults = Vec::new();
    let threshold = LEVEL / (MATERIALS.len() * COSINES.len()) as f64;
    for (index, toml) in MATERIALS.into_iter().enumerate() {
        let material = material::<A>(toml);
        let (model, sampler) = (material.reference(), sampler::<A>(&material));
        // At grazing half of a sharp mixture's mass lies about the normal,
        // with a weight of 0, where no cell of a chart about R resolves it:
        // it counts as rejected here. Milder mixtures show how it is drawn.
        let far_is_rejected =
            matches!(material, Material::PatchExponential { sharpness } if sharpness > 100.0);
        for cosine in COSINES {
            let v = view::<A>(cosine);
            let place = value_of::<A>(&v);
            let mut numbers = Numbers::new(1 + index as u64);
            let bins = Bins::new(&*sampler, &v, model.chart(&place), &mut numbers);
            let mut counts = [0usize; OUTCOMES];
            let mut means = [Mean::default(), Mean::default(), Mean::default()];
            for _ in 0..SAMPLES {
                let drawn = sampler.sample(&v, numbers.pair::<A>());
                let outcome = drawn
                    .map(|drawn| value_of::<A>(&drawn.direction))
                    .filter(|l| !(far_is_rejected && (l.x + place.x).hypot(l.y + place.y) > 1.0))
                    .map_or(OUTCOMES - 1, |l| bins.index(&l));
                counts[outcome] += 1;
                for (mean, weight) in means.iter_mut().zip(weights(drawn.as_ref())) {
                    mean.add(weight);
                }
            }
            let whole = density(&material, place);
            let near = |l: &microbrdf_reference::Direction| {
                if far_is_rejected && (l.x + place.x).hypot(l.y + place.y) > 1.0 {
                    0.0
                } else {
                    whole(l)
                }
            };
            let shares = bins.shares(&|l, out| model.creases(&place, l, out), &near);
            let p = chi_square(&counts, &shares);
            if p <= threshold {
                faults.push(format!("{toml} at {cosine}: p = {p:e}"));
            }
            for (channel, mean) in means.iter().enumerate() {
                let accuracy = Accuracy {
                    tolerance: 1e-7,
                    ..Accuracy::FINE
                };
                let exact = directional_albedo_for(&Channel(&model, channel), &place, accuracy);
                // Without variance what is left is rounding: that of the
                // weight, of a curve's entries, of an albedo.
                let bound = 4.5 * mean.error() + 2e-4 * f64::from(toml.contains("gold")) + 4e-7;
                if (mean.mean - exact.value).abs() > bound {
                    faults.push(format!(
                        "{toml} at {cosine}: mean weight {} for {}, may be off by {bound:e}",
                        mean.mean, exact.value
                    ));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The sampler's own pdf, anywhere.
fn densities_are_the_references<A: Drawing>() {
    for toml in MATERIALS {
        let material = material::<A>(toml);
        let sampler = sampler::<A>(&material);
        let entry = registry::Entry {
            model: if toml.contains("retro") {
                "retro-phong"
            } else {
                ""
            },
            toml: toml.to_owned(),
            n: width(&material),
        };
        let mut seen = 0;
        for set in microbrdf_tests::domain::Set::ALL {
            for [l, v] in entry.pairs(set, 9.0, 300) {
                let [l, v] = [l, v].map(rounded::<A>);
                let found = A::radiance_value(sampler.pdf(&l, &v));
                let [place, at] = [value_of::<A>(&l), value_of::<A>(&v)];
                if at.z < 0.0 {
                    assert_eq!(found, 0.0, "{toml}, {l:?}, {v:?}");
                    continue;
                }
                let exact = density(&material, at)(&place);
                let peak = material.reference().peak();
                let bound = (A::LOBE_ERROR + 1e-6) * exact + 4.0 * A::UNIT_STEP * peak + 1e-9;
                // Within an edge's uncertainty either side will do.
                let edge = material::edge(&material, &place, &at);
                assert!(
                    (found - exact).abs() <= bound || edge < 1e-6,
                    "{toml}, {l:?}, {v:?}: {found} for {exact}"
                );
                seen += u32::from(found > 0.0);
            }
        }
        assert!(seen > 300, "{toml}: only {seen} pairs had a density");
    }
}

/// An exponent about as narrow.
fn width(material: &Material) -> f64 {
    match material {
        Material::Lambert { .. } | Material::GeneralisedLambert { .. } => 0.5,
        Material::Phong { exponent, .. }
        | Material::Metal { exponent, .. }
        | Material::Plastic { exponent, .. } => *exponent,
        Material::Patch { radius }
        | Material::PatchMetal {
            shape: PatchShape::Basic { radius },
            ..
        } => 1.0 / (radius * radius),
        Material::PatchExponential { sharpness }
        | Material::MetallicPaint { sharpness, .. }
        | Material::PatchMetal {
            shape: PatchShape::Exponential { sharpness },
            ..
        } => (sharpness * sharpness).max(1.0) / 8.0,
        Material::PatchProfile { profile } => profile.reach().powi(-2),
    }
}

mod material {
    use super::*;
    use microbrdf_reference::Direction;

    /// How near a pair lies to a jump of the density.
    pub fn edge(material: &Material, l: &Direction, v: &Direction) -> f64 {
        let m = (l.x + v.x).hypot(l.y + v.y);
        match material {
            Material::Patch { radius } => (m / radius - 1.0).abs(),
            Material::PatchExponential { .. } => (m - 1.0).abs(),
            _ => f64::INFINITY,
        }
    }
}

/// weight · pdf = f·cosΘL at every direction drawn.
fn weight_times_density_is_what_is_reflected<A: Drawing>() {
    for toml in MATERIALS {
        let material = material::<A>(toml);
        let (model, sampler) = (
            material.model::<A>().expect("a material"),
            sampler::<A>(&material),
        );
        let peak = A::scale_value(model.peak());
        let mut numbers = Numbers::new(77);
        let mut compared = 0;
        for cosine in COSINES {
            let v = view::<A>(cosine);
            for _ in 0..2000 {
                let Some(drawn) = sampler.sample(&v, numbers.pair::<A>()) else {
                    continue;
                };
                let l = drawn.direction;
                let pdf = A::radiance_value(sampler.pdf(&l, &v));
                let reflected = model
                    .reflect(&ShadingFrame::new(l, v))
                    .to_array()
                    .map(A::radiance_value);
                for (weight, reflected) in weights(Some(&drawn)).into_iter().zip(reflected) {
                    assert!((0.0..=2.0).contains(&weight), "{toml}: {weight}");
                    // Both hold the same lobe, and what is left is rounding,
                    // but for a mixture's two beyond m = 1.
                    let lobes = if toml.contains("sharpness") && weight < 1.0 {
                        3.0 * A::LOBE_ERROR
                    } else {
                        2e-6
                    };
                    let bound = lobes * reflected + 8.0 * A::UNIT_STEP * peak + 1e-8;
                    let edge = material::edge(&material, &value_of::<A>(&l), &value_of::<A>(&v));
                    assert!(
                        (weight * pdf - reflected).abs() <= bound || edge < 1e-6,
                        "{toml} at {cosine}: {weight} · {pdf} for {reflected}, {l:?}"
                    );
                }
                compared += 1;
            }
        }
        assert!(compared > 4000, "{toml}: {compared}");
    }
}

fn half_of_a_lobe_is_rejected_at_the_horizon<A: Drawing>() {
    let v = view::<A>(0.0);
    for n in [1.0, 20.0, 5e3, 1e8] {
        let sampler = A::lobe_sampler::<Mirror, _>(n, Metallic);
        let mut numbers = Numbers::new(3);
        let drawn = (0..SAMPLES)
            .filter(|_| sampler.sample(&v, numbers.pair::<A>()).is_some())
            .count();
        let share = drawn as f64 / SAMPLES as f64;
        // Four standard errors.
        assert!((share - 0.5).abs() < 4.0 * 0.5 / (SAMPLES as f64).sqrt());
    }
}

/// u^(1/(n+1)) in f32 would give three cosines at n = 1e8.
fn a_sharp_lobe_has_many_cosines<A: Drawing>() {
    let sampler = A::lobe_sampler::<Mirror, _>(1e8, Metallic);
    let v = view::<A>(0.7);
    let mut numbers = Numbers::new(4);
    let distances: BTreeSet<u64> = (0..1000)
        .filter_map(|_| sampler.sample(&v, numbers.pair::<A>()))
        .map(|drawn| {
            let (l, v) = (value_of::<A>(&drawn.direction), value_of::<A>(&v));
            microbrdf_reference::geometry::versine(&l, &v).to_bits()
        })
        .collect();
    assert!(distances.len() > 900, "{}", distances.len());
}

/// And its weight and density are those of the reference's roulette where
/// that rejects nothing: at m ≤ 1.
fn a_mixture_rejects_nothing<A: Drawing>() {
    for s in [0.0, 0.2, 4.0, 100.0].map(A::exponent_value) {
        let sampler = A::mixture_sampler(s);
        let toml = format!("model = \"patch-exponential\", sharpness = {s}");
        let model =
            microbrdf_reference::models::PatchExponential::new(s).expect("a sharpness in range");
        let material = material::<A>(&toml);
        let mut far = 0;
        for cosine in COSINES {
            let v = view::<A>(cosine);
            let at = value_of::<A>(&v);
            let roulette = Mixture::exponential(&model, at, MixtureMethod::Roulette);
            let mut numbers = Numbers::new(5);
            for _ in 0..2000 {
                let drawn = sampler
                    .sample(&v, numbers.pair::<A>())
                    .unwrap_or_else(|| panic!("s = {s} at {cosine}: rejected"));
                let l = value_of::<A>(&drawn.direction);
                let weight = weights(Some(&drawn))[0];
                let m = (l.x + at.x).hypot(l.y + at.y);
                if m <= 1.0 - 1e-6 {
                    assert!((weight - 1.0).abs() < 1e-9, "s = {s}: {weight}");
                    let pdf = density(&material, at)(&l);
                    assert!((pdf - roulette.pdf(&l)).abs() <= 1e-12 * pdf);
                } else if m > 1.0 + 1e-6 {
                    far += 1;
                    let expected = (-s * (m - l.x.hypot(l.y))).exp();
                    assert!(
                        (weight - expected).abs() <= A::LOBE_ERROR + 1e-5 * s,
                        "s = {s}: {weight} for {expected}"
                    );
                }
            }
        }
        assert!(far > 200 || s == 100.0, "s = {s}: {far}");
    }
}

/// A unit vector above the horizon, and weights in [0, 2].
fn in_range<A: Drawing>(toml: &str, drawn: &Drawn<A>, unit: bool) {
    let l = value_of::<A>(&drawn.direction);
    let weights = weights(Some(drawn));
    let length = l.length();
    assert!(
        weights.iter().all(|weight| (0.0..=2.0).contains(weight)) && l.z >= 0.0,
        "{toml}: {drawn:?}"
    );
    if unit {
        assert!((length - 1.0).abs() < 6e-7, "{toml}: {length}, {drawn:?}");
    } else {
        assert!(length.is_finite(), "{toml}: {drawn:?}");
    }
}

fn the_ends_of_random_numbers_and_views_are_in_range<A: Drawing>() {
    let ends = [0, 1, 255, 256, 1 << 30, 1 << 31, u32::MAX - 255, u32::MAX];
    let views = [
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [1.0, 0.0, 1e-8],
        [-(1.0f64 - 1e-16).sqrt(), 0.0, 1e-8],
        [1e-9, 0.0, 1.0],
        [1e-20, 1e-20, 1.0],
        [-0.6, 0.0, 0.8],
    ];
    for toml in MATERIALS {
        let sampler = sampler::<A>(&material::<A>(toml));
        let mut drawn = 0;
        for v in views.map(rounded::<A>) {
            for first in ends {
                for second in ends {
                    let random = [first, second].map(A::uniform);
                    if let Some(sample) = sampler.sample(&v, random) {
                        in_range(toml, &sample, true);
                        drawn += 1;
                    }
                }
            }
        }
        assert!(drawn > 200, "{toml}: {drawn}");
    }
}

fn below_the_horizon_nothing_is_drawn<A: Drawing>() {
    let below = rounded::<A>([0.8, 0.0, -0.6]);
    let above = rounded::<A>([-0.6, 0.0, 0.8]);
    let mut numbers = Numbers::new(6);
    for toml in MATERIALS {
        let sampler = sampler::<A>(&material::<A>(toml));
        for _ in 0..100 {
            assert_eq!(sampler.sample(&below, numbers.pair::<A>()), None, "{toml}");
        }
        for (l, v) in [(below, above), (above, below), (below, below)] {
            assert_eq!(A::radiance_value(sampler.pdf(&l, &v)), 0.0, "{toml}");
        }
    }
}

/// Any bits for V: finite by type, weights in range, nothing wraps with a
/// panic.
#[test]
fn no_fixed_point_view_leaves_the_range() {
    let values = [i32::MIN, -(1 << 30), -1, 0, 1, 1 << 30, i32::MAX].map(I2F30::from_bits);
    let random = [0, 0x7777_7777, u32::MAX].map(U0F32::from_bits);
    for toml in MATERIALS {
        let sampler = sampler::<Q31>(&material::<Q31>(toml));
        for x in values {
            for y in values {
                for z in values {
                    let v = Direction::new(x, y, z);
                    for u in random {
                        if let Some(drawn) = sampler.sample(&v, [u, random[1]]) {
                            in_range(toml, &drawn, false);
                        }
                    }
                }
            }
        }
    }
}

/// What is not finite draws nothing, or what weighs 0.
#[test]
fn no_number_draws_nothing() {
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    for toml in MATERIALS {
        let sampler = sampler::<F32>(&material::<F32>(toml));
        for bad in bad {
            for place in 0..3 {
                let mut v = [-0.6, 0.0, 0.8];
                v[place] = bad;
                let v = Direction::new(v[0], v[1], v[2]);
                let drawn = sampler.sample(&v, [0.3, 0.6]);
                assert!(
                    weights(drawn.as_ref()) == [0.0; 3],
                    "{toml}, {v:?}: {drawn:?}"
                );
                if let Some(drawn) = drawn {
                    in_range(toml, &drawn, false);
                }
            }
            let v = Direction::new(-0.6, 0.0, 0.8);
            for random in [[bad, 0.5], [0.5, bad], [1.0, 0.5], [7.0, -3.0]] {
                if let Some(drawn) = sampler.sample(&v, random) {
                    in_range(toml, &drawn, false);
                }
            }
        }
        let drawn = sampler.sample(&Direction::new(-0.6, 0.0, 0.8), [0.1, 0.6]);
        assert_ne!(drawn.map(|drawn| drawn.weight), Some(Rgb::grey(0.0)));
    }
}

/// A peak that conserves energy strictly scales the weights.
#[test]
fn another_peak_scales_the_weights() {
    let v = view::<F32>(0.7);
    let plain = F32::lobe_sampler::<Mirror, _>(1.0, Metallic);
    let halved = plain.with_peak(0.5 * plain.model().peak());
    let drawn = |sampler: &dyn Sample<F32>| sampler.sample(&v, [0.2, 0.3]).expect("a sample");
    assert_eq!(drawn(&plain).direction, drawn(&halved).direction);
    assert!((drawn(&plain).weight.r - 2.0 * drawn(&halved).weight.r).abs() < 1e-6);
    assert_eq!(
        plain.pdf(&drawn(&plain).direction, &v),
        halved.pdf(&drawn(&plain).direction, &v)
    );
    let v = view::<Q31>(0.7);
    let plain = Q31::lobe_sampler::<Mirror, _>(1.0, Metallic);
    let halved = plain.with_peak(plain.model().peak() / 2);
    let random = [U0F32::lit("0.2"), U0F32::lit("0.3")];
    let [whole, half] = [&plain, &halved].map(|sampler| {
        let drawn = sampler.sample(&v, random).expect("a sample");
        drawn.weight.r.to_num::<f64>()
    });
    assert!((whole - 2.0 * half).abs() < 1e-8, "{whole} and {half}");
}
