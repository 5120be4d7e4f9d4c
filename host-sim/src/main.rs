//! The command `microbrdf`: what a microcontroller shades, on a host.

mod arithmetic;
mod cli;
mod commands;
mod directions;
mod energy;
mod exit;
mod measure;
mod picture;
mod progress;
mod reference_picture;
mod render;

use std::process::ExitCode;

use clap::Parser as _;

use cli::{Cli, Command};

fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Render(arguments) => commands::render::run(&arguments),
        Command::Compare(arguments) => commands::compare::run(&arguments),
        Command::Eval(arguments) => commands::eval::run(&arguments),
        Command::Albedo(arguments) => commands::albedo::run(&arguments),
        Command::Device(arguments) => commands::device::run(&arguments),
        Command::Bake(arguments) => commands::bake::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("microbrdf: {failure}");
            ExitCode::from(failure.status())
        }
    }
}
