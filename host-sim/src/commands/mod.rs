//! One file for each command.

mod advise;
mod albedo;
mod bake;
mod bench;
mod budget;
mod chart;
pub mod compare;
mod device;
mod eval;
mod plot;
mod render;
mod tables;

use std::io::{self, Write as _};

use clap::ValueEnum as _;

use crate::arithmetic::ArithmeticName;
use crate::cli::Command;
use crate::exit::{Failure, Outcome};

/// Runs a command.
///
/// # Errors
/// Why it did not do what it was asked to, with the exit status.
pub fn run(command: &Command) -> Outcome<()> {
    match command {
        Command::Render(arguments) => render::run(arguments),
        Command::Compare(arguments) => compare::run(arguments),
        Command::Eval(arguments) => eval::run(arguments),
        Command::Albedo(arguments) => albedo::run(arguments),
        Command::Device(arguments) => device::run(arguments),
        Command::Bake(arguments) => bake::run(arguments),
        Command::Bench(arguments) => bench::run(arguments),
        Command::Budget(arguments) => budget::run(arguments),
        Command::Plot(arguments) => plot::run(arguments),
        Command::Advise(arguments) => advise::run(arguments),
        Command::Chart(arguments) => chart::run(arguments),
        Command::Tables(arguments) => tables::run(arguments),
    }
}

/// Prints to standard output, and fails where nobody reads on.
fn print(text: &str) -> Outcome<()> {
    let mut output = io::stdout().lock();
    output
        .write_all(text.as_bytes())
        .and_then(|()| output.flush())
        .map_err(|error| Failure::Incomplete(format!("standard output: {error}")))
}

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
