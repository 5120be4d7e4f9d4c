//! What a material is called in a legend.

use microbrdf_reference::Energy;
use microbrdf_scene::{Material, PatchShape, Reflectance};

/// Model and parameters, short.
pub fn label(material: &Material) -> String {
    match material {
        Material::Lambert { .. } => "Lambert".to_owned(),
        Material::Phong {
            exponent,
            p,
            retro,
            energy,
        } => {
            let name = match (retro, *p) {
                (true, _) => "retro Phong",
                (false, 0.0) => "Phong",
                (false, _) => "metallic Phong",
            };
            let usual = *p == 1.0 || (*p == 0.0 && !retro);
            let p = if usual {
                String::new()
            } else {
                format!(", p = {p}")
            };
            let strict = if *energy == Energy::Strict {
                ", strict"
            } else {
                ""
            };
            format!("{name}, n = {exponent}{p}{strict}")
        }
        Material::Patch { radius } => format!("patch, R = {radius}"),
        Material::PatchExponential { sharpness } => format!("exponential patch, s = {sharpness}"),
        Material::PatchProfile { .. } => "patch mixture".to_owned(),
        Material::Metal {
            exponent,
            reflectance,
        } => {
            format!("{}, n = {exponent}", name(reflectance))
        }
        Material::PatchMetal { shape, reflectance } => match shape {
            PatchShape::Basic { radius } => format!("{} patch, R = {radius}", name(reflectance)),
            PatchShape::Exponential { sharpness } => {
                format!("{} patch, s = {sharpness}", name(reflectance))
            }
        },
        Material::MetallicPaint {
            sharpness,
            reflectance,
        } => format!("{} paint, s = {sharpness}", name(reflectance)),
        Material::GeneralisedLambert { smoothness, .. } => {
            format!("generalised Lambert, d = {smoothness}")
        }
        Material::Plastic {
            exponent, index, ..
        } => {
            let index = index.map_or_else(String::new, |index| format!(", index {index}"));
            format!("plastic, n = {exponent}{index}")
        }
    }
}

/// What a metal is called.
fn name(reflectance: &Reflectance) -> &'static str {
    match reflectance {
        Reflectance::Named(metal) => metal.name(),
        Reflectance::Index { .. } => "metal",
    }
}
