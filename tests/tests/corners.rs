//! Directions at the corners of the domain, and out of it: the documented
//! rule or a value in range, never anything else. Parameters out of range
//! are in `parameters.rs`.

use std::collections::BTreeMap;

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, Geometry, ShadingFrame, World};
use microbrdf_reference::geometry::{retro_versine, versine};
use microbrdf_scene::{AnyModel, Material};
use microbrdf_tests::arithmetic::{Tested, bits, rounded, value_of};
use microbrdf_tests::domain::Set;
use microbrdf_tests::error::Subject;
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::{in_every_arithmetic, registry};

in_every_arithmetic!(
    light_at_the_horizon_reflects_nothing,
    a_viewer_at_the_horizon_sees_the_lobe,
    both_at_the_horizon_saturate,
    beyond_a_right_angle_a_lobe_is_zero_even_flat,
    along_the_normal_everything_shows_its_peak,
    opposite_directions,
    a_step_beside_the_mirror_direction_dims_nothing,
    no_normal_makes_a_highlight_black,
    lengths_within_the_contract_keep_the_accuracy,
    lengths_off_by_a_thousandth_stay_in_range,
    exposure_never_wraps,
    every_model_is_exact_at_the_ends_of_exposure,
    along_any_normal_a_lobe_shows_its_peak,
    opposite_directions_in_any_frame,
);

fn model<A: Tested>(toml: &str) -> AnyModel<A> {
    Material::from_argument(toml)
        .expect("a material")
        .model()
        .expect("a material that the arithmetic takes")
}

/// Greatest error of generalised Lambert's table, `tables.rs`.
const PROFILE_ERROR: f64 = 4e-4;

/// All models, the colours apart from white.
fn models<A: Tested>() -> Vec<(String, AnyModel<A>)> {
    registry::all()
        .into_iter()
        .map(|entry| {
            let model = model(&entry.toml);
            (entry.toml, model)
        })
        .collect()
}

fn frame<A: Tested>(l: [f64; 3], v: [f64; 3]) -> ShadingFrame<A> {
    ShadingFrame::new(rounded(l), rounded(v))
}

/// The first fault of each model, all shown at the end.
#[derive(Default)]
struct Faults(BTreeMap<String, String>);

impl Faults {
    fn add(&mut self, name: &str, fault: impl FnOnce() -> String) {
        self.0.entry(name.to_owned()).or_insert_with(fault);
    }
}

impl Drop for Faults {
    fn drop(&mut self) {
        let lines: Vec<_> = self
            .0
            .iter()
            .map(|(name, fault)| format!("{name}: {fault}"))
            .collect();
        assert!(
            std::thread::panicking() || lines.is_empty(),
            "{}",
            lines.join("\n")
        );
    }
}

/// Finite, not negative, the share at most 1 and the radiance at most the
/// peak.
fn in_range<A: Tested>(
    faults: &mut Faults,
    name: &str,
    model: &AnyModel<A>,
    geometry: &impl Geometry<A>,
) {
    let share = model.share(geometry).to_array();
    let reflected = model.reflect(geometry).to_array();
    let f = model.brdf(geometry).to_array();
    for channel in 0..3 {
        let values = [
            A::unit_value(share[channel]),
            A::radiance_value(reflected[channel]),
            A::value_value(f[channel]),
        ];
        let fine = values
            .iter()
            .all(|value| value.is_finite() && value.is_sign_positive())
            && values[0] <= 1.0
            && A::at_most(reflected[channel], model.peak());
        if !fine {
            faults.add(name, || {
                format!(
                    "share, radiance and BRDF are {values:?} at cosines {:?}",
                    geometry.cosines()
                )
            });
        }
    }
}

fn is_zero<A: Tested>(
    faults: &mut Faults,
    name: &str,
    model: &AnyModel<A>,
    geometry: &impl Geometry<A>,
) {
    let all = [
        bits(model.share(geometry).to_array()),
        bits(model.reflect(geometry).to_array()),
        bits(model.brdf(geometry).to_array()),
    ];
    if all.concat().iter().any(|byte| *byte != 0) {
        faults.add(name, || {
            format!(
                "share {:?}, BRDF {:?} at cosines {:?}",
                model.share(geometry).to_array().map(A::unit_value),
                model.brdf(geometry).to_array().map(A::value_value),
                geometry.cosines()
            )
        });
    }
}

