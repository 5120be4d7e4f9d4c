//! The closed list of models: what the tests and the documentation go through.

use super::entry::ModelEntry;

/// Every model, in the order of its file's name.
pub const ALL: &[ModelEntry] = &[
    super::anisotropic_phong::ENTRY,
    super::anisotropic_sum::ENTRY,
    super::beard_maxwell::ENTRY,
    super::bisector_phong::ENTRY,
    super::blinn::ENTRY,
    super::blinn_cos::ENTRY,
    super::blinn_original::ENTRY,
    super::cook_torrance::ENTRY,
    super::generalised_lambert::ENTRY,
    super::ggx::ENTRY,
    super::lacquer::ENTRY,
    super::lafortune::ENTRY,
    super::lambert::ENTRY,
    super::lommel_seeliger::ENTRY,
    super::measured_half_angle::ENTRY,
    super::measured_irregular::ENTRY,
    super::metal::ENTRY,
    super::metal_half::ENTRY,
    super::metallic_paint::ENTRY,
    super::metallic_phong::ENTRY,
    super::minnaert::ENTRY,
    super::mirror::ENTRY,
    super::mixed::ENTRY,
    super::oren_nayar::ENTRY,
    super::oren_nayar_full::ENTRY,
    super::p_model::ENTRY,
    super::patch::ENTRY,
    super::patch_elliptic::ENTRY,
    super::patch_exponential::ENTRY,
    super::patch_metal::ENTRY,
    super::patch_mixture::ENTRY,
    super::patch_p_norm::ENTRY,
    super::patch_plastic::ENTRY,
    super::patch_power::ENTRY,
    super::patch_profile::ENTRY,
    super::patch_retro::ENTRY,
    super::phong::ENTRY,
    super::phong_original::ENTRY,
    super::plastic::ENTRY,
    super::plastic_fresnel::ENTRY,
    super::polished::ENTRY,
    super::pumped::ENTRY,
    super::retro_phong::ENTRY,
    super::sandwich::ENTRY,
    super::schlick::ENTRY,
    super::tobler_exponential::ENTRY,
    super::tobler_power::ENTRY,
    super::torrance_sparrow::ENTRY,
    super::ward::ENTRY,
    super::ward_anisotropic::ENTRY,
    super::ward_convenient::ENTRY,
    super::ward_corrected::ENTRY,
];

/// What the texts name without defining it: listed, not invented.
pub const NAMED_ONLY: &[(&str, &str)] = &[
    (
        "He–Torrance in full",
        "its 86 formulas are in X. He and others, *A comprehensive physical model for light \
         reflection* (1991), not in the texts; only its shadowing term (1.38) is here, in `cook_torrance`",
    ),
    (
        "Stam's diffraction model (1.51)",
        "needs the spectral density of a surface, which the text leaves open, and an occlusion factor that it says is missing",
    ),
];

/// The entry of a model's file name.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    ALL.iter().find(|m| m.name == name)
}
