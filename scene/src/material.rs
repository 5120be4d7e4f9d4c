//! Material tables.

use std::ops::RangeInclusive;

use microbrdf_reference::{self as reference, MetalName};

use crate::error::{Fault, SceneError};
use crate::profile::Profile;
use crate::reader::{Colour, Table, list};

/// A material as its table gives it, every value within its range.
#[derive(Clone, Debug, PartialEq)]
pub enum Material {
    /// Lambert's law.
    Lambert {
        /// Diffuse albedo.
        albedo: Colour,
    },
    /// A cosⁿα lobe: `phong`, `metallic-phong`, `retro-phong`.
    Phong {
        /// n.
        exponent: f64,
        /// Exponent of cosΘmin (3.12).
        p: f64,
        /// Whether the lobe points back to the light (3.13).
        retro: bool,
        /// How the peak is chosen.
        energy: reference::Energy,
    },
    /// The basic patch (4.2).
    Patch {
        /// R.
        radius: f64,
    },
    /// The exponential mixture (4.46).
    PatchExponential {
        /// s.
        sharpness: f64,
    },
    /// A mixture of patches with any profile (4.29, 4.39).
    PatchProfile {
        /// ξ(m).
        profile: Box<Profile>,
    },
    /// A metal (3.29).
    Metal {
        /// n.
        exponent: f64,
        /// Where its colour comes from.
        reflectance: Reflectance,
    },
    /// A patch with Fresnel's factor at Θmin.
    PatchMetal {
        /// Its shape.
        shape: PatchShape,
        /// Where its colour comes from.
        reflectance: Reflectance,
    },
    /// Metallic paint (4.54).
    MetallicPaint {
        /// s.
        sharpness: f64,
        /// Where its colour comes from.
        reflectance: Reflectance,
    },
    /// Generalised Lambert (4.59).
    GeneralisedLambert {
        /// Greatest albedo.
        albedo: Colour,
        /// d.
        smoothness: f64,
        /// The m from which ξ is constant.
        clip: f64,
    },
    /// A plastic or a ceramic (3.30, 3.31).
    Plastic {
        /// Diffuse albedo.
        albedo: Colour,
        /// Specular share.
        specular: Colour,
        /// n.
        exponent: f64,
        /// Real index of refraction, for Fresnel's factor (3.30); without one
        /// it is 1 (3.31).
        index: Option<f64>,
    },
}

/// The shape of a metal of patches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchShape {
    /// The basic patch (4.2).
    Basic {
        /// R.
        radius: f64,
    },
    /// The exponential mixture (4.46).
    Exponential {
        /// s.
        sharpness: f64,
    },
}

/// What a metal's Fresnel factor is computed from.
#[derive(Clone, Debug, PartialEq)]
pub enum Reflectance {
    /// A metal with a measured spectrum.
    Named(MetalName),
    /// A complex index of refraction for red, green and blue.
    Index {
        /// Real part.
        eta: [f64; 3],
        /// Extinction coefficient.
        k: [f64; 3],
    },
}

const MODELS: [&str; 12] = [
    "lambert",
    "phong",
    "metallic-phong",
    "retro-phong",
    "patch",
    "patch-exponential",
    "profile",
    "metal",
    "plastic",
    "patch-metal",
    "metallic-paint",
    "generalised-lambert",
];

impl Material {
    /// Reads a material given on a command line: a table written inline, with
    /// or without braces, or else the path of a file that holds one.
    ///
    /// # Errors
    /// The first mistake, with its place; a file that can't be read.
    pub fn from_argument(argument: &str) -> Result<Self, SceneError> {
        if !argument.contains('=') {
            return Self::from_toml(argument, &crate::files::read(argument.as_ref())?);
        }
        let braced = argument.trim_start().starts_with('{');
        // Fields that commas part read as an inline table, lines as a document.
        let inline = if braced || toml::de::DeTable::parse(argument).is_err() {
            let body = argument
                .trim()
                .trim_start_matches('{')
                .trim_end_matches('}');
            format!("material = {{{body}}}")
        } else {
            return Self::from_toml("material", argument);
        };
        let parse = || -> Result<Self, Fault> {
            let document = parse(&inline)?;
            let outer = Table::new("", &document);
            Self::read(&outer.required("material")?.table()?)
        };
        // Places in the wrapped text mean nothing to whoever typed it.
        parse().map_err(|fault| SceneError {
            source_name: "--material".to_owned(),
            place: None,
            message: fault.message,
        })
    }

