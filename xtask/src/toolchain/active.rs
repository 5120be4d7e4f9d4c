//! The active toolchain: does it have the targets, and can rustup add them?

use std::env;
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

/// Whether rustup manages the active toolchain, so that it could add targets to it, and is not told to install nothing by itself.
pub fn from_rustup(runner: &dyn Runner) -> bool {
    if !runner.has("rustup") || is_off(env::var("RUSTUP_AUTO_INSTALL").ok().as_deref()) {
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

/// Whether rustup's own setting of whether it installs by itself says no.
fn is_off(setting: Option<&str>) -> bool {
    setting == Some("0")
}

/// The line that adds the targets.
pub fn add_line<'a>(targets: &[&'a str]) -> Vec<&'a str> {
    let mut line = vec!["rustup", "target", "add"];
    line.extend(targets);
    line
}

#[cfg(test)]
mod tests {
    use super::is_off;

    #[test]
    fn rustup_may_install_unless_it_is_told_not_to() {
        assert!(!is_off(None));
        assert!(!is_off(Some("1")));
        assert!(is_off(Some("0")));
    }
}
