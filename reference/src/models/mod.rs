//! The models, one a file: parameters, evaluation, bounds, tests.

pub mod lambert;
pub mod metal;
pub mod metallic_phong;
pub mod p_model;
pub mod patch;
pub mod patch_exponential;
pub mod phong;
pub mod plastic;
pub mod retro_phong;

pub use lambert::Lambert;
pub use metal::Metal;
pub use metallic_phong::MetallicPhong;
pub use p_model::PModel;
pub use patch::Patch;
pub use patch_exponential::PatchExponential;
pub use phong::Phong;
pub use plastic::Plastic;
pub use retro_phong::RetroPhong;

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