    /// Reads a material from the text of a file.
    ///
    /// # Errors
    /// The first mistake, with its place.
    pub fn from_toml(source_name: &str, text: &str) -> Result<Self, SceneError> {
        let read = || Self::read(&Table::new("", &parse(text)?));
        read().map_err(|fault| fault.within(source_name, text))
    }

    pub(crate) fn read(table: &Table<'_, '_>) -> Result<Self, Fault> {
        let model = table.required("model")?;
        let exponent = || table.required("exponent")?.number(0.0..=1e8);
        let material = match model.string()? {
            "lambert" => Self::Lambert {
                albedo: table.required("albedo")?.colour(0.0..=1.0)?,
            },
            name @ ("phong" | "metallic-phong" | "retro-phong") => Self::Phong {
                exponent: exponent()?,
                p: match table.optional("p") {
                    Some(p) => p.number(0.0..=1.0)?,
                    None if name == "phong" => 0.0,
                    None => 1.0,
                },
                retro: name == "retro-phong",
                energy: match table.optional("energy") {
                    None => reference::Energy::Published,
                    Some(energy) => match energy.string()? {
                        "published" => reference::Energy::Published,
                        "strict" => reference::Energy::Strict,
                        _ => return Err(energy.fault("\"published\" or \"strict\"")),
                    },
                },
            },
            "patch" => Self::Patch {
                radius: table.required("radius")?.number(RADII)?,
            },
            "patch-exponential" => Self::PatchExponential {
                sharpness: table.required("sharpness")?.number(SHARPNESSES)?,
            },
            "patch-metal" => Self::PatchMetal {
                shape: patch_shape(table)?,
                reflectance: reflectance(table)?,
            },
            "metallic-paint" => Self::MetallicPaint {
                sharpness: table.required("sharpness")?.number(SHARPNESSES)?,
                reflectance: reflectance(table)?,
            },
            "generalised-lambert" => Self::GeneralisedLambert {
                albedo: table.required("albedo")?.colour(0.0..=1.0)?,
                smoothness: table.required("smoothness")?.number(0.0..=1.0)?,
                clip: match table.optional("clip") {
                    Some(clip) => clip.number(1.0..=1.9)?,
                    None => 1.9,
                },
            },
            "profile" => Self::PatchProfile {
                profile: Box::new(profile(table)?),
            },
            "metal" => Self::Metal {
                exponent: exponent()?,
                reflectance: reflectance(table)?,
            },
            "plastic" => Self::Plastic {
                albedo: table.required("albedo")?.colour(0.0..=1.0)?,
                specular: table.required("specular")?.colour(0.0..=1.0)?,
                exponent: exponent()?,
                index: match table.optional("index") {
                    Some(index) => Some(index.number(1.0..=4.0)?),
                    None => None,
                },
            },
            _ => return Err(model.fault(format!("one of {}", list(&MODELS)))),
        };
        table.finish()?;
        if let Self::Plastic {
            albedo, specular, ..
        } = &material
        {
            let greatest = |colour: &Colour| colour.rgb().into_iter().fold(0.0, f64::max);
            let total = greatest(albedo) + greatest(specular);
            // Room for the rounding of decimals, none for energy.
            if total > 1.0 + 1e-12 {
                return Err(table.fault(format!(
                    "specular plus the greatest albedo is {total}: must be at most 1, or the \
                     plastic would reflect more than it receives"
                )));
            }
        }
        Ok(material)
    }

