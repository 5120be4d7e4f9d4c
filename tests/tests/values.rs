//! Values that tell right code from wrong code that albedo tests pass:
//! against closed forms, and against what the wrong formula would give.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Geometry, ShadingFrame};
use microbrdf_reference::fresnel::conductor;
use microbrdf_scene::{AnyModel, Material};
use microbrdf_tests::arithmetic::{Tested, rounded};
use microbrdf_tests::in_every_arithmetic;

in_every_arithmetic!(
    the_mirror_direction_gives_the_peak,
    only_the_retro_lobe_returns_light_from_45_degrees_on,
    a_lobe_turned_sideways_keeps_its_width,
    the_patch_is_a_disc_of_its_radius_about_r,
    fresnel_is_taken_at_the_smaller_angle,
    channels_keep_their_places,
    gold_is_yellow_and_copper_is_red,
    the_lobe_is_divided_by_the_larger_cosine,
    the_p_model_lies_between_at_its_power,
    the_ratio_is_of_light_to_viewer,
    plastic_is_the_sum_of_its_parts,
    an_index_puts_fresnels_factor_on_the_highlight,
    a_metal_of_patches_has_fresnels_factor_at_the_smaller_angle,
    a_metallic_paint_has_fresnels_factor_at_its_own_angle,
    generalised_lambert_is_the_closed_form,
    the_full_moon_is_flat,
);

fn model<A: Tested>(toml: &str) -> AnyModel<A> {
    Material::from_argument(toml)
        .expect("a material")
        .model()
        .expect("a material that the arithmetic takes")
}

/// The direction at angles in degrees.
fn at(theta: f64, phi: f64) -> [f64; 3] {
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    [
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    ]
}

fn frame<A: Tested>(l: [f64; 3], v: [f64; 3]) -> ShadingFrame<A> {
    ShadingFrame::new(rounded(l), rounded(v))
}

fn share<A: Tested>(model: &AnyModel<A>, geometry: &impl Geometry<A>) -> [f64; 3] {
    model.share(geometry).to_array().map(A::unit_value)
}

fn brdf<A: Tested>(model: &AnyModel<A>, geometry: &impl Geometry<A>) -> [f64; 3] {
    model.brdf(geometry).to_array().map(A::value_value)
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} for {expected}: off by {:e}, may be {tolerance:e}",
        found - expected
    );
}

/// Twenty angles, the horizon all but touched.
fn angles() -> impl Iterator<Item = f64> {
    (0..=19).map(|i| 4.7 * f64::from(i)).chain([89.9, 89.999])
}

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

/// m is measured in the base plane, between R and V, in any azimuth.
fn the_patch_is_a_disc_of_its_radius_about_r<A: Tested>() {
    let l = at(40.0, 200.0);
    for radius in [0.05, 0.3] {
        let patch = model::<A>(&format!("model = \"patch\", radius = {radius}"));
        for phi in 0..24 {
            let (s, c) = (15.0 * f64::from(phi)).to_radians().sin_cos();
            for (m, inside) in [(0.999 * radius, true), (1.001 * radius, false)] {
                let (x, y) = (-l[0] + m * c, -l[1] + m * s);
                let v = [x, y, (1.0 - x * x - y * y).sqrt()];
                let geometry = frame::<A>(l, v);
                let expected = if inside {
                    A::component_value(geometry.l.z)
                } else {
                    0.0
                };
                close(share(&patch, &geometry)[0], expected, A::UNIT_STEP);
            }
        }
    }
    // R ≤ 1: 1/(πR²); above, the part inside the base circle alone.
    for (radius, peak) in [(0.5, 4.0), (1.0, 1.0), (1.7, 1.0)] {
        let patch = model::<A>(&format!("model = \"patch\", radius = {radius}"));
        let found = A::scale_value(patch.peak()) * std::f64::consts::PI;
        close(found, peak, 1e-6);
    }
}

const ETA: [f64; 3] = [0.2, 0.9, 2.0];
const K: [f64; 3] = [3.9, 2.4, 1.3];

