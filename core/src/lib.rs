//! Physically plausible reflectance models for microcontrollers.
//!
//! Metallic Phong, patch BRDFs and metals with Fresnel's factor: the cheapest
//! models that are reciprocal and conserve energy, in single precision and in
//! fixed point. No allocation, no `unsafe`, no panic; what is not called is
//! not linked.
//!
//! * L points from the surface to the light, V to the viewer; both are unit
//!   vectors. In the **shading frame** the normal is +z.
//! * A **BRDF** value is in sr⁻¹ and does not include the cosine. **Reflected
//!   radiance** is f·cosΘL, for unit normal irradiance.
//! * An [`arithmetic`](arithmetic::Arithmetic) is a type parameter: the same
//!   formula is compiled for each that is used.
//!
//! ```
//! use microbrdf::arithmetic::Q31;
//! use microbrdf::brdf::{Brdf, MetallicPhong};
//! use microbrdf::fixed::types::{I2F30, U32F32};
//! use microbrdf::geometry::{Direction, World};
//!
//! // A material in flash; a parameter out of range stops the compilation.
//! static STEEL: MetallicPhong<Q31> =
//!     microbrdf::constant!(MetallicPhong::<Q31>::new(U32F32::lit("40")));
//!
//! let up = Direction::new(I2F30::ZERO, I2F30::ZERO, I2F30::ONE);
//! let reflected = STEEL.reflect(&World::new(up, up, up)).r;
//! assert_eq!(reflected, STEEL.peak());
//! ```
//!
//! Equation numbers are those of A. Neumann, *Constructions of Bidirectional
//! Reflection Distribution Functions*, TU Wien, 2001.
#![no_std]

pub mod arithmetic;
pub mod brdf;
mod colour;
mod error;
pub mod geometry;
pub mod sampling;
pub mod shade;
pub mod table;

pub use colour::Rgb;
pub use error::ParameterError;
/// Re-exported, so that its types agree with this crate's.
pub use fixed;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
