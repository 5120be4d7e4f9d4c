//! `microbrdf budget`: what is counted, what is told, and mistakes.

mod support;

use std::collections::BTreeMap;

use microbrdf::arithmetic::{Q15, Q31};
use microbrdf::table::COSINE_KNOTS;
use microbrdf_scene::Description;
use microbrdf_sim::budget::bytes::Contents;
use microbrdf_sim::budget::steps;
use support::{Folder, run};

const HEAD: &str = "widen = false
[camera]
width = 40
height = 30
eye = [0, -6, 1]
target = [0, 0, 0]
fov = 40
[[light]]
kind = \"directional\"
direction = [-1, -2, 2]
color = 1
[material.matt]
model = \"lambert\"
albedo = 0.5
[material.shiny]
model = \"metal\"
metal = \"gold\"
exponent = 20
";
const SPHERE: &str = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"shiny\"\n";
const BESIDE: &str = "[[sphere]]\ncenter = [1.5, 0, 0]\nradius = 0.7\nmaterial = \"matt\"\n";
const FLOOR: &str = "[[plane]]\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\nmaterial = \"matt\"\n";
const LAMP: &str = "[[light]]\nkind = \"point\"\nposition = [1, -3, 2]\nintensity = 3\n";
const SKY: &str = "[daylight]\ncolor = 0.3\n";

fn description(text: &str) -> Description {
    Description::from_toml("here", "here", text).expect("a scene")
}

/// Steps of the whole picture, by name.
fn counted(text: &str) -> BTreeMap<String, u64> {
    let prepared = description(text).prepare::<Q31>().expect("a scene of q31");
    let mut counts = BTreeMap::new();
    for row in steps::of_rows(&prepared, 0..30) {
        for (step, times) in row {
            *counts.entry(step.name()).or_default() += times;
        }
    }
    counts
}

fn of(counts: &BTreeMap<String, u64>, name: &str) -> u64 {
    counts.get(name).copied().unwrap_or(0)
}

/// Sum over the ways that a step goes.
fn all(counts: &BTreeMap<String, u64>, what: &str) -> u64 {
    let ways = counts.iter().filter(|(name, _)| name.starts_with(what));
    ways.map(|(_, times)| times).sum()
}

#[test]
fn every_ray_tests_what_may_be_there() {
    let counts = counted(&format!("{HEAD}{SPHERE}{BESIDE}{FLOOR}"));
    assert_eq!(of(&counts, "pixel"), 1200);
    // A plane may be anywhere.
    assert_eq!(of(&counts, "ray"), 1200);
    assert_eq!(all(&counts, "plane"), 1200);
    let several = of(&counts, "sphere, of several");
    assert_eq!(all(&counts, "sphere"), 2400 + several);
    assert!(of(&counts, "sphere, beside") > 1000, "{counts:?}");
    assert!(of(&counts, "sphere, hit") > 100, "{counts:?}");
    assert!(of(&counts, "sphere, missed") > 0, "{counts:?}");
    assert_eq!(of(&counts, "checker"), 0);
    assert_eq!(of(&counts, "sample"), 0);
    // Without one, rays are cast only where the sphere is looked for.
    let alone = counted(&format!("{HEAD}{SPHERE}"));
    assert_eq!(of(&alone, "ray") + of(&alone, "sphere, beside"), 1200);
    assert!(of(&alone, "ray") < 400, "{alone:?}");
    let four = counted(&format!("samples = 4\n{HEAD}{SPHERE}"));
    assert_eq!(of(&four, "pixel"), 1200);
    assert_eq!(of(&four, "sample"), 4800);
    assert_eq!(of(&four, "ray") + of(&four, "sphere, beside"), 4800);
}

