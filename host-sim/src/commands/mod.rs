//! One file for each command.

pub mod albedo;
pub mod bake;
pub mod compare;
pub mod device;
pub mod eval;
pub mod render;

use clap::ValueEnum as _;

use crate::arithmetic::ArithmeticName;
use crate::exit::{Failure, Outcome};

/// One of the core's arithmetics, or double precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Computed {
    /// The core.
    Core(ArithmeticName),
    /// The reference.
    Reference,
}

impl Computed {
    /// Reads `--arithmetic` where `reference` is allowed, too.
    pub fn parse(name: &str) -> Outcome<Self> {
        if name == "reference" || name == "f64" {
            return Ok(Self::Reference);
        }
        ArithmeticName::from_str(name, false)
            .map(Self::Core)
            .map_err(|_| {
                let names: Vec<_> = ArithmeticName::ALL.iter().map(|name| name.name()).collect();
                Failure::Usage(format!(
                    "--arithmetic {name}: must be one of {}, reference",
                    names.join(", ")
                ))
            })
    }
}
