//! The figures and pictures in documents are those that the code gives.

use std::fs;
use std::path::{Path, PathBuf};

use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::commands::compare;
use microbrdf_sim::measure::Measured;
use microbrdf_sim::picture::Picture;
use microbrdf_sim::{reference_picture, render};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn demo() -> Description {
    Description::from_file(&root().join("scenes/demo.toml")).expect("the demo scene")
}

#[test]
fn the_accuracy_table_is_the_table_of_tolerances() {
    let text = fs::read_to_string(root().join("docs/accuracy.md")).expect("docs/accuracy.md");
    assert_eq!(text, microbrdf_tests::document::accuracy());
}

/// Every figure of it, computed anew.
#[test]
fn the_energy_table_is_what_is_shipped() {
    let text = fs::read_to_string(root().join("docs/energy.md")).expect("docs/energy.md");
    let made = microbrdf_tests::energy::document();
    for (written, made) in text.lines().zip(made.lines()) {
        assert_eq!(written, made);
    }
    assert_eq!(text.lines().count(), made.lines().count());
}

#[test]
fn the_readme_gives_the_demo_scenes_errors() {
    let readme = fs::read_to_string(root().join("README.md")).expect("README.md");
    let exact = reference_picture::render(&demo());
    for arithmetic in ArithmeticName::ALL {
        let picture = render::frame(&demo(), arithmetic)
            .expect("a picture")
            .srgb();
        let line = compare::line(arithmetic, &Measured::new(&picture, &exact));
        assert!(readme.contains(&line), "README.md lacks the line\n{line}");
    }
}

#[test]
fn the_readme_shows_the_demo_scene() {
    let shown = Picture::read_png(&root().join("docs/demo.png")).expect("docs/demo.png");
    let rendered = render::frame(&demo(), ArithmeticName::Q31)
        .expect("a picture")
        .srgb();
    assert_eq!(
        shown.pixels, rendered.pixels,
        "render it anew: microbrdf render … -o docs/demo.png"
    );
}
