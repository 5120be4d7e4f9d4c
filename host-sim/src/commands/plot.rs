//! `microbrdf plot`.

mod figures;
mod label;
mod materials;

use crate::cli::Plot;
use crate::exit::Outcome;

/// Draws curves of materials, or figures of the thesis.
pub fn run(arguments: &Plot) -> Outcome<()> {
    match &arguments.figure {
        Some(number) => figures::run(arguments, number),
        None => materials::run(arguments),
    }
}