fn light_at_the_horizon_reflects_nothing<A: Tested>() {
    for (name, model) in models::<A>() {
        for v in [[0.0, 0.0, 1.0], [-0.8, 0.0, 0.6], [-1.0, 0.0, 0.0]] {
            let geometry = frame::<A>([1.0, 0.0, 0.0], v);
            assert_eq!(model.share(&geometry), Rgb::grey(A::ZERO), "{name}, {v:?}");
            let reflected = bits(model.reflect(&geometry).to_array());
            assert!(reflected.iter().all(|byte| *byte == 0), "{name}, {v:?}");
        }
    }
}

/// The ratio is exactly 1: what is left is the lobe of x = 1 − R·V.
fn a_viewer_at_the_horizon_sees_the_lobe<A: Tested>() {
    for n in [0.0, 1.0, 20.0, 500.0] {
        let lobe = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        for degrees in [80.0f64, 85.0, 89.0, 89.99] {
            let (s, c) = degrees.to_radians().sin_cos();
            let there = frame::<A>([s, 0.0, c], [-1.0, 0.0, 0.0]);
            let share = A::unit_value(lobe.share(&there).r);
            let expected = s.powf(n);
            assert!(
                (share - expected).abs() <= (A::LOBE_ERROR + 1e-6) * expected,
                "n = {n}, {degrees}: {share} for {expected}"
            );
        }
    }
}

fn both_at_the_horizon_saturate<A: Tested>() {
    let mut faults = Faults::default();
    let (l, r, beside) = ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    for (name, model) in models::<A>() {
        for v in [l, r, beside] {
            let geometry = frame::<A>(l, v);
            assert_eq!(model.share(&geometry), Rgb::grey(A::ZERO), "{name}, {v:?}");
            in_range(&mut faults, &name, &model, &geometry);
        }
    }
    // Division by 0 gets the greatest value, 0 divided by 0 gets 0.
    for p in ["p = 1", "p = 0.5"] {
        let lobe = model::<A>(&format!("model = \"phong\", exponent = 20, {p}"));
        let f = |v: [f64; 3]| lobe.brdf(&frame::<A>(l, v)).r;
        assert!(A::is_greatest(f(r)), "{p}: {:?}", f(r));
        assert_eq!(A::value_value(f(beside)), 0.0, "{p}");
        assert_eq!(A::value_value(f(l)), 0.0, "{p}");
    }
    let retro = model::<A>("model = \"retro-phong\", exponent = 20");
    assert!(A::is_greatest(retro.brdf(&frame::<A>(l, l)).r));
    // Nothing to divide by: the BRDF is what it is anywhere.
    let flat = model::<A>("model = \"phong\", exponent = 20");
    let (at_horizon, at_normal) = (
        flat.brdf(&frame::<A>(l, r)).r,
        flat.brdf(&frame::<A>([0.0, 0.0, 1.0], [0.0, 0.0, 1.0])).r,
    );
    assert_eq!(at_horizon, at_normal);
}

fn beyond_a_right_angle_a_lobe_is_zero_even_flat<A: Tested>() {
    let mut faults = Faults::default();
    let normal = [0.0, 0.0, 1.0];
    for n in [0.0, 1.0, 1.5, 2.0, 20.0, 1e8] {
        let lobe = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        let name = format!("n = {n}");
        // x = 1 exactly, and x up to 2.
        is_zero(
            &mut faults,
            &name,
            &lobe,
            &frame::<A>(normal, [1.0, 0.0, 0.0]),
        );
        is_zero(
            &mut faults,
            &name,
            &lobe,
            &frame::<A>([0.96, 0.0, 0.28], [0.96, 0.0, 0.28]),
        );
        is_zero(
            &mut faults,
            &name,
            &lobe,
            &frame::<A>([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        );
    }
    // And just short of it n = 0 is still whole.
    let flat = model::<A>("model = \"metallic-phong\", exponent = 0");
    let short = frame::<A>(normal, [(1.0f64 - 1e-8).sqrt(), 0.0, 1e-4]);
    assert_eq!(flat.share(&short), Rgb::grey(A::ONE));
}

fn along_the_normal_everything_shows_its_peak<A: Tested>() {
    let mut faults = Faults::default();
    let normal = [0.0, 0.0, 1.0];
    let there = frame::<A>(normal, normal);
    for (name, model) in models::<A>() {
        in_range(&mut faults, &name, &model, &there);
        let share = A::unit_value(model.share(&there).r);
        // What has Fresnel's factor or an albedo shows less.
        let less = ["metal = ", "eta = ", "lambert", "index"];
        let expected = if less.iter().any(|part| name.contains(part)) {
            continue;
        } else {
            1.0
        };
        // Plastic is the sum of two products.
        let products = if name.contains("plastic") {
            A::PRODUCT_ERROR
        } else {
            0.0
        };
        assert!(
            (share - expected).abs() <= 2.0 * A::UNIT_STEP + products,
            "{name}: {share}"
        );
    }
}

fn opposite_directions<A: Tested>() {
    let mut faults = Faults::default();
    for (name, model) in models::<A>() {
        for l in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.28, 0.96]] {
            let v = l.map(|c: f64| -c);
            is_zero(&mut faults, &name, &model, &frame::<A>(l, v));
            is_zero(&mut faults, &name, &model, &frame::<A>(v, l));
            is_zero(&mut faults, &name, &model, &frame::<A>(v, v));
        }
    }
}

