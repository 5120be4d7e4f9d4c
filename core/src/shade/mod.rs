//! From reflected radiance to a display's codes.

mod grey;
mod linear;
mod srgb;

pub use grey::grey16;
pub use linear::{LINEAR_ONE, Linear};
pub use srgb::srgb8;
