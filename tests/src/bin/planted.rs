//! Plants bugs in a copy of the project, one after the other, and shows
//! whether the tests notice.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use clap::Parser;
use microbrdf_tests::planted::{self, Bug};

/// Plants bugs in a copy of the project, one after the other, and shows
/// whether the tests notice. Takes about half a minute for each.
///
/// Exit status: 0 every bug was caught; 1 one was not; 2 a mistake in the
/// call; 3 cargo can't be run.
#[derive(Debug, Parser)]
#[command(
    name = "planted",
    after_help = "Example: cargo run -p microbrdf-tests --bin planted -- --only clamp"
)]
struct Arguments {
    /// Plant only the bugs whose name contains this.
    #[arg(long)]
    only: Option<String>,
    /// Name the bugs and plant none.
    #[arg(long)]
    list: bool,
    /// Folder for the copy and what is built of it.
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/planted"))]
    folder: PathBuf,
}

/// Why there is no answer.
enum Trouble {
    Usage(String),
    Environment(String),
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(Trouble::Usage(message)) => {
            eprintln!("planted: {message}");
            ExitCode::from(2)
        }
        Err(Trouble::Environment(message)) => {
            eprintln!("planted: {message}");
            ExitCode::from(3)
        }
    }
}

fn run(arguments: &Arguments) -> Result<bool, Trouble> {
    let only = arguments.only.as_deref().unwrap_or_default();
    let bugs: Vec<_> = planted::all()
        .filter(|bug| bug.name.contains(only))
        .collect();
    if bugs.is_empty() {
        return Err(Trouble::Usage(format!(
            "--only {only}: must be part of a bug's name; --list names them"
        )));
    }
    if arguments.list {
        for bug in bugs {
            println!("{}", bug.name);
        }
        return Ok(true);
    }
    let environment =
        |error: io::Error| Trouble::Environment(format!("{}: {error}", arguments.folder.display()));
    let tree = arguments.folder.join("tree");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    copy_tree(&source, &tree, true).map_err(environment)?;

    // Without a bug nothing may fail, or nothing is shown.
    let packages: BTreeSet<_> = bugs.iter().map(|bug| bug.package).collect();
    for package in packages {
        let own = bugs.iter().filter(|bug| bug.package == package);
        let all: BTreeSet<_> = own.flat_map(|bug| bug.tests).copied().collect();
        let sound = test(arguments, &tree, package, &all)?;
        if sound != Outcome::Passed {
            println!("{package}, without a bug: {sound}");
            return Ok(false);
        }
    }
    println!("| bug | file | caught by |\n| --- | --- | --- |");
    let mut caught = true;
    for bug in bugs {
        let begun = Instant::now();
        let path = tree.join(bug.file);
        let text = fs::read_to_string(&path).map_err(environment)?;
        fs::write(&path, plant(bug, &text)?).map_err(environment)?;
        let outcome = test(
            arguments,
            &tree,
            bug.package,
            &bug.tests.iter().copied().collect(),
        )?;
        fs::write(&path, &text).map_err(environment)?;
        caught &= matches!(outcome, Outcome::Failed(_));
        println!("| {} | `{}` | {outcome} |", bug.name, bug.file);
        eprintln!("{}: {} s", bug.name, begun.elapsed().as_secs());
    }
    Ok(caught)
}

fn plant(bug: &Bug, text: &str) -> Result<String, Trouble> {
    if text.matches(bug.from).count() == 1 {
        Ok(text.replace(bug.from, bug.to))
    } else {
        Err(Trouble::Usage(format!(
            "{}: {} has not once\n{}",
            bug.name, bug.file, bug.from
        )))
    }
}

/// What the tests said.
#[derive(Debug, PartialEq, Eq)]
enum Outcome {
    Passed,
    /// Names of those that failed.
    Failed(Vec<String>),
    /// The bug does not compile, which shows nothing.
    Broken(String),
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Passed => formatter.write_str("**nothing**"),
            Self::Broken(message) => write!(formatter, "**it does not compile**: {message}"),
            Self::Failed(names) => {
                let first: Vec<_> = names
                    .iter()
                    .take(3)
                    .map(|name| format!("`{name}`"))
                    .collect();
                formatter.write_str(&first.join(", "))?;
                if names.len() > first.len() {
                    write!(formatter, " and {} more", names.len() - first.len())?;
                }
                Ok(())
            }
        }
    }
}

fn test(
    arguments: &Arguments,
    tree: &Path,
    package: &str,
    files: &BTreeSet<&str>,
) -> Result<Outcome, Trouble> {
    let mut cargo = Command::new(option_env!("CARGO").unwrap_or("cargo"));
    cargo
        .current_dir(tree)
        .args(["test", "--no-fail-fast", "--quiet", "-p"])
        .arg(crate_of(package))
        .env("CARGO_TARGET_DIR", arguments.folder.join("target"))
        // Nobody debugs these: they are linked in half the time.
        .env("CARGO_PROFILE_TEST_DEBUG", "0")
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env("RUST_BACKTRACE", "0")
        .stdin(Stdio::null());
    for file in files {
        if *file == "lib" {
            cargo.arg("--lib");
        } else {
            cargo.args(["--test", file]);
        }
    }
    let output = cargo
        .output()
        .map_err(|error| Trouble::Environment(format!("cargo can't be run: {error}")))?;
    if output.status.success() {
        return Ok(Outcome::Passed);
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let mut names: Vec<_> = text
        .lines()
        .filter_map(|line| line.strip_prefix("---- ")?.strip_suffix(" stdout ----"))
        .map(str::to_owned)
        .collect();
    names.sort();
    if names.is_empty() {
        let errors = String::from_utf8_lossy(&output.stderr);
        let first = errors
            .lines()
            .find(|line| line.starts_with("error"))
            .unwrap_or("no test was named");
        return Ok(Outcome::Broken(first.to_owned()));
    }
    Ok(Outcome::Failed(names))
}

/// Copies what differs, so that what is built of the rest still holds; at the
/// top without what is built and what git keeps.
fn copy_tree(from: &Path, to: &Path, top: bool) -> io::Result<()> {
    fs::create_dir_all(to)?;
    let mut kept = BTreeSet::new();
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let name = entry.file_name();
        if top && (name == "target" || name == ".git") {
            continue;
        }
        let (source, target) = (entry.path(), to.join(&name));
        let kind = entry.file_type()?;
        if kind.is_dir() {
            copy_tree(&source, &target, false)?;
        } else if kind.is_file() {
            let content = fs::read(&source)?;
            if fs::read(&target).ok().as_ref() != Some(&content) {
                fs::write(&target, content)?;
            }
        }
        kept.insert(name);
    }
    for entry in fs::read_dir(to)? {
        let entry = entry?;
        if kept.contains(&entry.file_name()) {
            continue;
        }
        if entry.file_type()?.is_dir() {
            fs::remove_dir_all(entry.path())?;
        } else {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// The crate in a folder: core is the one that bears the project's name.
fn crate_of(folder: &str) -> String {
    if folder == "core" {
        "microbrdf".to_owned()
    } else {
        format!("microbrdf-{folder}")
    }
}