/// One step of the format in any component, about any mirror direction.
fn a_step_beside_the_mirror_direction_dims_nothing<A: Tested>() {
    let mut faults = Faults::default();
    for n in [0.0, 1.0, 20.0, 5e3, 1e5, 1e8] {
        let lobe = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        for pair in Set::Mirror.pairs(n, 1.0, 500) {
            let [l, _] = pair;
            let l = rounded::<A>(l);
            let r = value_of::<A>(&l).mirrored();
            for (axis, step) in [
                (0, 1.0),
                (0, -1.0),
                (1, 1.0),
                (1, -1.0),
                (2, 1.0),
                (2, -1.0),
            ] {
                let mut v = [r.x, r.y, r.z];
                v[axis] += step * 2.0 * A::COMPONENT_ERROR;
                let geometry = ShadingFrame::new(l, rounded(v));
                if v[2] < 0.0 {
                    is_zero(&mut faults, "below", &lobe, &geometry);
                    continue;
                }
                // A cosine that is rounded to 0 follows the horizon's rule.
                if geometry.l.cosine() == A::COSINE_ZERO {
                    assert_eq!(lobe.share(&geometry), Rgb::grey(A::ZERO));
                    continue;
                }
                let share = A::unit_value(lobe.share(&geometry).r);
                let ratio = (r.z / v[2]).min(1.0);
                // x ≤ (2 steps)²/2.
                let x = 0.5 * (4.0 * A::COMPONENT_ERROR).powi(2);
                let least = (1.0 - n * x) * ratio - A::LOBE_ERROR;
                assert!(
                    share >= least && share <= 1.0,
                    "n = {n}: {share}, at least {least}, {geometry:?}"
                );
            }
        }
    }
}

/// In world space the mirror direction is never met exactly.
fn no_normal_makes_a_highlight_black<A: Tested>() {
    let mut rotations = Rotations::new(11);
    for n in [0.0, 1.0, 20.0, 5e3, 1e5, 1e8] {
        let lobe = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        let mut least = f64::INFINITY;
        for pair in Set::Random.pairs(n, 1.0, 3000) {
            let [l, _] = pair;
            if l[2] < 1e-3 {
                continue;
            }
            let [n, l, v] = rotations.turn([l, [-l[0], -l[1], l[2]]]).map(rounded::<A>);
            let world = World::new(n, l, v);
            let (n_dot_l, n_dot_v) = world.cosines();
            let ratio = A::cosine_value(n_dot_l) / A::cosine_value(n_dot_v);
            least = least.min(A::unit_value(lobe.share(&world).r) / ratio.min(1.0));
        }
        // |R − V| is off by at most 24 roundings of a component (frames.rs).
        let x = 0.5 * (24.0 * 2.0 * A::COMPONENT_ERROR).powi(2);
        let bound = (-n * x).exp() - A::LOBE_ERROR;
        assert!(least >= bound, "n = {n}: {least}, at least {bound}");
    }
}

