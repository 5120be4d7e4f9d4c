//! Scenes whose baked Rust is kept in `tests/baked`, so that a test compiles
//! and runs it.

use microbrdf_scene::{Description, bake};
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::with_arithmetic;

/// The materials that two scenes of a floor, a wall and spheres share.
macro_rules! room_materials {
    () => {
        r#"[material.floor]
model = "plastic"
albedo = 0.4
specular = 0.3
exponent = 50
[material.clay]
model = "lambert"
albedo = [0.5, 0.3, 0.2]
[material.gold]
model = "metal"
metal = "gold"
exponent = 36
[material.between]
model = "phong"
exponent = 9
p = 0.5
"#
    };
}

/// A checker under a light of each kind.
pub const LAMPS: &str = concat!(
    r#"
exposure = 0.8
background = [0.02, 0.03, 0.05]
[camera]
width = 96
height = 64
eye = [0.0, -7.0, 2.0]
target = [0.0, 0.0, 0.3]
fov = 35.0
[daylight]
color = [0.1, 0.12, 0.15]
[[light]]
kind = "directional"
direction = [-0.5, -0.7, 0.9]
color = [0.8, 0.7, 0.7]
[[light]]
kind = "point"
position = [0.5, -2.5, 2.5]
intensity = [6.0, 5.0, 4.0]
[[light]]
kind = "flood"
position = [-3.0, -1.0, 4.0]
axis = [0.4, 0.2, -1.0]
exponent = 12
intensity = [9.0, 12.0, 20.0]
[[plane]]
point = [0.1, 0.05, -1.0]
normal = [0.0, 0.0, 1.0]
material = "floor"
checker = { material = "clay", size = 0.8 }
[[plane]]
point = [0.0, 12.0, 0.0]
normal = [0.1, -1.0, 0.0]
material = "clay"
[[sphere]]
center = [-1.4, 0.0, 0.0]
radius = 1.0
material = "gold"
[[sphere]]
center = [1.2, 0.4, 0.0]
radius = 1.0
material = "between"
[[sphere]]
center = [2.1, -1.6, -0.6]
radius = 0.4
material = "satin"
[material.satin]
model = "profile"
points = [[0, 3], [0.1, 2.8], [0.3, 1.5], [0.45, 0.6], [0.9, 0.1]]
"#,
    room_materials!()
);

/// A teapot of two materials under a lamp, partly behind a sphere and below a
/// plane: normals of four bytes, and depths.
pub const MESH: &str = r#"
background = [0.02, 0.03, 0.05]
[camera]
width = 64
height = 48
eye = [0.3, -7.0, 1.5]
target = [0.0, 0.0, -0.2]
fov = 25.0
[daylight]
color = 0.1
[[light]]
kind = "directional"
direction = [-0.5, -0.7, 0.9]
color = [0.8, 0.7, 0.7]
[[light]]
kind = "point"
position = [1.5, -2.5, 2.5]
intensity = 14
[[mesh]]
file = "../scenes/meshes/teapot.obj"
position = [0.1, 0, -1.05]
scale = 1.1
rotate = [0, 0, 30]
material = "clay"
materials = { knob = "gold", spout = "gold" }
[[plane]]
point = [0, 0, -1]
normal = [0, 0, 1]
material = "floor"
[[sphere]]
center = [0.45, -1.7, -0.3]
radius = 0.4
material = "floor"
[material.floor]
model = "lambert"
albedo = 0.4
[material.clay]
model = "plastic"
albedo = [0.5, 0.3, 0.2]
specular = 0.2
exponent = 15
[material.gold]
model = "metal"
metal = "gold"
exponent = 40
"#;

/// A matt knot under a light at infinity: normals of three bytes.
pub const MATT: &str = r#"
[camera]
width = 64
height = 48
eye = [0.5, -5.0, 3.0]
target = [0, 0, 0]
fov = 34
[[light]]
kind = "directional"
direction = [-0.5, -0.7, 0.9]
color = [2.8, 2.7, 2.7]
[[mesh]]
file = "../scenes/meshes/knot.obj"
position = [0, 0, 0]
material = "clay"
[material.clay]
model = "lambert"
albedo = [0.6, 0.3, 0.2]
"#;