    /// Whether its channels can differ: three values are printed for it.
    #[must_use]
    pub fn is_coloured(&self) -> bool {
        match self {
            Self::Lambert { albedo } | Self::GeneralisedLambert { albedo, .. } => albedo.is_rgb(),
            Self::Plastic {
                albedo, specular, ..
            } => albedo.is_rgb() || specular.is_rgb(),
            Self::Metal { .. } | Self::PatchMetal { .. } | Self::MetallicPaint { .. } => true,
            _ => false,
        }
    }
}

/// Radii of patches.
const RADII: RangeInclusive<f64> = 1e-4..=2.0;
/// Sharpnesses of exponential mixtures.
const SHARPNESSES: RangeInclusive<f64> = 0.0..=4096.0;

fn patch_shape(table: &Table<'_, '_>) -> Result<PatchShape, Fault> {
    match (table.optional("radius"), table.optional("sharpness")) {
        (Some(radius), None) => Ok(PatchShape::Basic {
            radius: radius.number(RADII)?,
        }),
        (None, Some(sharpness)) => Ok(PatchShape::Exponential {
            sharpness: sharpness.number(SHARPNESSES)?,
        }),
        _ => Err(table.fault(
            "a metal of patches needs either `sharpness`, for the exponential mixture, or \
             `radius`, for the basic patch",
        )),
    }
}

/// Greatest number of points of a profile.
const GREATEST_POINTS: usize = 129;

fn profile(table: &Table<'_, '_>) -> Result<Profile, Fault> {
    let value = table.required("points")?;
    let points = value.pairs()?;
    let (Some([first, greatest]), 2..=GREATEST_POINTS) = (points.first(), points.len()) else {
        return Err(value.fault(format!("2 to {GREATEST_POINTS} points, each [m, ξ]")));
    };
    let in_order = |pair: &[[f64; 2]]| pair[0][0] < pair[1][0] && pair[0][1] >= pair[1][1];
    if *first != 0.0 || *greatest < 1e-6 || !points.windows(2).all(in_order) {
        return Err(value.fault(
            "points [m, ξ] from m = 0 with growing m and a ξ that does not grow, 1e-6 or more at \
             m = 0: a mixture of patches falls from its middle",
        ));
    }
    Ok(Profile::through(&points))
}

fn reflectance(table: &Table<'_, '_>) -> Result<Reflectance, Fault> {
    let (metal, eta, k) = (
        table.optional("metal"),
        table.optional("eta"),
        table.optional("k"),
    );
    match (metal, eta, k) {
        (Some(metal), None, None) => match metal.string()?.parse() {
            Ok(metal) => Ok(Reflectance::Named(metal)),
            Err(_) => {
                let names: Vec<_> = MetalName::ALL.iter().map(|metal| metal.name()).collect();
                Err(metal.fault(format!("one of {}", list(&names))))
            }
        },
        (None, Some(eta), Some(k)) => Ok(Reflectance::Index {
            eta: eta.triple(0.01..=100.0)?,
            k: k.triple(0.0..=100.0)?,
        }),
        _ => Err(table.fault("a metal needs either `metal`, its name, or `eta` and `k`")),
    }
}

/// Parses a document.
pub(crate) fn parse(text: &str) -> Result<toml::Spanned<toml::de::DeTable<'_>>, Fault> {
    toml::de::DeTable::parse(text).map_err(|error| match error.span() {
        Some(span) => Fault::new(span.start, error.message().to_owned()),
        None => Fault::new(
            deepest_key(text),
            format!("{}: a key has too many parts", error.message()),
        ),
    })
}

/// Where the key of the most parts stands: the parser does not say.
fn deepest_key(text: &str) -> usize {
    let mut start = 0;
    let mut deepest = (0, 0);
    for line in text.split_inclusive('\n') {
        let dots = line.matches('.').count();
        if dots > deepest.0 {
            deepest = (dots, start);
        }
        start += line.len();
    }
    deepest.1
}