/// Both lengths off by up to 2⁻¹⁴, either way: against the reference at the
/// same values no wider than the table of tolerances; and against it at the
/// unit vectors not much.
fn lengths_within_the_contract_keep_the_accuracy<A: Tested>() {
    const OFF: f64 = 1.0 / 16384.0;
    for entry in registry::all() {
        // At n = 1e8 half a squared length error is worth a whole lobe.
        if entry.n > 1e5 {
            continue;
        }
        let subject = Subject::<A>::new(&entry.material());
        for set in [Set::Lobe, Set::Random, Set::Mirror] {
            let pairs = entry.pairs(set, 9.0, 200);
            for (index, [l, v]) in pairs.into_iter().enumerate() {
                let [a, b] = [[OFF, OFF], [OFF, -OFF], [-OFF, OFF], [-OFF, -OFF]][index % 4];
                let pair = [l.map(|c| c * (1.0 + a)), v.map(|c| c * (1.0 + b))];
                let (shown, exact) = subject.codes(pair, 1.0);
                let (_, unit) = subject.codes([l, v], 1.0);
                // Their m sees a length error as such, not as a share of m.
                let patch = entry.model.starts_with("patch")
                    || ["metallic-paint", "generalised-lambert"].contains(&entry.model);
                // Rounding another length moves a sharp lobe's directions.
                let coarse = entry.n.sqrt() * A::COMPONENT_ERROR > 1e-4;
                for channel in 0..3 {
                    let code = f64::from(shown[channel]);
                    let arithmetic = (code - exact[channel]).abs();
                    assert!(
                        arithmetic <= A::CODE_ERROR,
                        "{}: {code} for {} {pair:?}",
                        entry.toml,
                        exact[channel]
                    );
                    assert!(
                        patch || coarse || (code - unit[channel]).abs() <= A::CODE_ERROR + 0.16,
                        "{}: {code} for {} of unit vectors, {pair:?}",
                        entry.toml,
                        unit[channel]
                    );
                }
            }
        }
    }
}

fn lengths_off_by_a_thousandth_stay_in_range<A: Tested>() {
    let mut faults = Faults::default();
    let mut rotations = Rotations::new(12);
    for entry in registry::all() {
        let model = entry.material().model::<A>().expect("a material");
        for set in Set::ALL {
            for (index, [l, v]) in entry.pairs(set, 9.0, 100).into_iter().enumerate() {
                let [a, b] =
                    [[1e-3, 1e-3], [1e-3, -1e-3], [-1e-3, 1e-3], [-1e-3, -1e-3]][index % 4];
                let pair = [l.map(|c| c * (1.0 + a)), v.map(|c| c * (1.0 + b))];
                in_range(
                    &mut faults,
                    &entry.toml,
                    &model,
                    &frame::<A>(pair[0], pair[1]),
                );
                let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
                in_range(&mut faults, &entry.toml, &model, &World::new(n, l, v));
            }
        }
        let up = frame::<A>([0.0, 0.0, 1.001], [0.0, 0.0, 1.001]);
        in_range(&mut faults, &entry.toml, &model, &up);
    }
}

/// K from 1e-3 to 2e7 on shares from the least to 1: the clamped product,
/// within a step of linear light.
fn exposure_never_wraps<A: Tested>() {
    let mut k = 1e-3;
    while k <= 2e7 {
        let gain = A::gain(k);
        let mut share = 1.0;
        while share > 1e-10 {
            let held = A::unit_value(A::unit(share));
            let found =
                f64::from(A::linear(Rgb::grey(A::expose(gain, A::unit(share)))).to_raw()[0]);
            let exact = (k * held).min(1.0) * f64::from(1 << 24);
            assert!(
                (found - exact).abs()
                    <= 1.0 + A::GAIN_ERROR * exact + A::EXPOSURE_STEP * k * 16_777_216.0,
                "K = {k}, share {held}: {found} for {exact}"
            );
            share *= 0.61;
        }
        k *= 1.37;
    }
    for k in [1e-3, 1.0, 2e7] {
        let light = |share: f64| A::linear(Rgb::grey(A::expose(A::gain(k), A::unit(share))));
        assert_eq!(light(0.0).to_raw(), [0; 3]);
        let (found, exact) = (f64::from(light(1.0).to_raw()[0]), k.min(1.0) * 16_777_216.0);
        assert!((found - exact).abs() <= 0.5 + A::GAIN_ERROR * exact);
    }
    // Many lights on one pixel are white, not what is left of their sum.
    let full = A::expose(A::gain(2e7), A::ONE);
    let sum = (0..1000).fold(A::Light::default(), |sum, _| A::add_light(sum, full));
    assert_eq!(A::linear(Rgb::grey(sum)).srgb8(), [255; 3]);
}

