//! `docs/highlights.md`: highlights narrower than a pixel while the light
//! moves, widened and not.

use std::fmt::Write as _;

use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::render::frame;

/// Frames, and the degrees by which the light moves from one to the next.
pub const FRAMES: usize = 64;
const STEP: f64 = 0.25;
/// Columns and rows; the sphere is 50 pixels wide.
const SIZE: u16 = 64;
/// Pixels of the comparison's picture on each side of one.
const FINE: u16 = 16;

/// Exponents, sharpnesses and radii.
pub const MATERIALS: [&str; 6] = [
    "model = \"metallic-phong\", exponent = 200",
    "model = \"metallic-phong\", exponent = 1e3",
    "model = \"metallic-phong\", exponent = 1e4",
    "model = \"metallic-phong\", exponent = 1e5",
    "model = \"patch\", radius = 0.01",
    "model = \"patch-exponential\", sharpness = 500",
];

/// Arithmetics.
pub const ARITHMETICS: [ArithmeticName; 3] = [
    ArithmeticName::F32,
    ArithmeticName::Q31,
    ArithmeticName::Q15,
];

/// What becomes of a highlight over all frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flicker {
    /// Frames in which no pixel is lit.
    pub dark: usize,
    /// The least and the greatest light of a frame, all pixels together, as a
    /// share of what each should reflect.
    pub light: [f64; 2],
}

/// The sphere under the light of a frame.
fn scene(material: &str, index: usize, widen: bool, scale: u16) -> Description {
    // An oblique course, which passes pixels in both directions.
    let along = (STEP * index as f64).to_radians();
    let (y, x) = (0.3 + 0.8 * along).sin_cos();
    let elevation = 0.35 + 0.6 * along;
    let size = SIZE * scale;
    let text = format!(
        "widen = {widen}\n\
         [camera]\nwidth = {size}\nheight = {size}\neye = [10, 0, 0]\ntarget = [0, 0, 0]\n\
         fov = 14.66\n\
         [[light]]\nkind = \"directional\"\ndirection = [{}, {}, {}]\ncolor = 1\n\
         [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"it\"\n\
         [material]\nit = {{{material}}}\n",
        x * elevation.cos(),
        y * elevation.cos(),
        elevation.sin()
    );
    let mut scene = Description::from_toml("flicker", "flicker", &text).expect("a scene");
    scene.exposure = exposure(material);
    scene
}

/// That at which the narrow highlight's peak is at full scale: nothing is clipped.
fn exposure(material: &str) -> f64 {
    let material = microbrdf_scene::Material::from_argument(material).expect("a material");
    1.0 / material.reference().peak()
}

/// The light of all pixels.
fn light(scene: &Description, arithmetic: ArithmeticName) -> f64 {
    let frame = frame(scene, arithmetic).expect("a scene that it takes");
    frame
        .pixels
        .iter()
        .map(|pixel| f64::from(pixel.to_raw()[1]))
        .sum()
}

/// The highlight in every frame.
#[must_use]
pub fn flicker(material: &str, widen: bool, arithmetic: ArithmeticName) -> Flicker {
    // What it should reflect changes slowly: the first and the last frame, and
    // a line between them.
    let exact = [0, FRAMES - 1].map(|index| {
        let fine = scene(material, index, false, FINE);
        light(&fine, ArithmeticName::F32) / f64::from(FINE * FINE)
    });
    let mut flicker = Flicker {
        dark: 0,
        light: [f64::INFINITY, 0.0],
    };
    for index in 0..FRAMES {
        let sum = light(&scene(material, index, widen, 1), arithmetic);
        let part = index as f64 / (FRAMES - 1) as f64;
        let share = sum / (exact[0] + part * (exact[1] - exact[0]));
        flicker.dark += usize::from(share < 1e-3);
        flicker.light = [flicker.light[0].min(share), flicker.light[1].max(share)];
    }
    flicker
}

/// `docs/highlights.md`.
#[must_use]
pub fn document() -> String {
    let mut text = format!(
        "# Highlights narrower than a pixel\n\n\
         Made by `cargo run -p microbrdf-tests --bin accuracy`; `tests/tests/flicker.rs` fails \
         when it is out of date.\n\n\
         On a sphere of 50 pixels the lobe of n = 1e5 falls between the pixels, and as the light \
         moves, it flashes. So a scene gives each object a material whose highlights are as wide \
         as the pixels need: the distance to the object, its curvature, where on it the light is \
         mirrored and the light's size make an effective n, R or s, and the peak belongs to that \
         one, so that the energy is kept. It happens when the scene is read: no pixel costs more. \
         `widen = false` in a scene turns it off.\n\n\
         Below, a light moves by {STEP}° a frame, {FRAMES} frames long, over that sphere. Light \
         is that of all pixels of a frame, as a share of what the narrow lobe reflects towards \
         the same picture with {FINE} x {FINE} samples a pixel. A frame is dark if that share is \
         below a thousandth. A disc has an edge, which pixels see as steps; a lobe has none.\n\n\
         | material | widened | arithmetic | dark frames | least light | greatest light |\n\
         | --- | --- | --- | --- | --- | --- |\n"
    );
    for material in MATERIALS {
        for widen in [false, true] {
            for arithmetic in ARITHMETICS {
                let found = flicker(material, widen, arithmetic);
                let [least, greatest] = found.light;
                let _ = writeln!(
                    text,
                    "| `{material}` | {} | `{}` | {} | {least:.2} | {greatest:.2} |",
                    if widen { "on" } else { "off" },
                    arithmetic.name(),
                    found.dark
                );
            }
        }
    }
    text
}
