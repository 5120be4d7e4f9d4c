//! The project's commands, run as `cargo xtask …`.

mod board;
mod cli;
mod command;
mod failure;
mod layout;
mod setup;
mod toolchain;

use std::process::ExitCode;

use clap::ArgMatches;

use failure::Outcome;
use layout::Layout;

fn main() -> ExitCode {
    // On a mistake, clap prints it and exits with 2.
    let matches = cli::command().get_matches();
    match run(&matches) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::from(failure.status)
        }
    }
}

fn run(matches: &ArgMatches) -> Outcome<()> {
    let layout = Layout::find()?;
    match matches.subcommand() {
        Some(("setup", options)) => setup::command(
            &layout,
            cli::purpose(options),
            options.get_flag("dry-run"),
            options.get_flag("yes"),
        ),
        _ => unreachable!("clap requires a subcommand"),
    }
}
