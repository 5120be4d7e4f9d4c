//! Eight pixels at a time, in single precision: for pictures on a host.
//!
//! The core's models and shapes, in an arithmetic whose numbers are eight: no
//! model's formula stands here. Steps that are an operation or two are written for
//! vectors; the others are the core's own in single precision, once for each pixel.
//! Every operation rounds as it does in `f32`, so that the bits are the same, which
//! `tests/tests/wide.rs` holds every model to.

mod arithmetic;
mod geometry;
mod lanes;
mod models;
mod scene;
mod tracing;

pub use scene::WideScene;

use arithmetic::Wide;
use lanes::{Lanes, WIDTH};
