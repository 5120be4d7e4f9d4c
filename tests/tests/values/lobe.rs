//! Of cosⁿα lobes.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;

use crate::{angles, at, brdf, close, share};

in_every_arithmetic!(
    the_mirror_direction_gives_the_peak,
    only_the_retro_lobe_returns_light_from_45_degrees_on,
    a_lobe_turned_sideways_keeps_its_width,
    the_lobe_is_divided_by_the_larger_cosine,
    the_ratio_is_of_light_to_viewer,
    the_p_model_lies_between_at_its_power,
    plastic_is_the_sum_of_its_parts,
);

fn the_mirror_direction_gives_the_peak<A: Tested>() {
    for n in [0.0, 1.0, 20.0, 5e3, 1e8] {
        let metallic = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        let retro = model::<A>(&format!("model = \"retro-phong\", exponent = {n}"));
        let phong = model::<A>(&format!("model = \"phong\", exponent = {n}"));
        for theta in angles() {
            let l = at(theta, 30.0);
            let mirror = frame::<A>(l, [-l[0], -l[1], l[2]]);
            // A cosine that is rounded to 0 follows the horizon's rule.
            if mirror.l.cosine() == A::COSINE_ZERO {
                continue;
            }
            // Not "about 1": the middle of a highlight must not be dimmed.
            assert_eq!(metallic.share(&mirror), Rgb::grey(A::ONE), "{mirror:?}");
            let peak = A::scale_value(metallic.peak());
            let reflected = A::radiance_value(metallic.reflect(&mirror).r);
            assert_eq!(reflected, peak, "{mirror:?}");
            let cosine = A::component_value(mirror.l.z);
            close(
                brdf(&metallic, &mirror)[0] * cosine / peak,
                1.0,
                2.0 * A::UNIT_STEP,
            );
            close(share(&phong, &mirror)[0], cosine, A::UNIT_STEP);
            assert_eq!(retro.share(&frame::<A>(l, l)), Rgb::grey(A::ONE));
        }
    }
    for toml in [
        "model = \"patch\", radius = 1e-4",
        "model = \"patch-exponential\", sharpness = 4096",
    ] {
        let patch = model::<A>(toml);
        for theta in angles() {
            let l = at(theta, 250.0);
            let mirror = frame::<A>(l, [-l[0], -l[1], l[2]]);
            close(
                share(&patch, &mirror)[0],
                A::component_value(mirror.l.z),
                A::UNIT_STEP,
            );
        }
    }
}

/// R·L = cos 2Θ ≤ 0 from 45° on.
fn only_the_retro_lobe_returns_light_from_45_degrees_on<A: Tested>() {
    let gold = "model = \"metal\", metal = \"gold\", exponent = 2";
    for theta in [45.01, 50.0, 60.0, 75.0, 89.0, 89.99] {
        let l = at(theta, 77.0);
        let [back, mirror] = [frame::<A>(l, l), frame::<A>(l, [-l[0], -l[1], l[2]])];
        for toml in [
            "model = \"metallic-phong\", exponent = 0",
            "model = \"metallic-phong\", exponent = 1",
            "model = \"metallic-phong\", exponent = 20",
            "model = \"phong\", exponent = 1",
            "model = \"phong\", exponent = 1, p = 0.5",
            "model = \"patch\", radius = 1.4",
            gold,
        ] {
            let model = model::<A>(toml);
            assert_eq!(brdf(&model, &back), [0.0; 3], "{toml} at {theta}");
            assert!(brdf(&model, &mirror)[0] > 0.0, "{toml} at {theta}");
        }
        for n in [0, 1, 20] {
            let retro = model::<A>(&format!("model = \"retro-phong\", exponent = {n}"));
            assert_eq!(retro.share(&back), Rgb::grey(A::ONE), "n = {n} at {theta}");
            assert_eq!(brdf(&retro, &mirror), [0.0; 3], "n = {n} at {theta}");
        }
    }
    // And below, both do: cosⁿ(2Θ).
    for theta in [5.0, 20.0, 40.0, 44.0] {
        let l = at(theta, 77.0);
        let lobe = model::<A>("model = \"metallic-phong\", exponent = 3");
        let expected = (2.0 * theta.to_radians()).cos().powi(3);
        close(
            share(&lobe, &frame::<A>(l, l))[0],
            expected,
            A::LOBE_ERROR + 1e-6,
        );
    }
}