/// A sphere of each material that [`LAMPS`] and the demo lack.
pub const MATERIALS: &str = r#"
widen = false
background = [0.02, 0.03, 0.05]
[camera]
width = 96
height = 48
eye = [0.0, -9.0, 1.0]
target = [0.0, 0.0, 0.0]
fov = 22.0
[daylight]
color = [0.2, 0.22, 0.25]
[[light]]
kind = "directional"
direction = [-0.5, -0.7, 0.6]
color = [0.6, 0.55, 0.5]
[[light]]
kind = "directional"
direction = [0.9, 0.5, 0.3]
color = [0.3, 0.35, 0.5]
[[sphere]]
center = [-2.4, 0.0, 0.0]
radius = 0.7
material = "glazed"
[[sphere]]
center = [-0.8, 0.0, 0.0]
radius = 0.7
material = "exponential"
[[sphere]]
center = [0.8, 0.0, 0.0]
radius = 0.7
material = "paint"
[[sphere]]
center = [2.4, 0.0, 0.0]
radius = 0.7
material = "matt"
[[sphere]]
center = [0.0, -1.5, -0.9]
radius = 0.3
material = "disc"
[material.glazed]
model = "plastic"
albedo = [0.1, 0.2, 0.5]
specular = [0.4, 0.45, 0.5]
exponent = 60
index = 1.5
[material.exponential]
model = "patch-metal"
metal = "silver"
sharpness = 8
[material.disc]
model = "patch-metal"
metal = "gold"
radius = 0.6
[material.paint]
model = "metallic-paint"
eta = [0.2, 0.9, 1.4]
k = [3.6, 2.6, 2.0]
sharpness = 12
[material.matt]
model = "generalised-lambert"
albedo = [0.7, 0.4, 0.3]
smoothness = 0.8
"#;

/// Shadows of a light of each kind, on a checker, a wall and spheres, with four
/// rays a pixel.
pub const SHADOWS: &str = concat!(
    r#"exposure = 0.8
shadows = true
samples = 4
background = [0.02, 0.03, 0.05]
[camera]
width = 72
height = 48
eye = [0.0, -7.0, 2.0]
target = [0.0, 0.0, 0.1]
fov = 35.0
[daylight]
color = [0.1, 0.12, 0.15]
[[light]]
kind = "directional"
direction = [-0.6, -0.5, 0.7]
color = [2.0, 1.9, 1.7]
[[light]]
kind = "point"
position = [2.5, -2.5, 2.0]
intensity = [6.0, 5.0, 4.0]
[[light]]
kind = "flood"
position = [-3.0, -1.0, 4.0]
axis = [0.6, 0.2, -1.0]
exponent = 6
intensity = [9.0, 12.0, 20.0]
[[plane]]
point = [0.1, 0.05, -1.0]
normal = [0.0, 0.0, 1.0]
material = "floor"
checker = { material = "clay", size = 0.8 }
[[plane]]
point = [0.0, 3.0, 0.0]
normal = [0.1, -1.0, 0.0]
material = "clay"
[[sphere]]
center = [-1.3, 0.0, 0.0]
radius = 1.0
material = "gold"
[[sphere]]
center = [1.2, 0.6, -0.1]
radius = 0.9
material = "between"
[[sphere]]
center = [0.3, -1.3, -0.4]
radius = 0.4
material = "clay"
"#,
    room_materials!()
);

/// Scenes by name.
pub const SCENES: [(&str, &str); 5] = [
    ("lamps", LAMPS),
    ("mesh", MESH),
    ("matt", MATT),
    ("materials", MATERIALS),
    ("shadows", SHADOWS),
];

/// Arithmetics that they are baked in.
pub const ARITHMETICS: [ArithmeticName; 3] = [
    ArithmeticName::F32,
    ArithmeticName::Q31,
    ArithmeticName::Q15,
];

/// The description of a scene.
///
/// # Panics
/// On a mistake in it.
#[must_use]
pub fn description(name: &str, text: &str) -> Description {
    // Files are named as from the folder of this crate.
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/scene.toml");
    Description::from_toml(source, name, text).expect("a scene")
}

/// A scene's Rust.
///
/// # Panics
/// On a material that the arithmetic does not take.
#[must_use]
pub fn source(name: &str, text: &str, arithmetic: ArithmeticName) -> String {
    let description = description(name, text);
    with_arithmetic!(arithmetic, A => bake::<A>(&description)).expect("a scene for it")
}
