//! `microbrdf chart`: the test card shows what it says, and is exact.

mod support;

use std::path::Path;

use microbrdf::arithmetic::{F32, Q31};
use microbrdf_scene::HostArithmetic;
use microbrdf_sim::chart::{BANDS, HEIGHT, Plane, WIDTH, error_colour, panel};
use microbrdf_sim::picture::Picture;
use support::{Folder, run};

/// No black pixel in a highlight: the middle column is the mirror direction.
fn the_mirror_direction_is_white<A: HostArithmetic>() {
    for band in BANDS.iter().filter(|band| band.label.contains("Phong")) {
        for plane in Plane::ALL {
            let panel = panel::<A>(band, plane, 1.0).expect("an exponent in range");
            for row in 0..HEIGHT {
                let middle = panel.value.pixels[row * WIDTH + WIDTH / 2];
                assert_eq!(middle, [255; 3], "{}, {plane:?}, row {row}", band.label);
            }
            // And the lobe falls off to both sides of it.
            let top = &panel.value.pixels[..WIDTH];
            assert!(top[WIDTH / 2 + 4][0] < 255 && top[WIDTH / 2 - 4][0] < 255);
        }
    }
}

#[test]
fn the_mirror_direction_is_white_in_single_precision() {
    the_mirror_direction_is_white::<F32>();
}

#[test]
fn the_mirror_direction_is_white_in_fixed_point() {
    the_mirror_direction_is_white::<Q31>();
}

/// The card's errors are within what the table of tolerances states.
fn errors_are_small<A: HostArithmetic>() {
    for band in BANDS {
        for plane in Plane::ALL {
            let panel = panel::<A>(&band, plane, 1.0).expect("a material in range");
            let worst = panel.worst;
            assert!(worst.lsb <= 0.53, "{}, {plane:?}: {worst:?}", band.label);
            assert!(worst.lsb > 0.4, "{}, {plane:?}: {worst:?}", band.label);
            assert!(panel.shown > 200, "{}: {}", band.label, panel.shown);
        }
    }
}

#[test]
fn errors_are_small_in_single_precision() {
    errors_are_small::<F32>();
}

#[test]
fn errors_are_small_in_fixed_point() {
    errors_are_small::<Q31>();
}

/// A table of few cells shows in colour what the card is there to show.
#[test]
fn errors_show() {
    let band = &BANDS[3];
    let panel = panel::<Q31<16>>(band, Plane::Sideways, 1.0).expect("an exponent in range");
    assert!(panel.worst.lsb > 2.0, "{:?}", panel.worst);
    assert!(panel.error.pixels.contains(&error_colour(panel.worst.lsb)));
    let colours = [0.25, 0.55, 0.7, 0.9, 1.5, 3.0].map(error_colour);
    for (index, colour) in colours.iter().enumerate() {
        assert!(!colours[..index].contains(colour));
    }
}

#[test]
fn the_command_writes_a_picture_for_each_arithmetic() {
    let folder = Folder::new("chart-writes");
    let output = run(&["chart", "--arithmetic", "q31", "--out", &folder.path("new")]).output();
    assert_eq!(output.lines().count(), BANDS.len(), "{output}");
    let first = output.lines().next().expect("a line");
    assert!(
        first.starts_with("q31, metallic Phong, n = 1: at most 0."),
        "{first}"
    );
    let path = folder.path("new/chart-q31.png");
    let picture = Picture::read_png(Path::new(&path)).expect("a PNG");
    assert!(picture.width > 4 * WIDTH && picture.height > BANDS.len() * HEIGHT);
    // Panels and labels: the sheet is neither blank nor all panel.
    let white = picture.pixels.iter().filter(|p| **p == [255; 3]).count();
    let share = white as f64 / picture.pixels.len() as f64;
    assert!((0.3..0.7).contains(&share), "{share}");
}

#[test]
fn mistakes_are_told() {
    let folder = Folder::new("chart-mistakes");
    let out = folder.path("out");
    run(&["chart"]).mistake(&["--out"]);
    run(&["chart", "--out", &out, "--arithmetic", "q7"]).mistake(&["--arithmetic", "q7"]);
    for exposure in ["0", "NaN", "30000000", "bright"] {
        run(&["chart", "--out", &out, "--exposure", exposure]).mistake(&["--exposure", exposure]);
    }
    let file = folder.file("taken", "");
    run(&["chart", "--out", &file]).mistake(&["--out", "taken"]);
    assert_eq!(folder.names(), ["taken"]);
}

#[test]
fn help_has_an_example() {
    let help = run(&["chart", "--help"]).output();
    assert!(help.contains("microbrdf chart --arithmetic"), "{help}");
}