fn distinct_metal<A: Tested>(n: f64) -> AnyModel<A> {
    model(&format!(
        "model = \"metal\", exponent = {n}, eta = {ETA:?}, k = {K:?}"
    ))
}

/// Of weak absorbers, whose reflectance changes most with the angle.
fn fresnel_is_taken_at_the_smaller_angle<A: Tested>() {
    const ETA: [f64; 3] = [1.5, 1.8, 2.4];
    const K: [f64; 3] = [0.0, 0.1, 0.3];
    // A lobe of n = 0 is 1 all over the pairs.
    let metal = model::<A>(&format!(
        "model = \"metal\", exponent = 0, eta = {ETA:?}, k = {K:?}"
    ));
    for (theta_l, theta_v) in [(15.0, 80.0), (80.0, 15.0), (50.0, 88.0), (85.0, 60.0)] {
        let (l, v) = (at(theta_l, 0.0), at(theta_v, 170.0));
        let geometry = frame::<A>(l, v);
        let (larger, smaller) = (l[2].max(v[2]), l[2].min(v[2]));
        let h = [0, 1, 2].map(|i| l[i] + v[i]);
        let length = h.iter().map(|c| c * c).sum::<f64>().sqrt();
        let n_dot_h = h[2] / length;
        let l_dot_h = (0..3).map(|i| h[i] * l[i]).sum::<f64>() / length;
        let found = share(&metal, &geometry);
        for channel in 0..3 {
            let at = |cosine: f64| conductor(ETA[channel], K[channel], cosine);
            let reflectance = found[channel] / (l[2] / larger);
            close(reflectance, at(larger), 1e-4);
            for wrong in [at(smaller), at(n_dot_h), at(l_dot_h)] {
                assert!(
                    (reflectance - wrong).abs() > 5e-4,
                    "{theta_l}, {theta_v}: {reflectance} is as near to {wrong}"
                );
            }
        }
    }
}

fn channels_keep_their_places<A: Tested>() {
    let (l, v) = (at(30.0, 10.0), at(35.0, 185.0));
    let geometry = frame::<A>(l, v);
    let larger = l[2].max(v[2]);
    let gains = Rgb {
        r: A::gain(0.25),
        g: A::gain(0.5),
        b: A::gain(1.0),
    };
    let plastic_highlight = {
        let mirror_dot_v = -l[0] * v[0] - l[1] * v[1] + l[2] * v[2];
        mirror_dot_v.powi(5) / larger
    };
    let c = 7.0 / std::f64::consts::TAU;
    let pi = std::f64::consts::PI;
    for (toml, expected) in [
        (
            "model = \"lambert\", albedo = [0.9, 0.5, 0.2]",
            [0.9, 0.5, 0.2].map(|a| a / pi),
        ),
        (
            "model = \"plastic\", albedo = [0.1, 0.4, 0.2], specular = [0.3, 0.1, 0.6], exponent = 5",
            [(0.1, 0.3), (0.4, 0.1), (0.2, 0.6)].map(|(a, s)| a / pi + s * c * plastic_highlight),
        ),
    ] {
        let model = model::<A>(toml);
        let found = brdf(&model, &geometry);
        let peak = A::scale_value(model.peak());
        let shown = A::linear(model.shade(&gains, &geometry)).to_raw();
        for channel in 0..3 {
            let room = (A::LOBE_ERROR + 1e-5) * expected[channel];
            close(found[channel], expected[channel], room);
            let reflected = A::radiance_value(model.reflect(&geometry).to_array()[channel]);
            close(reflected, expected[channel] * l[2], room);
            let gain = [0.25, 0.5, 1.0][channel];
            let light = f64::from(shown[channel]) / f64::from(1 << 24);
            close(light, gain * expected[channel] * l[2] / peak, room);
        }
    }
    let metal = share(
        &distinct_metal::<A>(0.0),
        &frame::<A>(l, [-l[0], -l[1], l[2]]),
    );
    for channel in 0..3 {
        close(
            metal[channel],
            conductor(ETA[channel], K[channel], l[2]),
            6e-4,
        );
    }
}

