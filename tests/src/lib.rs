//! Where the core meets the reference: what is sampled, how an error is
//! measured, and the one table of tolerances.

pub mod arithmetic;
pub mod baked;
pub mod broad;
pub mod curves;
pub mod dither;
pub mod document;
pub mod domain;
pub mod energy;
pub mod error;
pub mod exposed;
pub mod flicker;
pub mod frame;
pub mod fuzz;
pub mod fuzz_files;
pub mod fuzz_obj;
pub mod fuzz_scene;
pub mod given;
pub mod grazing;
pub mod meshes;
pub mod pictures;
pub mod planted;
pub mod registry;
pub mod sampling;
pub mod steps;
pub mod tolerance;

/// The example in the project's README compiles.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
