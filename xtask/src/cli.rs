//! The command line.

use std::path::PathBuf;
use std::thread;

use clap::builder::PossibleValuesParser;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};

use crate::board::{ARITHMETICS, BOARDS, Board};
use crate::failure::{Failure, Outcome};
use crate::firmware::Order;
use crate::forecast;
use crate::layout::Layout;
use crate::measure::{self, CORES};
use crate::setup::Purpose;

const STATUSES: &str = "Exit status: 0 done; 1 ran, but a result is incomplete or differs; \
2 a mistake in what was asked for; 3 the environment lacks something.";

/// The whole command line, with help.
pub fn command() -> Command {
    Command::new("cargo xtask")
        .bin_name("cargo xtask")
        .about("The project's commands: everything that they make goes under target/")
        .subcommand_required(true)
        .arg_required_else_help(true)
        .after_help(STATUSES)
        .subcommand(setup())
        .subcommand(firmware())
        .subcommand(demo())
        .subcommand(gallery())
        .subcommand(measure_command())
        .subcommand(forecast())
        .subcommand(test())
}

fn subcommand(name: &'static str, about: &'static str, example: &'static str) -> Command {
    Command::new(name)
        .about(about)
        .after_help(format!("Example: cargo xtask {example}\n\n{STATUSES}"))
}

fn setup() -> Command {
    subcommand(
        "setup",
        "Say what is missing on this machine, ask, and install it (never removes a package)",
        "setup --dry-run",
    )
    .arg(flag("dry-run", "Only say what is missing"))
    .arg(yes())
    .arg(
        Arg::new("for")
            .long("for")
            .value_name("COMMAND")
            .help("What the machine is to be able to run")
            .value_parser(PossibleValuesParser::new([
                "firmware", "demo", "measure", "test",
            ]))
            .default_value("test"),
    )
}

fn firmware() -> Command {
    let command = subcommand(
        "firmware",
        "Build the firmware for a board, with a scene in it, and print its sizes",
        "firmware --board microbit --arithmetic q31",
    );
    scene_options(command)
        .arg(
            Arg::new("features")
                .long("features")
                .value_name("LIST")
                .help("Further cargo features of the firmware, separated by commas")
                .value_delimiter(',')
                .action(ArgAction::Append),
        )
        .arg(yes())
}

fn demo() -> Command {
    let command = subcommand(
        "demo",
        "Shade a scene on an emulated board, receive it, and show it beside host and reference",
        "demo --board netduinoplus2 --arithmetic q31",
    );
    scene_options(command)
        .arg(
            Arg::new("out")
                .long("out")
                .value_name("DIR")
                .help("Folder for the pictures and report.json")
                .default_value("target/demo"),
        )
        .arg(yes())
}

fn gallery() -> Command {
    subcommand(
        "gallery",
        "Run every scene of scenes/gallery on emulated boards; makes docs/gallery.md anew",
        "gallery",
    )
    .arg(yes())
}

fn measure_command() -> Command {
    subcommand(
        "measure",
        "Cost and error of every kernel on every core; makes docs/trade.md anew",
        "measure --core cortex-m0plus --only q31_gold",
    )
    .arg(
        Arg::new("core")
            .long("core")
            .value_name("CORE")
            .help("Only this core; docs/trade.md is then left as it is")
            .value_parser(PossibleValuesParser::new(CORES.map(|core| core.name))),
    )
    .arg(
        Arg::new("only")
            .long("only")
            .value_name("TEXT")
            .help("Only kernels with this in their names; docs/trade.md is then left as it is"),
    )
    .arg(flag(
        "set-budgets",
        "Set budgets.toml to what is found (a raised budget needs a line in CHANGELOG.md)",
    ))
    .arg(yes())
}

fn forecast() -> Command {
    subcommand(
        "forecast",
        "What single things cost on every board, which `microbrdf budget` adds up",
        "forecast --board microbit --arithmetic q15",
    )
    .arg(
        Arg::new("board")
            .long("board")
            .value_name("BOARD")
            .help("Only this board; what is known of others stays")
            .value_parser(PossibleValuesParser::new(BOARDS.map(|board| board.name))),
    )
    .arg(
        Arg::new("arithmetic")
            .long("arithmetic")
            .value_name("A")
            .help("Only this arithmetic; what is known of others stays")
            .value_parser(PossibleValuesParser::new(ARITHMETICS)),
    )
    .arg(yes())
}