#[test]
fn every_light_is_shaded_once_for_each_coat() {
    let counts = counted(&format!("{SKY_AT_TOP}{HEAD}{LAMP}{SPHERE}{FLOOR}"));
    let coats = of(&counts, "coat");
    assert_eq!(of(&counts, "daylight"), coats);
    assert_eq!(of(&counts, "light, directional"), coats);
    assert_eq!(of(&counts, "light, point"), coats);
    assert_eq!(of(&counts, "light, dimmed"), coats);
    assert_eq!(of(&counts, "light, of several kinds"), 2 * coats);
    assert_eq!(all(&counts, "metal,") + all(&counts, "lambert,"), 2 * coats);
    assert!(of(&counts, "metal, inside") > 0, "{counts:?}");
    assert!(of(&counts, "metal, unlit") > 0, "{counts:?}");
    let shadows = counted(&format!("shadows = true\n{HEAD}{SPHERE}{BESIDE}{FLOOR}"));
    let coats = of(&shadows, "coat");
    assert_eq!(of(&shadows, "shadow"), coats);
    let tests = all(&shadows, "shadow, of a sphere");
    // The first that is in the way ends it.
    assert!(coats < tests && tests < 2 * coats, "{shadows:?}");
    let lit = all(&shadows, "metal,") + all(&shadows, "lambert,");
    assert!(lit < coats, "{shadows:?}");
}

/// A table's header would swallow what follows it.
const SKY_AT_TOP: &str = "daylight = { color = 0.3 }\n";

#[test]
fn tables_are_those_of_what_is_used() {
    let tables = |text: &str| {
        let description = description(text);
        let q31 = Contents::of(&description.prepare::<Q31>().expect("q31"));
        let q15 = Contents::of(&description.prepare::<Q15>().expect("q15"));
        [q31.tables(), q15.tables()]
    };
    let one = tables(&format!("{HEAD}{BESIDE}"));
    let two = tables(&format!("{HEAD}{SPHERE}{BESIDE}"));
    // A lobe of 1024 cells of 4 bytes, of 129 knots of 4; Fresnel's curve.
    for ([one, two], lobe) in [[one[0], two[0]], [one[1], two[1]]]
        .into_iter()
        .zip([4096, 516])
    {
        assert!(
            two - one > lobe + COSINE_KNOTS * 6 && two - one < lobe + 2000,
            "{one} {two}"
        );
    }
    let lit = tables(&format!("{HEAD}{SKY}{BESIDE}"));
    assert!(lit[0] - one[0] > COSINE_KNOTS * 6, "{lit:?} {one:?}");
}

#[test]
fn a_budget_tells_everything() {
    let folder = Folder::new("budget");
    let scene = folder.file("scene.toml", format!("{HEAD}{LAMP}{SPHERE}{FLOOR}"));
    let text = run(&[
        "budget",
        &scene,
        "--board",
        "microbit",
        "--arithmetic",
        "q15",
    ])
    .output();
    for part in [
        "scene on microbit (cortex-m0, 16 MHz), q15",
        "of 262144 bytes",
        "of 16384 bytes",
        "a pixel (estimate)",
        "at 115200 baud",
        "codes at most",
        "\n  shiny ",
        "\n  matt ",
        "\n  directional 1 ",
        "\n  point 2 ",
    ] {
        assert!(text.contains(part), "{part:?} in\n{text}");
    }
    let json = run(&["budget", &scene, "--arithmetic", "q31", "--json"]).output();
    let boards: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let boards = boards.as_array().expect("a list");
    assert!(boards.len() > 1, "{json}");
    for board in boards {
        for field in [
            "flash_bytes",
            "table_bytes",
            "ram_bytes",
            "stack_bytes",
            "cycles_per_pixel",
            "packing_cycles_per_pixel",
            "frames_per_second",
            "frames_per_second_on_line",
            "lsb_error_max",
        ] {
            assert!(
                board[field].as_f64().is_some_and(|value| value > 0.0),
                "{field}"
            );
        }
    }
}

#[test]
fn mistakes_are_told() {
    let folder = Folder::new("budget-mistakes");
    let scene = folder.file("scene.toml", format!("{HEAD}{SPHERE}"));
    let ran = run(&["budget", &scene, "--board", "abacus"]);
    ran.mistake(&["--board abacus", "microbit"]);
    let absent = run(&["budget", "absent.toml", "--board", "microbit"]);
    absent.mistake(&["absent.toml"]);
}

#[test]
fn an_arithmetic_that_was_measured_nowhere_is_told() {
    let folder = Folder::new("budget-nowhere");
    let scene = folder.file("scene.toml", support::SCENE);
    run(&["budget", &scene, "--arithmetic", "micromath"])
        .mistake(&["--arithmetic micromath", "not measured on any board"]);
}
