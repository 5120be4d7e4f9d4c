//! `docs/energy.md`: the energy of what is shipped.

use std::fmt::Write as _;

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf::brdf::Brdf as _;
use microbrdf_reference as reference;
use microbrdf_scene::Material;
use microbrdf_sim::energy::Shipped;

use crate::arithmetic::Tested;

/// Angles of incidence in degrees.
pub const ANGLES: [f64; 8] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 89.0, 89.9];

/// What is smaller is not told apart from 0: f64's own rounding, and that of
/// another machine's logarithm, begin to show.
const NOTHING: f64 = 1e-7;

/// Each family at exponents, radii and sharpnesses from end to end.
pub const MATERIALS: [&str; 28] = [
    "model = \"lambert\", albedo = 0.8",
    "model = \"phong\", exponent = 1",
    "model = \"phong\", exponent = 20",
    "model = \"phong\", exponent = 20, p = 0.5",
    "model = \"metallic-phong\", exponent = 0",
    "model = \"metallic-phong\", exponent = 1",
    "model = \"metallic-phong\", exponent = 2",
    "model = \"metallic-phong\", exponent = 20",
    "model = \"metallic-phong\", exponent = 500",
    "model = \"metallic-phong\", exponent = 5000",
    "model = \"metallic-phong\", exponent = 1e5",
    "model = \"metallic-phong\", exponent = 1e8",
    "model = \"retro-phong\", exponent = 20",
    "model = \"patch\", radius = 0.01",
    "model = \"patch\", radius = 0.3",
    "model = \"patch\", radius = 1.5",
    "model = \"patch-exponential\", sharpness = 0.5",
    "model = \"patch-exponential\", sharpness = 4",
    "model = \"patch-exponential\", sharpness = 16",
    "model = \"patch-exponential\", sharpness = 128",
    "model = \"patch-exponential\", sharpness = 4096",
    "model = \"profile\", points = [[0, 1], [0.25, 0.375], [1, 0]]",
    "model = \"profile\", points = [[0, 1], [0.01, 0.9], [0.1, 0.1], [2, 0.02]]",
    "model = \"metal\", metal = \"gold\", exponent = 20",
    "model = \"metal\", metal = \"aluminium\", exponent = 500",
    "model = \"metal\", eta = [3.18, 3.2, 2.3], k = [3.3, 3.3, 3.1], exponent = 40",
    "model = \"metal\", eta = [1.5, 1.5, 1.5], k = [0, 0, 0], exponent = 40",
    "model = \"plastic\", albedo = [0.6, 0.2, 0.1], specular = 0.3, exponent = 20",
];

/// The signed error of the directional albedo of a material as an arithmetic
/// evaluates it, its own peak included: that of the channel which is farthest
/// off, at each of [`ANGLES`].
///
/// # Panics
/// If the arithmetic does not take the material.
pub fn errors<A: Tested>(toml: &str) -> [f64; ANGLES.len()] {
    let material = Material::from_argument(toml)
        .expect("a material")
        .rounded::<A>();
    let exact = material.reference();
    let model = material.model::<A>().expect("a material in range");
    let shipped = Shipped::<A>::new(&material).expect("a material in range");
    let peak = A::scale_value(model.peak()) / exact.peak() - 1.0;
    ANGLES.map(|degrees| {
        let cosine = degrees.to_radians().cos();
        let albedo = reference::directional_albedo_rgb(&*exact, cosine);
        let difference = shipped.difference(cosine);
        (0..3)
            .map(|channel| difference[channel] + peak * albedo[channel].value)
            .fold(0.0, |a: f64, b: f64| if b.abs() > a.abs() { b } else { a })
    })
}

/// `docs/energy.md`.
pub fn document() -> String {
    let mut text = String::from(
        "# Energy of what is shipped\n\n\
         Made by `cargo run -p microbrdf-tests --bin accuracy`; `tests/tests/documents.rs` \
         computes every figure anew and fails when one is out of date.\n\n\
         The directional albedo is the integral of what the core returns, as it returns it: \
         quadrature over 36,864 directions about the lobe and over the hemisphere, of the \
         difference between the core's reflected radiance and the reference's. The tables give \
         that difference, signed: positive means that more is reflected than the model says. Of \
         a coloured material it is the channel that is farthest off. The parameters are those \
         that the arithmetic holds. `tests/tests/energy.rs` bounds the same errors two-sided for \
         every entry of the registry, checks the published overshoot of c_n below n = 2, and \
         that a lobe of strict energy has none. Dots stand for less than 1e-7. \
         Where the steps of `q15`'s directions are as wide as a lobe (n = 1e8, s = 4096), the \
         grid's own directions scatter, and what stands there is that scatter.\n",
    );
    section::<F32>(&mut text);
    section::<Micromath>(&mut text);
    section::<Q31>(&mut text);
    section::<Q15>(&mut text);
    text
}

fn section<A: Tested>(text: &mut String) {
    let _ = write!(text, "\n## `{}`\n\n| material |", A::NAME);
    for angle in ANGLES {
        let _ = write!(text, " {angle}° |");
    }
    let _ = writeln!(text, "\n| --- |{}", " ---: |".repeat(ANGLES.len()));
    for toml in MATERIALS {
        let _ = write!(text, "| `{toml}` |");
        for error in errors::<A>(toml) {
            if error.abs() < NOTHING {
                text.push_str(" · |");
            } else {
                let _ = write!(text, " {error:+.1e} |");
            }
        }
        text.push('\n');
    }
}
