//! Directions at the corners of the domain, and out of it: the documented
//! rule or a value in range, never anything else. Parameters out of range
//! are in `parameters.rs`.

mod exposure;
mod faults;
mod horizon;
mod inputs;
mod lengths;
mod peak;

use microbrdf::geometry::ShadingFrame;
use microbrdf_scene::{AnyModel, Material};
use microbrdf_tests::arithmetic::{Tested, rounded};
use microbrdf_tests::registry;

fn model<A: Tested>(toml: &str) -> AnyModel<A> {
    Material::from_argument(toml)
        .expect("a material")
        .model()
        .expect("a material that the arithmetic takes")
}

/// All models, the colours apart from white.
fn models<A: Tested>() -> Vec<(String, AnyModel<A>)> {
    registry::all()
        .into_iter()
        .map(|entry| {
            let model = model(&entry.toml);
            (entry.toml, model)
        })
        .collect()
}

fn frame<A: Tested>(l: [f64; 3], v: [f64; 3]) -> ShadingFrame<A> {
    ShadingFrame::new(rounded(l), rounded(v))
}