fn gold_is_yellow_and_copper_is_red<A: Tested>() {
    for theta in [0.0, 30.0, 60.0, 75.0] {
        let l = at(theta, 0.0);
        let mirror = frame::<A>(l, [-l[0], -l[1], l[2]]);
        let metal = |name: &str| {
            let toml = format!("model = \"metal\", exponent = 20, metal = \"{name}\"");
            share(&model::<A>(&toml), &mirror)
        };
        let [r, g, b] = metal("gold");
        assert!(
            r > g + 0.01 && g > b + 0.05 && b < 0.75,
            "gold at {theta}: {r} {g} {b}"
        );
        let [r, g, b] = metal("copper");
        assert!(
            r > g + 0.1 && g > b + 0.01,
            "copper at {theta}: {r} {g} {b}"
        );
        let [r, g, b] = metal("silver");
        assert!(r >= g && g > b && b > 0.8, "silver at {theta}: {r} {g} {b}");
        let [r, g, b] = metal("aluminium");
        assert!(
            b > g && g > r && r > 0.85,
            "aluminium at {theta}: {r} {g} {b}"
        );
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

/// (3.30) against (3.31): the highlight times F(Θmin), the diffuser as it is.
fn an_index_puts_fresnels_factor_on_the_highlight<A: Tested>() {
    let parts = "model = \"plastic\", albedo = [0.1, 0.4, 0.2], specular = [0.3, 0.1, 0.6]";
    let white = model::<A>(&format!("{parts}, exponent = 6"));
    let glossy = model::<A>(&format!("{parts}, exponent = 6, index = 1.5"));
    assert_eq!(white.peak(), glossy.peak());
    for (theta_l, theta_v) in [(10.0, 25.0), (60.0, 70.0), (84.0, 80.0), (30.0, 75.0)] {
        let geometry = frame::<A>(at(theta_l, 0.0), at(theta_v, 176.0));
        let (l, v) = (at(theta_l, 0.0), at(theta_v, 176.0));
        let fresnel = conductor(1.5, 0.0, l[2].max(v[2]));
        let (without, with) = (brdf(&white, &geometry), brdf(&glossy, &geometry));
        for (channel, albedo) in [0.1, 0.4, 0.2].into_iter().enumerate() {
            let body = albedo * std::f64::consts::FRAC_1_PI;
            let highlight = without[channel] - body;
            assert!(highlight > 0.01, "{highlight}");
            // The curve of glass is off by 1.4e-4.
            let room = (3e-4 + 2.0 * A::PRODUCT_ERROR) * without[channel] + 2e-9;
            close(with[channel], body + fresnel * highlight, room);
            let reflected = A::radiance_value(glossy.reflect(&geometry).to_array()[channel]);
            close(reflected, with[channel] * l[2], room);
            let whole = A::scale_value(glossy.peak()) * share(&glossy, &geometry)[channel];
            close(whole, with[channel] * l[2], room);
        }
    }
}

/// Weak absorbers' indices, whose reflectance changes most with the angle.
const PAINT: &str = "eta = [1.5, 1.8, 2.4], k = [0, 0.1, 0.3]";

/// A model of patches with [`PAINT`]'s Fresnel factor, of which `profile` and
/// its peak are the shape, against the reflectance at a cosine; it must be
/// nearer to that than to those at `others`.
fn has_fresnels_factor<A: Tested>(
    toml: &str,
    profile: impl Fn(f64) -> f64,
    cosine: impl Fn([f64; 3], [f64; 3]) -> f64,
    others: impl Fn([f64; 3], [f64; 3]) -> Vec<f64>,
) {
    let model = model::<A>(&format!("{toml}, {PAINT}"));
    for (theta_l, theta_v, phi) in [
        (15.0, 70.0, 150.0),
        (80.0, 30.0, 170.0),
        (62.0, 85.0, 100.0),
    ] {
        let (l, v) = (at(theta_l, 0.0), at(theta_v, phi));
        let found = share(&model, &frame::<A>(l, v));
        let shape = profile((l[0] + v[0]).hypot(l[1] + v[1])) * l[2];
        assert!(shape > 0.01);
        for channel in 0..3 {
            let (eta, k) = ([1.5, 1.8, 2.4][channel], [0.0, 0.1, 0.3][channel]);
            let reflectance = found[channel] / shape;
            let exact = conductor(eta, k, cosine(l, v));
            close(reflectance, exact, 2e-4 + 2.0 * A::LOBE_ERROR * exact);
            for wrong in others(l, v) {
                let wrong = conductor(eta, k, wrong);
                assert!(
                    (reflectance - wrong).abs() > 3.0 * (reflectance - exact).abs() + 2e-4,
                    "{theta_l}, {theta_v}: {reflectance} is as near to {wrong} as to {exact}"
                );
            }
        }
    }
}

/// √(1 − |L_P − V_P|²/4), as (4.53) has it.
fn cos_theta_prime(l: [f64; 3], v: [f64; 3]) -> f64 {
    let half = 0.5 * (l[0] - v[0]).hypot(l[1] - v[1]);
    (1.0 - half * half).sqrt()
}

fn a_metal_of_patches_has_fresnels_factor_at_the_smaller_angle<A: Tested>() {
    for (toml, profile) in [
        (
            "model = \"patch-metal\", sharpness = 0.5",
            (|m: f64| (-0.5 * m).exp()) as fn(f64) -> f64,
        ),
        ("model = \"patch-metal\", radius = 2", |_| 1.0),
    ] {
        has_fresnels_factor::<A>(
            toml,
            profile,
            |l, v| l[2].max(v[2]),
            |l, v| vec![cos_theta_prime(l, v), l[2].min(v[2])],
        );
    }
}

fn a_metallic_paint_has_fresnels_factor_at_its_own_angle<A: Tested>() {
    has_fresnels_factor::<A>(
        "model = \"metallic-paint\", sharpness = 0.5",
        |m| (-0.5 * m).exp(),
        cos_theta_prime,
        |l, v| vec![l[2].max(v[2]), l[2].min(v[2])],
    );
}

/// C is 0.27128 for d = 0.5 in Table 4.3, whose constants are up to 5.2e-4 of
/// their value too great.
fn generalised_lambert_is_the_closed_form<A: Tested>() {
    let matt =
        model::<A>("model = \"generalised-lambert\", albedo = [0.8, 0.3, 0.1], smoothness = 0.5");
    let profile = |m: f64| (1.0 - 0.25 * m * m).powf(-0.25);
    let greatest = profile(1.9);
    let peak = 0.27128 * greatest;
    close(A::scale_value(matt.peak()), peak, 5.2e-4 * peak);
    let mut clipped = 0;
    for theta in [5.0, 30.0, 60.0, 72.0, 75.0, 80.0, 88.0] {
        for (other, phi) in [(theta, 0.0), (theta, 180.0), (80.0, 20.0), (40.0, 60.0)] {
            let (l, v) = (at(theta, 0.0), at(other, phi));
            let m = (l[0] + v[0]).hypot(l[1] + v[1]);
            let expected = profile(m.min(1.9)) / greatest * l[2];
            clipped += u32::from(m > 1.9);
            let found = share(&matt, &frame::<A>(l, v));
            for (channel, albedo) in [0.8, 0.3, 0.1].into_iter().enumerate() {
                close(
                    found[channel],
                    albedo * expected,
                    4e-4 * expected + 2.0 * A::PRODUCT_ERROR,
                );
            }
        }
    }
    assert!(clipped >= 4);
}

/// d = 1, L = V: the same radiance to where the clip begins, at 71.8°.
fn the_full_moon_is_flat<A: Tested>() {
    let moon = model::<A>("model = \"generalised-lambert\", albedo = 1, smoothness = 1");
    let at_angle = |theta: f64| share(&moon, &frame::<A>(at(theta, 40.0), at(theta, 40.0)))[0];
    let middle = at_angle(0.0);
    for theta in [10.0, 30.0, 50.0, 65.0, 71.0] {
        close(at_angle(theta), middle, 1e-3 * middle);
    }
    assert!(at_angle(80.0) < 0.7 * middle);
}
