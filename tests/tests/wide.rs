//! Eight pixels at a time are the core's pixels, to the last bit.

use std::fmt::Write as _;
use std::path::Path;

use microbrdf::arithmetic::{F32, Float};
use microbrdf::shade::Linear;
use microbrdf_scene::{Description, Native, SceneParts, WideScene};
use microbrdf_tests::baked::LAMPS;

/// Pixels of the core's own row function, in `f32`.
fn cores(scene: &Description) -> Vec<Linear> {
    let parts = SceneParts::new(scene.prepare::<F32>().expect("its materials"));
    let surfaces = parts.surfaces();
    let core = parts.scene(&surfaces);
    let mut pixels = Vec::new();
    for y in 0..usize::from(scene.camera.height) {
        core.shade_row(y, |_, light| pixels.push(light));
    }
    pixels
}

fn wide(scene: &Description) -> Option<WideScene> {
    WideScene::new(&scene.prepare::<Float<Native>>().expect("its materials"))
}

/// The number of colours, once both are found to be the same.
fn same(scene: &Description) -> usize {
    let rows = wide(scene).expect("a scene that it knows");
    let (width, height) = (
        usize::from(scene.camera.width),
        usize::from(scene.camera.height),
    );
    let mut found = vec![Linear::default(); width * height];
    for (y, row) in found.chunks_mut(width).enumerate() {
        rows.shade_row(y, row);
    }
    let mut expected = cores(scene);
    for (i, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found, expected, "column {}, row {}", i % width, i / width);
    }
    expected.sort_by_key(|pixel| pixel.to_raw());
    expected.dedup();
    expected.len()
}

fn parsed(text: &str) -> Description {
    Description::from_toml("scene", "scene", text).expect("a scene")
}

/// Every model there is, narrow and broad.
const MATERIALS: [&str; 22] = [
    "model = \"lambert\"\nalbedo = [0.9, 0.3, 0.0]",
    "model = \"phong\"\nexponent = 0",
    "model = \"phong\"\nexponent = 7.5",
    "model = \"phong\"\nexponent = 20\np = 0.5",
    "model = \"metallic-phong\"\nexponent = 0.3",
    "model = \"metallic-phong\"\nexponent = 20",
    "model = \"metallic-phong\"\nexponent = 3000",
    "model = \"metallic-phong\"\nexponent = 1e8",
    "model = \"retro-phong\"\nexponent = 12",
    "model = \"retro-phong\"\nexponent = 12\np = 0",
    "model = \"retro-phong\"\nexponent = 12\np = 0.25",
    "model = \"patch\"\nradius = 0.5",
    "model = \"patch\"\nradius = 2",
    "model = \"patch-exponential\"\nsharpness = 0",
    "model = \"patch-exponential\"\nsharpness = 6",
    "model = \"metal\"\nmetal = \"gold\"\nexponent = 36",
    "model = \"plastic\"\nalbedo = [0.1, 0.4, 0.6]\nspecular = 0.3\nexponent = 60",
    "model = \"plastic\"\nalbedo = 0.5\nspecular = 0.5\nexponent = 60\nindex = 1.5",
    "model = \"patch-metal\"\nmetal = \"copper\"\nsharpness = 9",
    "model = \"patch-metal\"\nmetal = \"copper\"\nradius = 0.4",
    "model = \"metallic-paint\"\nmetal = \"gold\"\nsharpness = 12",
    "model = \"generalised-lambert\"\nalbedo = 0.8\nsmoothness = 0.7",
];

/// Spheres of each material, one before another, a plane, lights from everywhere;
/// a width that is no multiple of eight.
fn everything(daylight: bool, plane: bool) -> String {
    let mut text = String::from(
        "exposure = 0.4\nbackground = [0.01, 0.02, 0.03]\n\
         [camera]\nwidth = 181\nheight = 67\neye = [0, -12, 1.5]\ntarget = [0, 0, 0]\nfov = 20\n",
    );
    if daylight {
        text.push_str("[daylight]\ncolor = [0.5, 0.4, 0.3]\n");
    }
    if plane {
        text.push_str("[[plane]]\npoint = [0, 0, -1.5]\nnormal = [0, 0, 1]\nmaterial = \"m5\"\n");
    }
    for direction in [
        "[-0.5, -0.7, 0.6]",
        "[0.9, 0.3, 0.2]",
        "[0.1, 1, -0.2]",
        "[0, -1, 0.125]",
    ] {
        let _ = writeln!(
            text,
            "[[light]]\nkind = \"directional\"\ndirection = {direction}\ncolor = [2, 1.5, 1]"
        );
    }
    for (i, material) in MATERIALS.iter().enumerate() {
        // The last columns stand out of the picture; the third row is before the others.
        let (column, row) = (i % 8, i / 8);
        let x = column as f64 * 1.55 - 5.6;
        let z = row as f64 * 1.1 - 1.0;
        let y = if row == 2 { -1.0 } else { 0.0 };
        let _ = writeln!(
            text,
            "[[sphere]]\ncenter = [{x}, {y}, {z}]\nradius = 0.75\nmaterial = \"m{i}\"\n\
             [material.m{i}]\n{material}"
        );
    }
    text
}

#[test]
fn pixels_of_every_model_have_the_cores_bits() {
    let colours = same(&parsed(&everything(false, false)));
    assert!(colours > 2500, "{colours} colours");
}

#[test]
fn so_they_have_before_a_plane() {
    let colours = same(&parsed(&everything(false, true)));
    assert!(colours > 2500, "{colours} colours");
}

#[test]
fn so_they_have_under_daylight() {
    let demo = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/demo.toml");
    let colours = same(&Description::from_file(&demo).expect("the demo"));
    assert!(colours > 5000, "{colours} colours");
}

/// They take the other way.
#[test]
fn what_decides_by_a_place_or_by_several_rays_is_left_to_the_core() {
    assert!(wide(&parsed(LAMPS)).is_none());
    let plain = everything(false, false);
    assert!(wide(&parsed(&plain)).is_some());
    for other in ["shadows = true\n", "samples = 4\n"] {
        assert!(
            wide(&parsed(&(other.to_owned() + &plain))).is_none(),
            "{other}"
        );
    }
}
