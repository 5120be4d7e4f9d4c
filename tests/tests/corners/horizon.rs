//! Along the horizon and below it.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::World;
use microbrdf_tests::arithmetic::{Tested, bits, rounded};
use microbrdf_tests::domain::Set;
use microbrdf_tests::frame::Rotations;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;

use crate::faults::{Faults, in_range, is_zero};
use crate::models;

in_every_arithmetic!(
    light_at_the_horizon_reflects_nothing,
    a_viewer_at_the_horizon_sees_the_lobe,
    both_at_the_horizon_saturate,
    beyond_a_right_angle_a_lobe_is_zero_even_flat,
    opposite_directions,
    opposite_directions_in_any_frame,
);

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
