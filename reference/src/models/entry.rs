//! What the list of models says of each: the type of every model's `ENTRY`.

use crate::fresnel::Index;
use crate::sampling::Sampler;
use crate::{Brdf, Direction};

/// What a parameter set is expected to do with energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// The albedo never exceeds 1.
    Conserves,
    /// It does somewhere.
    Exceeds,
}

/// A model with parameters, for tests and documentation.
pub struct Example {
    /// The parameters as text.
    pub parameters: &'static str,
    /// The model.
    pub model: Box<dyn Brdf>,
    /// What it is expected to do with energy.
    pub claim: Claim,
}

/// Calls back with a model, a V and a sampler of it.
pub type WithSampler = fn(Direction, &mut dyn FnMut(&dyn Brdf, &dyn Sampler));

/// An entry of the list.
pub struct ModelEntry {
    /// The name of its file in `models/`.
    pub name: &'static str,
    /// Where it is from.
    pub source: &'static str,
    /// The formula.
    pub formula: &'static str,
    /// Its parameters and their ranges.
    pub parameters: &'static str,
    /// Whether f(L, V) = f(V, L).
    pub reciprocal: bool,
    /// What it does at grazing angles.
    pub grazing: &'static str,
    /// Parameter sets; the first is the one that the cost is counted for.
    pub examples: fn() -> Vec<Example>,
    /// A sampler, where the texts give one.
    pub sampler: Option<WithSampler>,
}

/// An example from a model of any type.
pub(super) fn example(
    parameters: &'static str,
    model: impl Brdf + 'static,
    claim: Claim,
) -> Example {
    Example {
        parameters,
        model: Box::new(model),
        claim,
    }
}

/// A refractive index η + ik that is known to be in range.
pub(super) fn index(eta: f64, k: f64) -> Index {
    Index::new(eta, k).expect("a plausible index")
}

/// About gold's indices at 610, 550 and 465 nm.
pub(super) fn gold() -> [Index; 3] {
    [index(0.50, 3.2), index(0.69, 2.4), index(1.64, 1.74)]
}
