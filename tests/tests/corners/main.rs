//! Directions at the corners of the domain, and out of it: the documented
//! rule or a value in range, never anything else. Parameters out of range
//! are in `parameters.rs`.

mod exposure;
mod faults;
mod horizon;
mod inputs;
mod lengths;
mod peak;

use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::given::model;
use microbrdf_tests::registry;

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
