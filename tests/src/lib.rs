//! Where the core meets the reference: what is sampled, how an error is
//! measured, and the one table of tolerances.

pub mod domain;
pub mod error;
pub mod registry;
pub mod tolerance;
