//! Highlights narrower than a pixel.

use microbrdf_reference::{Brdf, Direction, Energy, models::MetallicPhong};
use microbrdf_scene::{Description, Material};
use microbrdf_tests::flicker::{ARITHMETICS, MATERIALS, document, flicker};

#[test]
fn the_document_is_what_the_code_gives() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/highlights.md");
    let text = std::fs::read_to_string(path).expect("docs/highlights.md");
    for (written, made) in text.lines().zip(document().lines()) {
        assert_eq!(written, made);
    }
    assert_eq!(text, document());
}

/// The positive control: without widening the same highlights do vanish.
#[test]
fn widened_highlights_neither_vanish_nor_flicker() {
    for material in MATERIALS {
        for arithmetic in ARITHMETICS {
            let found = flicker(material, true, arithmetic);
            // A disc's edge is seen in steps.
            let room = if material.contains("phong") {
                0.03
            } else {
                0.21
            };
            let [least, greatest] = found.light;
            assert_eq!(found.dark, 0, "{material}: {found:?}");
            assert!(
                least > 1.0 - room && greatest < 1.0 + room,
                "{material}: {found:?}"
            );
        }
    }
    for arithmetic in ARITHMETICS {
        let found = flicker(
            "model = \"metallic-phong\", exponent = 1e5",
            false,
            arithmetic,
        );
        assert!(found.dark > 32, "{found:?}");
        let found = flicker(
            "model = \"metallic-phong\", exponent = 1e4",
            false,
            arithmetic,
        );
        assert!(found.light[1] > 4.0 && found.dark > 0, "{found:?}");
    }
}

/// The exponents of a scene's materials, in the order in which objects use them.
fn exponents(text: &str) -> Vec<f64> {
    let scene = Description::from_toml("a scene", "a scene", text).expect("a scene");
    let exponent = |material: &Material| match material {
        Material::Phong { exponent, .. } => *exponent,
        other => panic!("{other:?}"),
    };
    scene
        .materials
        .iter()
        .map(|(_, material)| exponent(material))
        .collect()
}

fn scene(n: f64, light: &str, radii: &[f64]) -> String {
    let spheres: String = radii
        .iter()
        .map(|r| format!("[[sphere]]\ncenter = [0, 0, {r}]\nradius = {r}\nmaterial = \"it\"\n"))
        .collect();
    format!(
        "[camera]\nwidth = 512\nheight = 512\neye = [10, 0, 0]\ntarget = [0, 0, 0]\nfov = 15\n\
         {light}{spheres}[material.it]\nmodel = \"metallic-phong\"\nexponent = {n}\n"
    )
}

#[test]
fn each_sphere_gets_the_width_that_it_needs_and_wide_lobes_stay_as_they_are() {
    let light = "[[light]]\nkind = \"directional\"\ndirection = [1, 0, 0]\ncolor = 1\n";
    assert_eq!(exponents(&scene(100.0, light, &[1.0, 0.3])), [100.0]);
    let widened = exponents(&scene(1e6, light, &[1.0, 0.3]));
    let [large, small] = widened[..] else {
        panic!("{widened:?}")
    };
    assert!(small < large && large < 1e6, "{widened:?}");
    // σ is half a pixel's 2ω/r of distance 9, and ω itself.
    let pixel = 2.0 * (7.5f64).to_radians().tan() / 512.0;
    let sigma = 0.5 * pixel * (1.0 + 2.0 * 9.0);
    assert!((large * sigma * sigma - 1.0).abs() < 0.05, "{widened:?}");
    let off = format!("widen = false\n{}", scene(1e6, light, &[1.0, 0.3]));
    assert_eq!(exponents(&off), [1e6]);
}

/// What a light of 2° reflects is the mean over its disc.
#[test]
fn a_lights_size_widens_as_the_mean_over_its_disc() {
    let light = "[[light]]\nkind = \"directional\"\ndirection = [1, 0, 0]\ncolor = 1\nsize = 2\n";
    let widened = exponents(&scene(2e3, light, &[20.0]));
    let model = |n: f64| MetallicPhong::new(n, Energy::Published).expect("in range");
    let (narrow, wide) = (model(2e3), model(widened[0]));
    let zenith = Direction::new(0.0, 0.0, 1.0);
    let at = |x: f64, y: f64| {
        Direction::new(
            x.sin(),
            y.sin(),
            (1.0 - x.sin().powi(2) - y.sin().powi(2)).sqrt(),
        )
    };
    for step in 0..8 {
        let angle = 0.005 * f64::from(step);
        let (mut sum, mut count) = (0.0, 0.0);
        for i in 0..64 * 64 {
            let [x, y] = [i % 64, i / 64].map(|i| f64::from(2 * i + 1) / 64.0 - 1.0);
            if x * x + y * y <= 1.0 {
                let radius = 1f64.to_radians();
                sum += narrow.eval(&at(angle + radius * x, radius * y), &zenith);
                count += 1.0;
            }
        }
        let (mean, found) = (sum / count, wide.eval(&at(angle, 0.0), &zenith));
        assert!(
            (mean - found).abs() < 0.02 * wide.eval(&zenith, &zenith),
            "{angle}: {found} is not {mean}"
        );
    }
}