/// 80°, V turned by 0.05 rad: R·V to the 20th is 0.976, where the half
/// vector's short cut 2(N·H)² − 1 gives 0.448.
fn a_lobe_turned_sideways_keeps_its_width<A: Tested>() {
    let (l, v) = (at(80.0, 0.0), at(80.0, 180.0 + 0.05f64.to_degrees()));
    let geometry = frame::<A>(l, v);
    let mirror_dot_v = -l[0] * v[0] - l[1] * v[1] + l[2] * v[2];
    for n in [1.0, 20.0, 500.0, 5e3] {
        let lobe = model::<A>(&format!("model = \"metallic-phong\", exponent = {n}"));
        let expected = mirror_dot_v.powf(n);
        close(
            share(&lobe, &geometry)[0],
            expected,
            (A::LOBE_ERROR + n.sqrt() * (1e-6 + 4.0 * A::COMPONENT_ERROR)) * expected + 1e-9,
        );
        if n == 20.0 {
            close(expected, 0.976, 5e-4);
        }
    }
}

fn the_lobe_is_divided_by_the_larger_cosine<A: Tested>() {
    let (l, v) = (at(20.0, 0.0), at(50.0, 180.0));
    let lobe = model::<A>("model = \"metallic-phong\", exponent = 4");
    let c = 6.0 / std::f64::consts::TAU;
    let power = 30f64.to_radians().cos().powi(4);
    for geometry in [frame::<A>(l, v), frame::<A>(v, l)] {
        let expected = c * power / l[2];
        close(
            brdf(&lobe, &geometry)[0],
            expected,
            expected * (A::LOBE_ERROR + 1e-6),
        );
    }
}

/// f·cosΘL is the lobe where the light is higher, and falls with its cosine
/// where it is lower.
fn the_ratio_is_of_light_to_viewer<A: Tested>() {
    let (high, low) = (at(20.0, 0.0), at(50.0, 180.0));
    let lobe = model::<A>("model = \"metallic-phong\", exponent = 4");
    let power = 30f64.to_radians().cos().powi(4);
    let room = A::LOBE_ERROR + 1e-6;
    close(share(&lobe, &frame::<A>(high, low))[0], power, room);
    let expected = power * low[2] / high[2];
    close(share(&lobe, &frame::<A>(low, high))[0], expected, room);
}

/// f_p = f_0^(1−p) · f_1^p.
fn the_p_model_lies_between_at_its_power<A: Tested>() {
    for (theta_l, theta_v) in [(20.0, 50.0), (70.0, 60.0), (88.0, 89.5)] {
        let geometry = frame::<A>(at(theta_l, 0.0), at(theta_v, 184.0));
        let at_p = |p: f64| {
            let toml = format!("model = \"phong\", exponent = 4, p = {p}");
            brdf(&model::<A>(&toml), &geometry)[0]
        };
        let (flat, metallic) = (at_p(0.0), at_p(1.0));
        let mut before = flat;
        for p in [0.1, 0.25, 0.5, 0.75, 0.9] {
            let found = at_p(p);
            let expected = flat.powf(1.0 - p) * metallic.powf(p);
            close(found, expected, (2e-5 + 2.0 * A::PRODUCT_ERROR) * expected);
            assert!(found > before && found < metallic);
            before = found;
        }
    }
}

fn plastic_is_the_sum_of_its_parts<A: Tested>() {
    let plastic = model::<A>("model = \"plastic\", albedo = 0.5, specular = 0.25, exponent = 30");
    let lambert = model::<A>("model = \"lambert\", albedo = 0.5");
    let lobe = model::<A>("model = \"metallic-phong\", exponent = 30");
    for (theta_l, theta_v, phi) in [(40.0, 45.0, 185.0), (80.0, 10.0, 20.0), (60.0, 66.0, 178.0)] {
        let geometry = frame::<A>(at(theta_l, 0.0), at(theta_v, phi));
        let reflect = |model: &AnyModel<A>| A::radiance_value(model.reflect(&geometry).r);
        let sum = reflect(&lambert) + 0.25 * reflect(&lobe);
        close(reflect(&plastic), sum, A::PRODUCT_ERROR * sum + 2e-9);
        let whole = A::scale_value(plastic.peak()) * share(&plastic, &geometry)[0];
        close(whole, sum, A::PRODUCT_ERROR * sum + 2e-8);
        let f = brdf(&lambert, &geometry)[0] + 0.25 * brdf(&lobe, &geometry)[0];
        close(brdf(&plastic, &geometry)[0], f, A::PRODUCT_ERROR * f + 2e-9);
    }
}
