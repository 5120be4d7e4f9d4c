//! What holds for any reflectance model, and the limits that tie the models
//! to each other; energy is in `energy.rs`.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Geometry, ShadingFrame, World};
use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::{Tested, bits, rounded};
use microbrdf_tests::domain::{Pair, Set};
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;
use microbrdf_tests::registry::{self, Entry};

/// Pairs in each set, for each entry of the registry.
const SAMPLES: usize = 300;

in_every_arithmetic!(
    swapping_the_directions_changes_no_bit,
    nothing_reflects_more_than_the_peak,
    below_the_horizon_all_is_zero,
    peaks_are_the_references,
    the_widest_patch_is_lambert,
    the_dullest_mixture_is_lambert,
    a_vanishing_sharpness_tends_to_lambert,
);

/// Calls `each` with every model of the registry and samples of every set.
fn each_pair<A: Tested>(mut each: impl FnMut(&Entry, &AnyModel<A>, Set, Pair)) {
    for entry in registry::all() {
        let model = entry.material().model::<A>().expect("a material");
        for set in Set::ALL {
            for pair in entry.pairs(set, 12.0, SAMPLES) {
                each(&entry, &model, set, pair);
            }
        }
    }
}

fn swapping_the_directions_changes_no_bit<A: Tested>() {
    let mut rotations = Rotations::new(7);
    let mut lit = 0;
    each_pair::<A>(|entry, model, set, pair| {
        let there = frame::<A>(pair[0], pair[1]);
        let back = ShadingFrame::new(there.v, there.l);
        let f = bits(model.brdf(&there).to_array());
        assert_eq!(
            f,
            bits(model.brdf(&back).to_array()),
            "{}, {set:?}, {there:?}",
            entry.toml
        );
        lit += u32::from(f.iter().any(|byte| *byte != 0));

        let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
        let [there, back] = [World::new(n, l, v), World::new(n, v, l)];
        assert_eq!(
            bits(model.brdf(&there).to_array()),
            bits(model.brdf(&back).to_array()),
            "{}, {set:?}, {there:?}",
            entry.toml
        );
    });
    assert!(lit > 50_000, "only {lit} pairs showed anything");
}

/// f·cosΘL ≤ c, and the share within [0, 1]; a metal's by its reflectance.
fn nothing_reflects_more_than_the_peak<A: Tested>() {
    let check = |entry: &Entry, model: &AnyModel<A>, geometry: &dyn Fn() -> Shown<A>| {
        let shown = geometry();
        for channel in 0..3 {
            let share = A::unit_value(shown.share[channel]);
            assert!(
                (0.0..=1.0).contains(&share) && A::at_most(shown.reflected[channel], model.peak()),
                "{}: {shown:?}",
                entry.toml
            );
        }
    };
    let mut rotations = Rotations::new(8);
    each_pair::<A>(|entry, model, _, pair| {
        check(entry, model, &|| show(model, &frame::<A>(pair[0], pair[1])));
        let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
        check(entry, model, &|| show(model, &World::new(n, l, v)));
    });
}

#[derive(Debug)]
#[expect(dead_code, reason = "shown in messages")]
struct Shown<A: Tested> {
    cosines: (A::Cosine, A::Cosine),
    share: [A::Unit; 3],
    reflected: [A::Radiance; 3],
}

fn show<A: Tested>(model: &AnyModel<A>, geometry: &impl Geometry<A>) -> Shown<A> {
    Shown {
        cosines: geometry.cosines(),
        share: model.share(geometry).to_array(),
        reflected: model.reflect(geometry).to_array(),
    }
}

fn below_the_horizon_all_is_zero<A: Tested>() {
    let zero = A::component(0.0);
    let gain = Rgb::grey(A::gain(2e7));
    let mut seen = 0;
    each_pair::<A>(|entry, model, set, pair| {
        if set != Set::Outside {
            return;
        }
        let geometry = frame::<A>(pair[0], pair[1]);
        if geometry.l.z >= zero && geometry.v.z >= zero {
            return;
        }
        seen += 1;
        let all = [
            bits(model.share(&geometry).to_array()),
            bits(model.brdf(&geometry).to_array()),
            bits(model.reflect(&geometry).to_array()),
        ];
        assert!(
            all.concat().iter().all(|byte| *byte == 0),
            "{}: {geometry:?} gives {all:x?}",
            entry.toml
        );
        assert_eq!(A::linear(model.shade(&gain, &geometry)).to_raw(), [0; 3]);
    });
    assert!(seen > 10_000, "only {seen} pairs lay below");
}

