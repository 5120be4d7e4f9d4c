//! Of Fresnel's factor, channel by channel.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf_reference::fresnel::conductor;
use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::given::{frame, model};
use microbrdf_tests::in_every_arithmetic;

use crate::{at, brdf, close, share};

in_every_arithmetic!(
    fresnel_is_taken_at_the_smaller_angle,
    channels_keep_their_places,
    gold_is_yellow_and_copper_is_red,
    an_index_puts_fresnels_factor_on_the_highlight,
    a_metal_of_patches_has_fresnels_factor_at_the_smaller_angle,
    a_metallic_paint_has_fresnels_factor_at_its_own_angle,
);

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
