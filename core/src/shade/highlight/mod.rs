//! A lobe's highlight on a sphere that is seen from afar, a row at a time,
//! straight to a display's codes.

mod lit_sphere;
mod lobe_colours;
mod row;

pub use lit_sphere::LitSphere;
pub use lobe_colours::LobeColours;
