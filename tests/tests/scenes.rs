//! What a scene may have beside spheres, planes and directional lights,
//! against the reference in every arithmetic.

use microbrdf_scene::{Description, LightKind};
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_tests::baked::LAMPS;
use microbrdf_tests::pictures::{Case, faults};

const ARITHMETICS: [ArithmeticName; 3] = [
    ArithmeticName::F32,
    ArithmeticName::Q31,
    ArithmeticName::Q15,
];

fn holds(case: &Case) {
    assert!(case.exempt() <= 20, "{} pixels are exempt", case.exempt());
    for arithmetic in ARITHMETICS {
        let found = case.measured(arithmetic);
        println!("{}: {found:?}", arithmetic.name());
        assert!(faults(&found).is_empty(), "{:?}: {found:?}", faults(&found));
    }
}

/// The reference's picture, 8 bits.
fn exact(text: &str) -> Vec<[u8; 3]> {
    Case::of(text).exact.srgb().pixels
}

fn without(text: &str, part: &str, other: &str) -> String {
    assert_eq!(text.matches(part).count(), 1, "{part}");
    text.replace(part, other)
}

#[test]
fn a_checker_under_lamps_is_the_references() {
    holds(&Case::of(LAMPS));
}

/// Squares that are seen from the side, from below and at a slant.
#[test]
fn checkers_on_walls_are_the_references() {
    let walls = without(
        LAMPS,
        "normal = [0.1, -1.0, 0.0]\nmaterial = \"clay\"",
        "normal = [0.0, -1.0, 0.0]\nmaterial = \"clay\"\nchecker = { material = \"gold\", size = 2.5 }",
    ) + r#"
[[plane]]
point = [3.5, 0.0, 0.0]
normal = [1.0, 0.0, 0.0]
material = "clay"
checker = { material = "floor", size = 1 }
"#;
    holds(&Case::of(&walls));
}

/// The camera looks along an edge: the tie is decided alike by all.
#[test]
fn an_edge_belongs_to_the_greater_coordinate() {
    let text = without(
        LAMPS,
        "point = [0.1, 0.05, -1.0]",
        "point = [0.0, 0.05, -1.0]",
    );
    // The middle column of an odd number looks exactly ahead.
    let text = without(&text, "width = 96", "width = 97");
    let case = Case::of(&text);
    for arithmetic in ARITHMETICS {
        let found = case.measured(arithmetic);
        assert!(
            faults(&found).is_empty(),
            "{}: {found:?}",
            arithmetic.name()
        );
        assert_eq!(found.class_flips, 0, "{}", arithmetic.name());
    }
    // Below the spheres the column has the colour of its right neighbours.
    let right = &case.exact.pixels[60 * 97 + 48..60 * 97 + 50];
    let left = &case.exact.pixels[60 * 97 + 47];
    let step = |a: [f64; 3], b: [f64; 3]| (a[2] - b[2]).abs();
    assert!(step(right[0].code(), right[1].code()) < step(left.code(), right[0].code()) / 10.0);
}

/// Every light and the checker are seen in the picture.
#[test]
fn each_light_and_the_checker_matter() {
    let whole = exact(LAMPS);
    for (part, other) in [
        ("intensity = [6.0, 5.0, 4.0]", "intensity = 0"),
        ("intensity = [9.0, 12.0, 20.0]", "intensity = 0"),
        ("exponent = 12", "exponent = 3"),
        ("position = [0.5, -2.5, 2.5]", "position = [0.5, -2.5, 3.5]"),
        ("size = 0.8", "size = 0.9"),
    ] {
        let changed = exact(&without(LAMPS, part, other));
        let pixels = whole.iter().zip(&changed).filter(|(a, b)| a != b).count();
        assert!(pixels > 200, "{part}: {pixels} pixels");
    }
}

/// A lamp's reference distance is the least to anything in the scene.
#[test]
fn a_lamp_knows_what_is_nearest() {
    let scene = Description::from_toml("scene", "scene", LAMPS).unwrap();
    let LightKind::Point { near, .. } = scene.lights[1].kind else {
        panic!("a point");
    };
    // The nearer of the second sphere and the floor.
    let sphere = f64::sqrt(0.7f64.powi(2) + 2.9f64.powi(2) + 2.5f64.powi(2)) - 1.0;
    assert!((near - sphere.min(3.5)).abs() < 1e-12, "{near}");
}

/// Mistakes that only checkers and lamps can have.
#[test]
fn mistakes_are_named() {
    for (part, wrong, message) in [
        (
            "kind = \"point\"",
            "kind = \"spot\"",
            "must be \"directional\", \"point\" or \"flood\"",
        ),
        (
            "exponent = 12",
            "exponent = 0.5",
            "must be a number from 1 to 10000",
        ),
        (
            "position = [0.5, -2.5, 2.5]",
            "position = [0.5, -2.5, -1.001]",
            "from a surface",
        ),
        (
            "position = [0.5, -2.5, 2.5]",
            "position = [0.5, -2.5, 150]",
            "from the camera",
        ),
        (
            "size = 0.8",
            "size = 0.04",
            "must be a number from 0.05 to 1000",
        ),
        (
            "material = \"clay\", size",
            "material = \"brick\", size",
            "plane[1].checker.material",
        ),
        (
            "intensity = [6.0, 5.0, 4.0]",
            "color = 1",
            "`intensity` is missing",
        ),
    ] {
        let text = without(LAMPS, part, wrong);
        let error = Description::from_toml("scene", "scene", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{wrong}: {error}");
    }
}
