//! What tests give the core: a material's model, and a shading frame.

use microbrdf::geometry::ShadingFrame;
use microbrdf_scene::{AnyModel, HostArithmetic, Material};

use crate::arithmetic::rounded;

/// The model of a material that is written as an argument of the command.
///
/// # Panics
/// If it is none, or the arithmetic does not take it.
#[must_use]
pub fn model<A: HostArithmetic>(toml: &str) -> AnyModel<A> {
    Material::from_argument(toml)
        .expect("a material")
        .model()
        .expect("a material that the arithmetic takes")
}

/// Directions in the shading frame, as the arithmetic holds them.
#[must_use]
pub fn frame<A: HostArithmetic>(l: [f64; 3], v: [f64; 3]) -> ShadingFrame<A> {
    ShadingFrame::new(rounded(l), rounded(v))
}