fn peaks_are_the_references<A: Tested>() {
    let mut materials = registry::all();
    if A::FRACTIONAL_EXPONENTS {
        for n in [1e-6, 0.25, 0.5, 0.75] {
            materials.push(Entry {
                model: "metallic-phong",
                toml: format!("model = \"metallic-phong\", exponent = {n}"),
                n,
            });
        }
    }
    for entry in materials {
        let material = entry.material().rounded::<A>();
        let found = A::scale_value(material.model::<A>().expect("a material").peak());
        let exact = material.reference().peak();
        let [relative, absolute] = A::SCALE_STEP;
        // A plastic's peak is a sum of two products, one with a share of 0.3
        // rounded to half a step.
        let steps = if entry.model.starts_with("plastic") {
            3.0 + 2.0 * A::UNIT_STEP * exact / absolute.max(relative * exact)
        } else {
            1.0
        };
        assert!(
            (found - exact).abs() <= steps * (relative * exact + absolute) + 4e-16 * exact,
            "{}: {found} for {exact}",
            entry.toml
        );
    }
}

/// The same bits, over all sets.
fn same<A: Tested>(a: &str, b: &str) {
    let (a, b) = (model::<A>(a), model::<A>(b));
    assert_eq!(a.peak(), b.peak());
    let mut rotations = Rotations::new(9);
    for set in Set::ALL {
        for pair in set.pairs(1.0, 12.0, SAMPLES) {
            let geometry = frame::<A>(pair[0], pair[1]);
            assert_eq!(
                bits(a.brdf(&geometry).to_array()),
                bits(b.brdf(&geometry).to_array()),
                "{geometry:?}"
            );
            assert_eq!(
                bits(a.share(&geometry).to_array()),
                bits(b.share(&geometry).to_array()),
                "{geometry:?}"
            );
            let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
            let world = World::new(n, l, v);
            assert_eq!(
                bits(a.reflect(&world).to_array()),
                bits(b.reflect(&world).to_array()),
                "{world:?}"
            );
        }
    }
}

fn the_widest_patch_is_lambert<A: Tested>() {
    same::<A>(
        "model = \"patch\", radius = 2",
        "model = \"lambert\", albedo = 1",
    );
}

fn the_dullest_mixture_is_lambert<A: Tested>() {
    same::<A>(
        "model = \"patch-exponential\", sharpness = 0",
        "model = \"lambert\", albedo = 1",
    );
}

/// 1 − 2s ≤ e^(−s·m) ≤ 1 for m in [0, 2], and not all at the upper end.
fn a_vanishing_sharpness_tends_to_lambert<A: Tested>() {
    let lambert = model::<A>("model = \"lambert\", albedo = 1");
    let mut before = f64::INFINITY;
    for s in [1e-1, 1e-2, 1e-3, 1e-4] {
        let mixture = model::<A>(&format!("model = \"patch-exponential\", sharpness = {s}"));
        let mut greatest = 0.0f64;
        for pair in Set::Random.pairs(1.0, 12.0, 2000) {
            let geometry = frame::<A>(pair[0], pair[1]);
            let [m, l] = [&mixture, &lambert].map(|model| A::unit_value(model.share(&geometry).r));
            let loss = l - m;
            assert!(
                loss >= -2.0 * A::UNIT_STEP && loss <= 2.0 * s * l + 2.0 * A::UNIT_STEP,
                "s = {s}: {m} for {l}, {geometry:?}"
            );
            greatest = greatest.max(loss / l);
        }
        assert!(
            greatest > s && greatest < before,
            "s = {s}: loses at most {greatest}"
        );
        before = greatest;
        // C(s) = (1 + 2s/3 + …)/π.
        let excess = A::scale_value(mixture.peak()) / A::scale_value(lambert.peak()) - 1.0;
        assert!(
            (excess - 2.0 * s / 3.0).abs() <= 0.2 * s * s + 3e-7,
            "s = {s}: {excess}"
        );
    }
}
