//! Eight pixels at a time, in single precision: for pictures on a host.
//!
//! The core's models and shapes, in an arithmetic whose numbers are eight. Each of
//! its steps is the core's own step in single precision, once for each of the
//! eight, which a compiler turns into instructions for several at once; so the bits
//! are those of `f32`, and no model's formula stands here. Four and sixteen at a
//! time were tried, and are slower.

mod arithmetic;
mod geometry;
mod lanes;
mod models;
mod scene;
mod tracing;

pub use scene::WideScene;

use arithmetic::Wide;
use lanes::{Lanes, WIDTH};
