//! What a scene will take on a board, before anything is built: bytes and
//! cycles as sums over what the scene has, with costs that were measured.
//!
//! What there is of each thing is counted exactly: bytes of tables from their
//! types ([`bytes`]), steps of shading by running the row function with
//! counters in place of materials, lights, planes and spheres ([`steps`]).
//! What one of each costs was found by least squares over small scenes that
//! were built and counted for each board (`cargo xtask forecast`, [`fit`]).

pub mod bytes;
pub mod fit;
mod forecast;
mod kind;
pub mod measured;
pub mod steps;
mod tally;

pub use forecast::{Added, Forecast, forecast, row_buffers};
