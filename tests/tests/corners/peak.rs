//! At the mirror direction, one step beside it, and along the normal.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Geometry, ShadingFrame, World};
use microbrdf_tests::arithmetic::{Tested, rounded, value_of};
use microbrdf_tests::domain::Set;
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::{in_every_arithmetic, registry};

use crate::faults::{Faults, in_range, is_zero};
use crate::models;

in_every_arithmetic!(
    along_the_normal_everything_shows_its_peak,
    along_any_normal_a_lobe_shows_its_peak,
    a_step_beside_the_mirror_direction_dims_nothing,
    no_normal_makes_a_highlight_black,
);

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
