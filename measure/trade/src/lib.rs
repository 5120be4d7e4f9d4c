//! Error against cost: what the kernels of `microbrdf-kernels` get wrong, the
//! calls that an emulated core is to make, and the tables and plots of both.

mod beside_libm;
pub mod budget;
pub mod check;
pub mod curve;
pub mod document;
pub mod errors;
pub mod goals;
pub mod join;
pub mod plot;
pub mod row;
pub mod samples;
pub mod sphere;
pub mod subject;
