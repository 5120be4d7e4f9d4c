//! The f64 reference of every model, written from the papers.
//!
//! Equation numbers mean A. Neumann, *Constructions of Bidirectional Reflection
//! Distribution Functions*, TU Wien 2001 ("the thesis"), in the form that holds
//! numerically where the print does not.
//!
//! | module | contents |
//! | --- | --- |
//! | [`direction`] | directions in the shading frame (N is +z) |
//! | [`brdf`] | the trait [`Brdf`]: `eval`, `reflect`, `rho`, `peak` |
//! | [`geometry`] | versine, patch metric, cosΘmin, bounded ratio |
//! | [`half`] | the half vector |
//! | [`models`] | the models, one a file |
//! | [`fresnel`] | exact Fresnel equations |
//! | [`mod@albedo`] | directional and mean albedo by quadrature |
//! | [`quantities`] | composition, scalar product and distance of models |
//! | [`mod@light`] | lights, reflected radiance, daylight |
//! | [`published`] | every number that the texts print, computed again |
//! | [`documentation`], [`measured`], [`cost`] | the table of all models, and what it holds |
//! | [`sampling`] | importance sampling |
//! | [`quadrature`] | adaptive integrals with an error estimate |
//! | [`colour`] | spectra and metals to linear sRGB, encoding, CIEDE2000, gamut map |
//!
//! Conventions: f is in sr⁻¹ without the cosine; L points to the light, V to the
//! viewer, R is L mirrored at N; `reflect` is f·cosΘL for unit normal irradiance.
//! Constructors check their parameters and return a [`ParameterError`]; evaluation
//! never fails.

pub mod albedo;
pub mod brdf;
pub mod colour;
pub mod cost;
pub mod direction;
pub mod documentation;
pub mod error;
pub mod figures;
pub mod fresnel;
pub mod geometry;
pub mod half;
pub mod light;
pub mod measured;
pub mod models;
pub mod published;
pub mod quadrature;
pub mod quantities;
pub mod sampling;
pub mod special;

pub use albedo::{
    directional_albedo, directional_albedo_at, directional_albedo_rgb, mean_albedo, mean_albedo_rgb,
};
pub use brdf::Brdf;
pub use colour::{MetalName, ciede2000, decode_srgb, encode_srgb, lightness, metal_rgb, to_gamut};
pub use direction::Direction;
pub use error::ParameterError;
pub use models::Energy;
pub use quadrature::Estimate;
