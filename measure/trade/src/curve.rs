//! The Fresnel curve that kernels hold as a constant.

use std::fmt::Write as _;

use microbrdf_scene::{Material, Reflectance};

/// `measure/kernels/src/gold.rs`: gold's reflectance, as a scene's build would
/// bake it.
///
/// # Panics
/// Never: the material is a known one.
#[must_use]
pub fn gold() -> String {
    let material = Material::from_argument("model = \"metal\", metal = \"gold\", exponent = 20");
    let curve = match material {
        Ok(Material::Metal { reflectance, .. }) => Reflectance::curve(&reflectance),
        other => unreachable!("{other:?} is no metal"),
    };
    let mut text = String::from(
        "//! Gold's Fresnel curve.\n//!\n\
         //! Made by `cargo run -p microbrdf-trade -- curve`; a test of that crate fails\n\
         //! when it is out of date.\n\n\
         use microbrdf::table::CosineCurve;\n\n\
         /// Red, green and blue over the cosine, 15 fraction bits.\n\
         #[rustfmt::skip]\n\
         pub const GOLD: CosineCurve = CosineCurve::from_entries([\n",
    );
    for [r, g, b] in curve.entries() {
        let _ = writeln!(text, "    [{r}, {g}, {b}],");
    }
    text.push_str("]);\n");
    text
}
