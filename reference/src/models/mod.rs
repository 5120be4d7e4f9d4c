//! The models, one a file: parameters, evaluation, bounds, tests.

pub mod anisotropic_phong;
pub mod anisotropic_sum;
pub mod beard_maxwell;
pub mod bisector_phong;
pub mod blinn;
pub mod blinn_cos;
pub mod blinn_original;
pub mod cook_torrance;
pub mod entry;
pub mod generalised_lambert;
pub mod ggx;
pub mod lacquer;
pub mod lafortune;
pub mod lambert;
pub mod lommel_seeliger;
pub mod measured_half_angle;
pub mod measured_irregular;
pub mod metal;
pub mod metal_half;
pub mod metallic_paint;
pub mod metallic_phong;
pub mod metric;
pub mod microfacet;
pub mod minnaert;
pub mod mirror;
pub mod mixed;
pub mod oren_nayar;
pub mod oren_nayar_full;
pub mod p_model;
pub mod patch;
pub mod patch_elliptic;
pub mod patch_exponential;
pub mod patch_metal;
pub mod patch_mixture;
pub mod patch_p_norm;
pub mod patch_plastic;
pub mod patch_power;
pub mod patch_profile;
pub mod patch_retro;
pub mod phong;
pub mod phong_original;
pub mod plastic;
pub mod plastic_fresnel;
pub mod polished;
pub mod pumped;
pub mod registry;
pub mod retro_phong;
pub mod sandwich;
pub mod schlick;
pub mod tint;
pub mod tobler_exponential;
pub mod tobler_power;
pub mod torrance_sparrow;
pub mod ward;
pub mod ward_anisotropic;
pub mod ward_convenient;
pub mod ward_corrected;

pub use anisotropic_phong::AnisotropicPhong;
pub use anisotropic_sum::AnisotropicSum;
pub use beard_maxwell::BeardMaxwell;
pub use bisector_phong::{Bisector, BisectorPhong};
pub use blinn::Blinn;
pub use blinn_cos::BlinnCos;
pub use blinn_original::BlinnOriginal;
pub use cook_torrance::CookTorrance;
pub use entry::{Claim, ModelEntry};
pub use generalised_lambert::GeneralisedLambert;
pub use ggx::Ggx;
pub use lacquer::Lacquer;
pub use lafortune::{Lafortune, LafortuneLobe};
pub use lambert::Lambert;
pub use lommel_seeliger::{LommelSeeliger, Scattering};
pub use measured_half_angle::MeasuredHalfAngle;
pub use measured_irregular::MeasuredIrregular;
pub use metal::Metal;
pub use metal_half::MetalHalf;
pub use metallic_paint::MetallicPaint;
pub use metallic_phong::MetallicPhong;
pub use metric::Metric;
pub use minnaert::Minnaert;
pub use mirror::Mirror;
pub use mixed::Mixed;
pub use oren_nayar::OrenNayar;
pub use oren_nayar_full::OrenNayarFull;
pub use p_model::PModel;
pub use patch::Patch;
pub use patch_elliptic::PatchElliptic;
pub use patch_exponential::PatchExponential;
pub use patch_metal::PatchMetal;
pub use patch_mixture::PatchMixture;
pub use patch_p_norm::PatchPNorm;
pub use patch_plastic::PatchPlastic;
pub use patch_power::PatchPower;
pub use patch_profile::PatchProfile;
pub use patch_retro::PatchRetro;
pub use phong::Phong;
pub use phong_original::PhongOriginal;
pub use plastic::Plastic;
pub use plastic_fresnel::PlasticFresnel;
pub use polished::Polished;
pub use pumped::{PumpRule, Pumped};
pub use registry::ALL;
pub use retro_phong::RetroPhong;
pub use sandwich::Sandwich;
pub use schlick::Schlick;
pub use tint::Tint;
pub use tobler_exponential::ToblerExponential;
pub use tobler_power::ToblerPower;
pub use torrance_sparrow::TorranceSparrow;
pub use ward::Ward;
pub use ward_anisotropic::WardAnisotropic;
pub use ward_convenient::WardConvenient;
pub use ward_corrected::WardCorrected;

/// How a Phong-type model is normalised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Energy {
    /// c_n = (n + 2)/2π (3.6) as published: the albedo exceeds 1 by up to 8.6e-2 for n < 2.
    #[default]
    Published,
    /// c_n divided by the greatest albedo, found numerically, where that is above 1.
    Strict,
}

impl std::str::FromStr for Energy {
    type Err = crate::ParameterError;
    fn from_str(s: &str) -> Result<Self, Self::Err> {
        match s {
            "published" => Ok(Self::Published),
            "strict" => Ok(Self::Strict),
            _ => Err(crate::ParameterError::new(
                "energy",
                s,
                "published or strict",
            )),
        }
    }
}

/// Greatest Phong exponent: beyond it f64 directions can't resolve the lobe.
pub const EXPONENT_MAX: f64 = 1e8;
