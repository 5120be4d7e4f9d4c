//! The command `microbrdf`: what a microcontroller shades, on a host.

use std::process::ExitCode;

use clap::Parser as _;
use microbrdf_sim::cli::Cli;
use microbrdf_sim::commands;

fn main() -> ExitCode {
    match commands::run(&Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("microbrdf: {failure}");
            ExitCode::from(failure.status())
        }
    }
}
