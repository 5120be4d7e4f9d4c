//! What a scene may have beside spheres, planes and directional lights,
//! against the reference in every arithmetic.

use microbrdf_reference::lightness;
use microbrdf_scene::{Description, LightKind};
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_tests::baked::{LAMPS, MATERIALS};
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

/// A glaze, metals of patches, a paint and generalised Lambert, under daylight.
#[test]
fn every_other_material_is_the_references() {
    holds(&Case::of(MATERIALS));
}

/// Each of them is seen, and what is out of range is named.
#[test]
fn fields_of_the_other_materials_matter() {
    let whole = exact(MATERIALS);
    for (part, other) in [
        ("index = 1.5", "index = 2.4"),
        ("sharpness = 8", "sharpness = 4"),
        ("radius = 0.6", "radius = 0.5"),
        ("metal = \"gold\"", "metal = \"copper\""),
        ("sharpness = 12", "sharpness = 20"),
        ("smoothness = 0.8", "smoothness = 0.3"),
        ("smoothness = 0.8", "smoothness = 0.8\nclip = 1.5"),
    ] {
        let changed = exact(&without(MATERIALS, part, other));
        let pixels = whole.iter().zip(&changed).filter(|(a, b)| a != b).count();
        assert!(pixels > 30, "{other}: {pixels} pixels");
    }
    for (part, wrong, message) in [
        (
            "index = 1.5",
            "index = 0.9",
            "material.glazed.index = 0.9: must be a number from 1 to 4",
        ),
        ("radius = 0.6", "size = 0.6", "either `sharpness`"),
        (
            "radius = 0.6",
            "radius = 0.6\nsharpness = 9",
            "either `sharpness`",
        ),
        (
            "radius = 0.6",
            "radius = 2.5",
            "must be a number from 0.0001 to 2",
        ),
        (
            "sharpness = 12",
            "sharpness = -1",
            "must be a number from 0 to 4096",
        ),
        ("eta = [0.2, 0.9, 1.4]\n", "", "a metal needs either"),
        (
            "smoothness = 0.8",
            "smoothness = 1.1",
            "must be a number from 0 to 1",
        ),
        ("smoothness = 0.8", "", "`smoothness` is missing"),
        (
            "smoothness = 0.8",
            "smoothness = 0.8\nclip = 2",
            "must be a number from 1 to 1.9",
        ),
        (
            "\"generalised-lambert\"",
            "\"generalized-lambert\"",
            "`generalised-lambert`",
        ),
    ] {
        let text = without(MATERIALS, part, wrong);
        let error = Description::from_toml("scene", "scene", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{wrong}: {error}");
    }
}

/// Daylight is the albedo of the whole, Fresnel's factor within the integral
/// (3.32): the product of the factor and the lobe's albedo is another.
#[test]
fn daylight_answers_with_the_albedo_of_the_whole() {
    let albedo = |text: &str, cosine: f64| {
        let material = microbrdf_scene::Material::from_argument(text).unwrap();
        microbrdf_scene::AlbedoTable::of(&material).at(cosine)[0]
    };
    let glazed = "model = \"plastic\", albedo = 0.2, specular = 0.5, exponent = 20";
    for degrees in [0.0f64, 60.0, 85.0, 89.0] {
        let cosine = degrees.to_radians().cos();
        let lobe = albedo("model = \"metallic-phong\", exponent = 20", cosine);
        let whole = albedo(&format!("{glazed}, index = 1.5"), cosine);
        let fresnel = microbrdf_reference::fresnel::dielectric(1.5, cosine);
        let product = 0.2 + 0.5 * fresnel * lobe;
        println!("{degrees}: {whole} and {product}");
        if degrees < 1.0 {
            assert!((whole - product).abs() < 2e-3);
        } else if degrees > 84.0 {
            assert!(
                (whole - product).abs() > 0.01,
                "{degrees}: {whole} {product}"
            );
        }
        assert!(whole > 0.2 && whole < albedo(glazed, cosine));
    }
    // The moon's disc under the sky: brightest at its rim, where it is the albedo.
    let moon = "model = \"generalised-lambert\", albedo = 0.6, smoothness = 1";
    assert!(
        (albedo(moon, 0.0) - 0.6).abs() < 1e-4,
        "{}",
        albedo(moon, 0.0)
    );
    assert!((albedo(moon, 1.0) - 0.6 * 0.75895).abs() < 1e-3);
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

/// A sphere seen from so far that its disc is round, and small enough to be
/// all at one distance of the lamp: with radius 1 the lit side gets 3 % more.
const GREY: &str = r#"
exposure = "auto"
[camera]
width = 320
height = 320
eye = [10.0, -35.0, 15.0]
target = [0.3, 0.2, -0.1]
fov = 1.2
[daylight]
color = [0.03, 0.02, 0.05]
[[light]]
kind = "directional"
direction = [0.5, -0.7, 0.9]
color = [0.08, 0.07, 0.01]
[[light]]
kind = "flood"
position = [-30.3, -45.0, 40.0]
axis = [0.7, 1.0, -0.9]
exponent = 8
intensity = [900, 500, 700]
[[sphere]]
center = [0.3, 0.2, -0.1]
radius = 0.4
material = "grey"
[material.grey]
model = "lambert"
albedo = 0.5
"#;

/// The median lightness of the sphere's pixels.
fn median_lightness(text: &str) -> f64 {
    let case = Case::of(text);
    let frame = microbrdf_sim::render::frame(&case.description, ArithmeticName::Q31).unwrap();
    let mut found: Vec<f64> = frame
        .pixels
        .iter()
        .map(|pixel| f64::from(pixel.luminance()) / f64::from(1 << 24))
        .filter(|luminance| *luminance > 0.0)
        .collect();
    found.sort_by(f64::total_cmp);
    lightness(found[found.len() / 2])
}

#[test]
fn a_grey_sphere_is_exposed_to_a_lightness_of_50() {
    let found = median_lightness(GREY);
    assert!((found - 50.0).abs() < 0.1, "L* = {found}");
    // A stated number is kept; half the light makes another picture of it.
    let stated = without(GREY, "\"auto\"", "1.0");
    assert!((median_lightness(&stated) - 50.0).abs() > 5.0);
    assert_eq!(Case::of(&stated).description.exposure, 1.0);
    let dim = without(GREY, "[900, 500, 700]", "[450, 250, 350]");
    assert!((median_lightness(&dim) - 50.0).abs() < 0.1);
}

#[test]
fn an_exposure_is_a_number_or_auto() {
    for (exposure, message) in [
        (
            "\"automatic\"",
            "must be a number from 0.000001 to 1000000, or \"auto\"",
        ),
        (
            "0",
            "must be a number from 0.000001 to 1000000, or \"auto\"",
        ),
    ] {
        let text = without(GREY, "\"auto\"", exposure);
        let error = Description::from_toml("scene", "scene", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{error}");
    }
    let dark = "exposure = \"auto\"\n[camera]\nwidth = 8\nheight = 8\neye = [0, -9, 0]\n\
                target = [0, 0, 0]\nfov = 20\n";
    let error = Description::from_toml("scene", "scene", dark).unwrap_err();
    assert!(error.to_string().contains("too little light"), "{error}");
}

#[test]
fn a_profile_is_refused_unless_it_falls_from_its_middle() {
    let points = "[[0, 3], [0.1, 2.8], [0.3, 1.5], [0.45, 0.6], [0.9, 0.1]]";
    for (wrong, message) in [
        ("[[0, 3]]", "2 to 129 points"),
        ("[[0, 3], [0.1, 3.1]]", "a mixture of patches falls"),
        ("[[0.1, 3], [0.2, 1]]", "from m = 0"),
        ("[[0, 3], [0.2, 1], [0.2, 0.5]]", "growing m"),
        ("[[0, 0], [1, 0]]", "1e-6 or more"),
        (
            "[[0, 1], [2.1, 0]]",
            "points[2][1] = 2.1: must be a number from 0 to 2",
        ),
        ("[[0, 1], [1]]", "must be two numbers"),
    ] {
        let text = without(LAMPS, points, wrong);
        let error = Description::from_toml("scene", "scene", &text).unwrap_err();
        assert!(error.to_string().contains(message), "{wrong}: {error}");
    }
}

/// Under daylight a profile answers with its own albedo, at most 1.
#[test]
fn a_profile_has_the_albedo_of_the_references() {
    let points = "[[0, 3], [0.1, 2.8], [0.3, 1.5], [0.45, 0.6], [0.9, 0.1]]";
    let text = format!("model = \"profile\"\npoints = {points}");
    let material = microbrdf_scene::Material::from_toml("material", &text).unwrap();
    let table = microbrdf_scene::AlbedoTable::of(&material);
    assert!((table.at(1.0)[0] - 1.0).abs() < 1e-5, "{:?}", table.at(1.0));
    assert!(table.at(0.1)[0] < 0.95 && table.at(0.1)[0] > 0.3);
}
