//! How a curve is stored and read.

mod cosine_curve;
mod cosine_power;
mod direct;
mod exposed_curve;
mod exposed_gain;
mod exposure;
pub(crate) mod integer;
mod profile_curve;
pub(crate) mod reciprocal;
pub(crate) mod root;
mod scaled;
mod square_curve;
mod uniform;

pub use cosine_curve::{COSINE_KNOTS, CosineCurve};
pub use cosine_power::CosinePowerTable;
pub(crate) use direct::DirectTable;
pub use exposed_curve::ExposedCurve;
pub use exposed_gain::ExposedGain;
pub use profile_curve::{PROFILE_KNOTS, ProfileCurve};
pub use reciprocal::Ratio15;
pub(crate) use scaled::ENTRY_BITS;
pub use scaled::ScaledTable;
pub use square_curve::{SQUARE_KNOTS, SquareCurve};
pub use uniform::UniformTable;