/// Every model at K = 1e-3 and 2e7: linear light within what the stored curves
/// and the last bits of a share leave, times K.
fn every_model_is_exact_at_the_ends_of_exposure<A: Tested>() {
    let mut faults = Faults::default();
    let mut graded = 0;
    for entry in registry::all() {
        let subject = Subject::<A>::new(&entry.material());
        for k in [1e-3, 2e7] {
            let gain = Rgb::grey(A::gain(k));
            for set in Set::ALL {
                for pair in entry.pairs(set, 9.0 + k.max(1.0).ln(), 200) {
                    let geometry = Subject::<A>::geometry(pair);
                    let shown = A::linear(subject.model.shade(&gain, &geometry)).to_raw();
                    let [l, v] = Subject::<A>::rounded(&geometry);
                    let exact = subject.exact.rho(&l, &v);
                    let x = if entry.model == "retro-phong" {
                        retro_versine(&l, &v)
                    } else {
                        versine(&l, &v)
                    };
                    // A float's versine is off by a few roundings, which
                    // n/(1 − x) magnifies where a broad lobe ends.
                    let turned = if A::FRACTIONAL_EXPONENTS && x < 1.0 {
                        2e-7 * entry.n * x / (1.0 - x)
                    } else {
                        0.0
                    };
                    for (shown, rho) in shown.into_iter().zip(exact) {
                        // The share's own steps: of its value, or of 1.
                        let steps = A::LOBE_FLOOR
                            + A::RATIO_FLOOR
                            + if A::FRACTIONAL_EXPONENTS {
                                rho / f64::from(1 << 21)
                            } else {
                                4.0 * A::UNIT_STEP
                            };
                        // Glass: its curve is off by 1.4e-4 of 0.04.
                        let curve = match entry.model {
                            "metal" | "plastic with index" | "patch-metal" | "metallic-paint" => {
                                3.5e-3
                            }
                            "generalised-lambert" => PROFILE_ERROR,
                            _ => 0.0,
                        };
                        let relative = A::LOBE_ERROR + A::PRODUCT_ERROR + curve;
                        let bound = k * ((relative + turned) * rho + steps);
                        let light = f64::from(shown) / f64::from(1 << 24);
                        let expected = (k * rho).min(1.0);
                        if (light - expected).abs() > bound + 1.0 / f64::from(1 << 24) {
                            faults.add(&format!("{}, K = {k}", entry.toml), || {
                                format!("{set:?}: {light} for {expected}, may be off by {bound:e}")
                            });
                        }
                        graded += u32::from(shown > 0 && shown < 1 << 24);
                    }
                }
            }
        }
    }
    assert!(
        graded > 50_000,
        "only {graded} were neither black nor white"
    );
}

/// L = V = N in world space, for 1000 normals.
fn along_any_normal_a_lobe_shows_its_peak<A: Tested>() {
    let mut faults = Faults::default();
    let mut rotations = Rotations::new(13);
    let entries: Vec<_> = registry::all()
        .into_iter()
        .map(|entry| (model::<A>(&entry.toml), entry))
        .collect();
    // |R − V| is off by at most 24 roundings of a component (frames.rs).
    let off = 24.0 * 2.0 * A::COMPONENT_ERROR;
    for _ in 0..1000 {
        let [n, ..] = rotations.turn([[0.0, 0.0, 1.0]; 2]).map(rounded::<A>);
        let world = World::new(n, n, n);
        for (model, entry) in &entries {
            in_range(&mut faults, &entry.toml, model, &world);
            let fallen = match entry.model {
                "phong" | "metallic-phong" => 0.5 * entry.n * off * off,
                "patch-exponential" => (8.0 * entry.n).sqrt() * off,
                // Whether N·L and N·V bring h_P into so small a disc is chance.
                "patch" if entry.n.sqrt() * off > 1.0 => continue,
                "patch" => 0.0,
                _ => continue,
            };
            // Phong's N·L may be a few roundings below 1.
            let least = (-fallen).exp() - A::LOBE_ERROR - off;
            let share = A::unit_value(model.share(&world).r);
            if share < least {
                faults.add(&entry.toml, || {
                    format!("{share}, at least {least}, at N = {n:?}")
                });
            }
        }
    }
}

