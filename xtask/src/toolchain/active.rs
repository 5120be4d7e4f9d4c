//! The active toolchain: does it have the targets, and can rustup add them?

use std::path::Path;

use super::Cross;
use super::sysroot;
use crate::command::Runner;

/// The active toolchain, if `core` for each target is installed beside it.
pub fn ready(runner: &dyn Runner, targets: &[&str]) -> Option<Cross> {
    let own = runner
        .capture(&["rustc", "--print", "sysroot"])
        .filter(|run| run.success)?;
    let own = Path::new(own.stdout.trim());
    if !targets.iter().all(|target| sysroot::holds(own, target)) {
        return None;
    }
    let version = runner
        .capture(&["rustc", "--version"])?
        .stdout
        .trim()
        .to_string();
    Some(Cross::Active { version })
}

/// Whether rustup manages the active toolchain, so that it could add targets to it.
pub fn from_rustup(runner: &dyn Runner) -> bool {
    if !runner.has("rustup") {
        return false;
    }
    let which = runner
        .capture(&["rustup", "which", "rustc"])
        .filter(|run| run.success);
    let own = runner
        .capture(&["rustc", "--print", "sysroot"])
        .filter(|run| run.success);
    match (which, own) {
        (Some(which), Some(own)) => Path::new(which.stdout.trim()).starts_with(own.stdout.trim()),
        _ => false,
    }
}

/// The line that adds the targets.
pub fn add_line<'a>(targets: &[&'a str]) -> Vec<&'a str> {
    let mut line = vec!["rustup", "target", "add"];
    line.extend(targets);
    line
}
