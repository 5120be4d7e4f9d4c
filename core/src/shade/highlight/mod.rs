//! A lobe's highlight on a sphere that is seen from afar, a row at a time,
//! straight to a display's codes.

mod angle;
mod edge;
mod lit_sphere;
mod lobe_colours;
mod reach;
mod rows;
mod walk;
mod wide;
mod word;

pub use lit_sphere::LitSphere;
pub use lobe_colours::LobeColours;
pub use rows::SphereRows;
