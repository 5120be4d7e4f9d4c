//! Pixel error: whole pictures against the f64 scene with f64 geometry.

use std::path::Path;
use std::sync::OnceLock;

use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::measure::{JUMP, Measured};
use microbrdf_sim::picture::Picture;
use microbrdf_tests::pictures::{Case, faults};

/// What the demo scene lacks: planes, spheres before spheres, an edge of a
/// patch, plastic, a lobe towards the light, a light from behind.
const MIXED: &str = r#"
exposure = 0.8
background = [0.02, 0.03, 0.05]
[camera]
width = 96
height = 64
eye = [0.0, -7.0, 2.0]
target = [0.0, 0.0, 0.3]
fov = 35.0
[daylight]
color = [0.2, 0.25, 0.3]
[[light]]
kind = "directional"
direction = [-0.5, -0.7, 0.9]
color = [2.0, 1.9, 1.7]
[[light]]
kind = "directional"
direction = [0.3, 0.9, 0.4]
color = 1.2
[[light]]
kind = "directional"
direction = [0.0, -0.9, -0.1]
color = [0.1, 0.2, 0.6]
[[plane]]
point = [0.0, 0.0, -1.0]
normal = [0.0, 0.0, 1.0]
material = "floor"
[[sphere]]
center = [-1.9, 0.0, 0.0]
radius = 1.0
material = "patch"
[[sphere]]
center = [0.1, -1.0, -0.3]
radius = 0.7
material = "plastic"
[[sphere]]
center = [0.6, 0.9, 0.4]
radius = 1.1
material = "retro"
[[sphere]]
center = [2.2, -0.2, -0.1]
radius = 0.9
material = "between"
[material.floor]
model = "plastic"
albedo = 0.4
specular = 0.3
exponent = 500
[material.patch]
model = "patch"
radius = 0.6
[material.plastic]
model = "plastic"
albedo = [0.5, 0.1, 0.1]
specular = 0.5
exponent = 80
[material.retro]
model = "retro-phong"
exponent = 6
[material.between]
model = "phong"
exponent = 9
p = 0.5
"#;

fn demo() -> &'static Case {
    static CASE: OnceLock<Case> = OnceLock::new();
    CASE.get_or_init(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/demo.toml");
        Case::new(Description::from_file(&path).expect("the demo scene"))
    })
}

fn mixed() -> &'static Case {
    static CASE: OnceLock<Case> = OnceLock::new();
    CASE.get_or_init(|| Case::of(MIXED))
}

fn holds(case: &Case, arithmetic: ArithmeticName) {
    let found = case.measured(arithmetic);
    println!("{}: {found:?}", arithmetic.name());
    assert!(faults(&found).is_empty(), "{:?}: {found:?}", faults(&found));
}

#[test]
fn the_demo_in_f32_is_the_references() {
    holds(demo(), ArithmeticName::F32);
}

#[test]
fn the_demo_in_q31_is_the_references() {
    holds(demo(), ArithmeticName::Q31);
}

#[test]
fn every_kind_of_object_is_the_references() {
    for arithmetic in ArithmeticName::ALL {
        holds(mixed(), arithmetic);
    }
}

/// A flip counts only beside a jump, and few pixels are that near to one.
#[test]
fn few_pixels_are_exempt() {
    for case in [demo(), mixed()] {
        let near = case.exempt();
        assert!(near <= 20, "{near} pixels lie within {JUMP:e} of a jump");
    }
}

/// The measure sees what is wrong with a picture.
#[test]
fn wrong_pictures_are_told_apart() {
    let case = demo();
    let good = case.picture(ArithmeticName::Q31);
    let changed = |change: &dyn Fn(usize, [u8; 3]) -> [u8; 3]| {
        let pixels = good.pixels.iter().enumerate();
        let picture = Picture {
            width: good.width,
            height: good.height,
            pixels: pixels.map(|(i, pixel)| change(i, *pixel)).collect(),
        };
        faults(&Measured::new(&picture, &case.exact))
    };
    assert!(changed(&|_, pixel| pixel).is_empty());
    // Moved by a pixel; red and blue swapped; one code brighter; one pixel
    // black; one channel of one pixel two codes off.
    assert!(!changed(&|i, _| good.pixels[i.saturating_sub(1)]).is_empty());
    assert!(!changed(&|_, [r, g, b]| [b, g, r]).is_empty());
    assert!(!changed(&|_, pixel| pixel.map(|code| code.saturating_add(1))).is_empty());
    let middle = 64 * good.width + 60;
    assert!(good.pixels[middle][1] > 20);
    assert!(!changed(&|i, pixel| if i == middle { [0; 3] } else { pixel }).is_empty());
    assert!(
        !changed(&|i, [r, g, b]| if i == middle {
            [r, g + 2, b]
        } else {
            [r, g, b]
        })
        .is_empty()
    );
}
