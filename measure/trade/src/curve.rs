//! The curves that kernels hold as constants.

use std::fmt::Write as _;

use microbrdf_scene::{Material, Reflectance, generalised_profile};

/// What has a curve, by the name of its file in `measure/kernels/src`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Of {
    /// Gold.
    Gold,
    /// A glaze of index 1.5.
    Glaze,
    /// Generalised Lambert of smoothness 1, whose full disc is evenly bright.
    Moon,
}

impl Of {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Gold, Self::Glaze, Self::Moon];

    /// Name of its file, without the ending.
    #[must_use]
    pub fn file(self) -> &'static str {
        match self {
            Self::Gold => "gold",
            Self::Glaze => "glaze",
            Self::Moon => "moon",
        }
    }

    /// The file, with what a scene's build would bake.
    #[must_use]
    pub fn source(self) -> String {
        match self {
            Self::Gold => {
                let text = "model = \"metal\", metal = \"gold\", exponent = 20";
                match Material::from_argument(text) {
                    Ok(Material::Metal { reflectance, .. }) => {
                        self.fresnel("Gold's Fresnel curve", "GOLD", &reflectance)
                    }
                    other => unreachable!("{other:?} is no metal"),
                }
            }
            Self::Glaze => self.fresnel(
                "The Fresnel curve of a glaze of index 1.5",
                "GLAZE",
                &Reflectance::dielectric(1.5),
            ),
            Self::Moon => self.moon(),
        }
    }

    fn head(self, title: &str) -> String {
        format!(
            "//! {title}.\n//!\n\
             //! Made by `cargo run -p microbrdf-trade -- curve {}`; a test of that crate fails\n\
             //! when it is out of date.\n\n",
            self.file()
        )
    }

    fn fresnel(self, title: &str, name: &str, reflectance: &Reflectance) -> String {
        let mut text = self.head(title)
            + &format!(
                "use microbrdf::table::CosineCurve;\n\n\
                 /// Red, green and blue over the cosine, 15 fraction bits.\n\
                 #[rustfmt::skip]\n\
                 pub const {name}: CosineCurve = CosineCurve::from_entries([\n"
            );
        for [r, g, b] in reflectance.curve().entries() {
            let _ = writeln!(text, "    [{r}, {g}, {b}],");
        }
        text.push_str("]);\n");
        text
    }

    fn moon(self) -> String {
        let text = "model = \"generalised-lambert\", albedo = 1, smoothness = 1";
        let material = Material::from_argument(text).expect("a generalised Lambert");
        let Material::GeneralisedLambert {
            smoothness, clip, ..
        } = material
        else {
            unreachable!("{material:?} is no generalised Lambert")
        };
        self.head("Generalised Lambert of smoothness 1")
            + &format!(
                "use microbrdf::constant;\nuse microbrdf::table::SquareCurve;\n\n\
                 /// Its peak in sr⁻¹.\n\
                 pub const PEAK: f64 = {:?};\n\n\
                 /// ξ/ξmax over m².\n\
                 #[rustfmt::skip]\n\
                 pub const PROFILE: SquareCurve = constant!(SquareCurve::new({}));\n",
                material.reference().peak(),
                generalised_profile(smoothness, clip).code()
            )
    }
}