/// L = −V in world space: one of them is below the horizon, or both lie in
/// it, and nothing is reflected.
fn opposite_directions_in_any_frame<A: Tested>() {
    let mut rotations = Rotations::new(14);
    let models = models::<A>();
    for pair in Set::Random.pairs(1.0, 1.0, 200) {
        let [l, _] = pair;
        let [n, l, v] = rotations.turn([l, l.map(|c| -c)]).map(rounded::<A>);
        for (name, model) in &models {
            for world in [World::new(n, l, v), World::new(n, v, l)] {
                let shown = bits(model.reflect(&world).to_array());
                assert!(shown.iter().all(|byte| *byte == 0), "{name}, {world:?}");
            }
        }
    }
    let [x, z] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(rounded::<A>);
    let back = rounded::<A>([-1.0, 0.0, 0.0]);
    for (name, model) in &models {
        let shown = bits(model.reflect(&World::new(z, x, back)).to_array());
        assert!(shown.iter().all(|byte| *byte == 0), "{name}");
    }
}

/// What only one of the arithmetics can be given.
mod inputs {
    use super::*;
    use microbrdf::arithmetic::{Arithmetic as _, F32, Q31};
    use microbrdf::brdf::MetallicPhong;
    use microbrdf::fixed::types::I2F30;

    /// All sequences of `length` of the given values.
    fn each<T: Copy>(values: &[T], length: usize, mut call: impl FnMut(&[T])) {
        let mut index = vec![0; length];
        let mut chosen = vec![values[0]; length];
        loop {
            call(&chosen);
            let mut place = 0;
            loop {
                if place == length {
                    return;
                }
                index[place] += 1;
                if index[place] < values.len() {
                    break;
                }
                index[place] = 0;
                place += 1;
            }
            for (chosen, index) in chosen.iter_mut().zip(&index) {
                *chosen = values[*index];
            }
        }
    }

    const EACH: [&str; 16] = [
        "model = \"lambert\", albedo = 1",
        "model = \"phong\", exponent = 1",
        "model = \"phong\", exponent = 20, p = 0.5",
        "model = \"metallic-phong\", exponent = 0",
        "model = \"metallic-phong\", exponent = 1e8",
        "model = \"retro-phong\", exponent = 2",
        "model = \"patch\", radius = 1.5",
        "model = \"patch\", radius = 2",
        "model = \"patch-exponential\", sharpness = 4",
        "model = \"metal\", metal = \"gold\", exponent = 20",
        "model = \"plastic\", albedo = 0.5, specular = 0.5, exponent = 20",
        "model = \"plastic\", albedo = 0.5, specular = 0.5, exponent = 20, index = 1.5",
        "model = \"patch-metal\", radius = 1.5, metal = \"gold\"",
        "model = \"patch-metal\", sharpness = 4, metal = \"gold\"",
        "model = \"metallic-paint\", sharpness = 4, metal = \"gold\"",
        "model = \"generalised-lambert\", albedo = 1, smoothness = 1",
    ];

    #[test]
    fn no_fixed_point_input_leaves_the_range() {
        let mut faults = Faults::default();
        let values = [i32::MIN, -(1 << 30), -1, 0, 1, 1 << 30, i32::MAX].map(I2F30::from_bits);
        let few = [i32::MIN, 0, 1 << 30, i32::MAX].map(I2F30::from_bits);
        for toml in EACH {
            let model = model::<Q31>(toml);
            each(&values, 6, |c| {
                let [l, v] = [0, 3].map(|i| Direction::new(c[i], c[i + 1], c[i + 2]));
                in_range(&mut faults, toml, &model, &ShadingFrame::new(l, v));
            });
            each(&few, 9, |c| {
                let [n, l, v] = [0, 3, 6].map(|i| Direction::new(c[i], c[i + 1], c[i + 2]));
                in_range(&mut faults, toml, &model, &World::new(n, l, v));
            });
        }
    }

    /// Finite numbers of any size, negative zero among them.
    #[test]
    fn no_finite_input_leaves_the_range() {
        let mut faults = Faults::default();
        let values = [f32::MIN, -1.0, -0.0, 0.0, f32::MIN_POSITIVE, 1.0, 1e20];
        let few = [f32::MIN, -0.0, 1.0, 1e-30];
        for toml in EACH {
            let model = model::<F32>(toml);
            each(&values, 6, |c| {
                let [l, v] = [0, 3].map(|i| Direction::new(c[i], c[i + 1], c[i + 2]));
                in_range(&mut faults, toml, &model, &ShadingFrame::new(l, v));
            });
            each(&few, 9, |c| {
                let [n, l, v] = [0, 3, 6].map(|i| Direction::new(c[i], c[i + 1], c[i + 2]));
                in_range(&mut faults, toml, &model, &World::new(n, l, v));
            });
        }
    }

