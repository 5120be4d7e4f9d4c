//! What a part of a material is called where it is counted.

use microbrdf_scene::{Material, PatchShape};

/// The type that the part becomes in firmware, in words: parts of one kind
/// share their code.
pub(crate) fn kind(part: &Material) -> &'static str {
    match part {
        Material::Lambert { .. } => "lambert",
        Material::Phong {
            p, retro: false, ..
        } if *p == 0.0 => "phong",
        Material::Phong {
            p, retro: false, ..
        } if *p == 1.0 => "metallic-phong",
        Material::Phong { retro: false, .. } => "p-model",
        Material::Phong { p, .. } if *p == 0.0 => "retro-phong, p = 0",
        Material::Phong { p, .. } if *p == 1.0 => "retro-phong",
        Material::Phong { .. } => "retro-phong, p-model",
        Material::Patch { .. } => "patch",
        Material::PatchExponential { .. } => "patch-exponential",
        Material::PatchProfile { .. } => "profile",
        Material::Metal { .. } => "metal",
        Material::PatchMetal {
            shape: PatchShape::Basic { .. },
            ..
        } => "patch-metal of one radius",
        Material::PatchMetal { .. } => "patch-metal",
        Material::MetallicPaint { .. } => "metallic-paint",
        Material::GeneralisedLambert { .. } => "generalised-lambert",
        Material::Plastic { .. } => "plastic",
    }
}
