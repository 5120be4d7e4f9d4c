//! How a curve is stored and read.

mod cosine_curve;
pub(crate) mod integer;
mod uniform;

pub use cosine_curve::{COSINE_KNOTS, CosineCurve};
pub use uniform::UniformTable;