fn test() -> Command {
    subcommand(
        "test",
        "Everything that CI runs: style, lints, tests, documents, firmware, emulated runs",
        "test --only python",
    )
    .arg(
        Arg::new("only")
            .long("only")
            .value_name("TEXT")
            .help("Only the steps with this text in their name (see --list)"),
    )
    .arg(flag("list", "Only print the names of the steps"))
    .arg(
        Arg::new("jobs")
            .long("jobs")
            .value_name("N")
            .help("So many steps at a time [default: one for each core]")
            .value_parser(value_parser!(u16).range(1..)),
    )
    .arg(
        // What a step of many is started with.
        Arg::new("step").long("step").hide(true),
    )
    .arg(yes())
}

/// How many steps of the tests run at a time.
pub fn jobs(matches: &ArgMatches) -> usize {
    match matches.get_one::<u16>("jobs") {
        Some(jobs) => usize::from(*jobs),
        None => thread::available_parallelism().map_or(1, usize::from),
    }
}

fn scene_options(command: Command) -> Command {
    command
        .arg(
            Arg::new("board")
                .long("board")
                .value_name("BOARD")
                .help("Board to build for")
                .value_parser(PossibleValuesParser::new(BOARDS.map(|board| board.name)))
                .default_value(BOARDS[0].name),
        )
        .arg(
            Arg::new("scene")
                .long("scene")
                .value_name("FILE")
                .help("Scene to shade")
                .default_value("scenes/demo.toml"),
        )
        .arg(
            Arg::new("arithmetic")
                .long("arithmetic")
                .value_name("A")
                .help("How numbers are represented and computed")
                .value_parser(PossibleValuesParser::new(ARITHMETICS))
                .default_value(ARITHMETICS[0]),
        )
}

fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .help(help)
        .action(ArgAction::SetTrue)
}

fn yes() -> Arg {
    flag(
        "yes",
        "Install what is missing without asking (as CI=true does)",
    )
}

/// A string option that has a default.
pub fn text<'a>(matches: &'a ArgMatches, name: &str) -> &'a str {
    matches.get_one::<String>(name).map_or("", String::as_str)
}

/// A path as the user gave it, or its default below the top of the repository.
pub fn path(layout: &Layout, matches: &ArgMatches, name: &str) -> Outcome<PathBuf> {
    let given = text(matches, name);
    if matches.value_source(name) == Some(ValueSource::DefaultValue) {
        return Ok(layout.at(given));
    }
    std::path::absolute(given).map_err(|e| Failure::mistake(format!("--{name} {given}: {e}")))
}

/// What `firmware` and `demo` are to build.
pub fn order(layout: &Layout, matches: &ArgMatches) -> Outcome<Order> {
    let features = matches.try_get_many::<String>("features").ok().flatten();
    Ok(Order {
        board: Board::named(text(matches, "board"))?,
        scene: path(layout, matches, "scene")?,
        arithmetic: text(matches, "arithmetic").to_string(),
        features: features.into_iter().flatten().cloned().collect(),
    })
}

/// What `measure` is to measure.
pub fn measure(matches: &ArgMatches) -> measure::Order {
    let option = |name: &str| matches.get_one::<String>(name).cloned();
    measure::Order {
        core: option("core"),
        only: option("only"),
        set_budgets: matches.get_flag("set-budgets"),
    }
}

/// What `forecast` is to measure.
pub fn chosen(matches: &ArgMatches) -> forecast::Chosen {
    let option = |name: &str| matches.get_one::<String>(name).cloned();
    forecast::Chosen {
        board: option("board"),
        arithmetic: option("arithmetic"),
    }
}

/// What `setup --for` names.
pub fn purpose(matches: &ArgMatches) -> Purpose {
    match text(matches, "for") {
        "firmware" => Purpose::Firmware,
        "demo" => Purpose::Demo,
        "measure" => Purpose::Measure,
        _ => Purpose::Test,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        command().debug_assert();
    }

    #[test]
    fn every_subcommand_shows_an_example() {
        for sub in command().get_subcommands() {
            let help = sub
                .get_after_help()
                .map(ToString::to_string)
                .unwrap_or_default();
            assert!(
                help.contains(&format!("Example: cargo xtask {}", sub.get_name())),
                "{}",
                sub.get_name()
            );
        }
    }
}
