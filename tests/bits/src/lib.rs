//! A checksum over many results of the core, raw bits and all, for each model
//! in an arithmetic.
//!
//! It takes neither `std` nor an allocator: a host test and a probe on a
//! microcontroller call the same function and compare what it gives. Samples
//! are made in integers, so that they are the same everywhere by construction.

#![no_std]

mod arithmetic;
mod digest;
mod exposed;
mod highlight;
mod models;
mod raw;
mod samples;

pub use arithmetic::Sampled;
pub use digest::digest;
pub use exposed::exposed_checksums;
pub use highlight::highlight_checksums;
pub use models::checksums;
pub use raw::{Checksum, Raw};
pub use samples::{PairKind, Samples};