    /// Every mixture of good components of L, V and N and one bad value.
    fn mixtures() -> impl Iterator<Item = [Direction<F32>; 3]> {
        const GOOD: [f32; 9] = [0.6, 0.0, 0.8, -0.48, 0.36, 0.8, 0.0, 0.0, 1.0];
        let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
        bad.into_iter().flat_map(|bad| {
            (1..512).map(move |mask| {
                let c = |i: usize| if mask >> i & 1 == 1 { bad } else { GOOD[i] };
                [0, 3, 6].map(|i| Direction::new(c(i), c(i + 1), c(i + 2)))
            })
        })
    }

    /// What is not a number, or infinite, never shows as such.
    #[test]
    fn not_a_number_and_infinity_stay_in_range() {
        let mut faults = Faults::default();
        for toml in EACH {
            let model = model::<F32>(toml);
            for [l, v, n] in mixtures() {
                in_range(&mut faults, toml, &model, &World::new(n, l, v));
                in_range(&mut faults, toml, &model, &ShadingFrame::new(l, v));
            }
        }
    }

    /// The documentation of [`Direction`]: what is not a finite number makes
    /// the result 0.
    #[test]
    fn not_a_number_and_infinity_give_zero() {
        let mut faults = Faults::default();
        let finite = |d: &Direction<F32>| [d.x, d.y, d.z].into_iter().all(f32::is_finite);
        for toml in EACH {
            let model = model::<F32>(toml);
            for [l, v, n] in mixtures() {
                is_zero(&mut faults, toml, &model, &World::new(n, l, v));
                if !finite(&l) || !finite(&v) {
                    let name = format!("{toml}, in the shading frame");
                    is_zero(&mut faults, &name, &model, &ShadingFrame::new(l, v));
                }
            }
        }
    }

    /// A gain or a peak that is no number shows as black, an infinite one as
    /// black, white or the greatest number.
    #[test]
    fn gains_and_peaks_that_are_no_numbers_stay_in_range() {
        let there = frame::<F32>([-0.6, 0.0, 0.8], [0.6, 0.0, 0.8]);
        let beside = frame::<F32>([-0.6, 0.0, 0.8], [0.0, 0.6, 0.8]);
        for toml in EACH {
            let model = model::<F32>(toml);
            for geometry in [there, beside] {
                let shown = |gain: f32| F32::linear(model.shade(&Rgb::grey(gain), &geometry));
                assert_eq!(shown(f32::NAN).to_raw(), [0; 3], "{toml}");
                assert_eq!(shown(f32::NEG_INFINITY).to_raw(), [0; 3], "{toml}");
                for value in shown(f32::INFINITY).to_raw() {
                    assert!(value == 0 || value == 1 << 24, "{toml}: {value}");
                }
            }
        }
        let lobe = MetallicPhong::<F32>::new(20.0).expect("an exponent");
        for (peak, greatest) in [(f32::NAN, 0.0), (f32::INFINITY, f32::MAX)] {
            let lobe = lobe.with_peak(peak);
            for value in [lobe.reflect(&there).r, lobe.brdf(&there).r] {
                assert_eq!(value, greatest, "peak {peak}");
            }
        }
    }

    /// −0.0 is the cosine 0, not one below the horizon.
    #[test]
    fn negative_zero_is_zero() {
        let mut faults = Faults::default();
        for toml in EACH {
            let model = model::<F32>(toml);
            for (lz, vz) in [(0.0f32, 0.0f32), (0.0, 0.8), (0.8, 0.0)] {
                let results = |zero: f32| {
                    let z = |z: f32| if z == 0.0 { zero } else { z };
                    let l = Direction::new((1.0 - lz * lz).sqrt(), 0.0, z(lz));
                    let v = Direction::new(-(1.0 - vz * vz).sqrt(), 0.0, z(vz));
                    let geometry = ShadingFrame::new(l, v);
                    [
                        model.share(&geometry).r,
                        model.reflect(&geometry).r,
                        model.brdf(&geometry).r,
                    ]
                };
                let (plain, negative) = (results(0.0), results(-0.0));
                if bits(plain) != bits(negative) {
                    faults.add(&format!("{toml}, cosines {lz} and {vz}"), || {
                        format!("{negative:?} for {plain:?}")
                    });
                }
            }
        }
    }
}
