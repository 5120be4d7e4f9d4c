//! The project's commands, run as `cargo xtask …`.

mod board;
mod check;
mod cli;
mod command;
mod demo;
mod failure;
mod firmware;
mod forecast;
mod gallery;
mod host_sim;
mod layout;
mod lock;
mod measure;
mod picture;
mod qemu;
mod receiver;
mod report;
mod setup;
mod sizes;
mod stack;
mod toolchain;

use std::process::ExitCode;

use clap::ArgMatches;

use board::Board;
use command::Machine;
use failure::{Failure, Outcome};
use firmware::Order;
use layout::Layout;
use setup::Purpose;
use toolchain::Cross;

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
        Some(("firmware", options)) => {
            let order = cli::order(&layout, options)?;
            let cross = cross(&layout, Purpose::Firmware, &order, options)?;
            firmware::command(&layout, &cross, &order)
        }
        Some(("demo", options)) => {
            let order = cli::order(&layout, options)?;
            let out = cli::path(&layout, options, "out")?;
            let cross = cross(&layout, Purpose::Demo, &order, options)?;
            demo::command(&layout, &cross, &order, &out)
        }
        Some(("measure", options)) => {
            let order = cli::measure(options);
            let yes = options.get_flag("yes");
            let cross = setup::ensure(&layout, &Machine, Purpose::Measure, &order.targets(), yes)?;
            measure::command(&layout, &cross, &order)
        }
        Some(("forecast", options)) => {
            let targets = Board::targets();
            let yes = options.get_flag("yes");
            let cross = setup::ensure(&layout, &Machine, Purpose::Test, &targets, yes)?;
            forecast::command(&layout, &cross, &cli::chosen(options))
        }
        Some(("gallery", options)) => {
            let targets = Board::targets();
            let yes = options.get_flag("yes");
            let cross = setup::ensure(&layout, &Machine, Purpose::Test, &targets, yes)?;
            gallery::command(&layout, &cross)
        }
        Some(("test", options)) => {
            if options.get_flag("list") {
                check::list();
                return Ok(());
            }
            let targets = measure::with_boards();
            let text = |name: &str| options.get_one::<String>(name).map(String::as_str);
            let jobs = cli::jobs(options);
            if let Some(step) = text("step") {
                let cross = toolchain::ready(&layout, &Machine, &targets, true)?
                    .ok_or_else(|| Failure::lacking("no cross compiler"))?;
                return check::one(&layout, &cross, step, jobs);
            }
            let yes = options.get_flag("yes");
            let cross = setup::ensure(&layout, &Machine, Purpose::Test, &targets, yes)?;
            check::run(&layout, &cross, text("only"), jobs)
        }
        _ => unreachable!("clap requires a subcommand"),
    }
}

/// Sees to it that this order can be carried out.
fn cross(layout: &Layout, purpose: Purpose, order: &Order, options: &ArgMatches) -> Outcome<Cross> {
    firmware::check_scene(&order.scene)?;
    setup::ensure(
        layout,
        &Machine,
        purpose,
        &[order.board.target],
        options.get_flag("yes"),
    )
}
