//! The crates that go into people's own firmware still compile with the oldest Rust that they promise.
//!
//! That compiler comes from rustup if it is installed there; else, on Debian, the distribution's packages of it are unpacked, not installed, into `target/oldest-rust`; else the step is skipped and says so.

use std::path::Path;
use std::process::Command;

use super::counts::Tally;
use super::{Bench, Step};
use crate::command::{Machine, Runner};
use crate::failure::Outcome;
use crate::setup::unpacked;
use crate::toolchain::distribution::release;

/// The step.
pub fn step() -> Step {
    super::step(format!("oldest Rust, {}", words(promised())), run)
}

/// `rust-version` of the workspace: what core and link promise.
fn promised() -> (u32, u32) {
    stated(include_str!("../../../Cargo.toml")).unwrap_or((u32::MAX, 0))
}

/// The `rust-version` that a manifest states.
fn stated(manifest: &str) -> Option<(u32, u32)> {
    let value = |line: &str| Some(release(line.strip_prefix("rust-version = \"")?));
    manifest.lines().find_map(value)?
}

fn words((major, minor): (u32, u32)) -> String {
    format!("{major}.{minor}")
}

fn run(bench: &Bench<'_>) -> Outcome<Tally> {
    let Some(mut cargo) = find(bench)? else {
        println!(
            "skipped: Rust {} is neither installed in rustup nor among the distribution's packages",
            words(promised())
        );
        return Ok(Tally::SKIPPED);
    };
    cargo
        .args(["check", "--locked"])
        .args(["--package", "microbrdf", "--package", "microbrdf-link"])
        .current_dir(bench.layout.root())
        .env("CARGO_TARGET_DIR", bench.layout.target().join("oldest"));
    bench
        .finish("oldest-rust", &mut cargo)
        .map(|_| Tally::PASSED)
}

fn find(bench: &Bench<'_>) -> Outcome<Option<Command>> {
    if let Some(name) = rustup_toolchain(&Machine, promised()) {
        let mut cargo = Command::new("rustup");
        cargo.args(["run", &name, "cargo"]);
        // Set by the toolchain that runs this command, these would lead back to it.
        for variable in ["CARGO", "RUSTC", "RUSTUP_TOOLCHAIN"] {
            cargo.env_remove(variable);
        }
        return Ok(Some(cargo));
    }
    let root = bench.layout.target().join("oldest-rust");
    if !root.join("usr/bin/cargo").is_file() && !unpack(&Machine, &root)? {
        return Ok(None);
    }
    Ok(Some(unpacked_cargo(&root)))
}

/// An installed toolchain of that release.
fn rustup_toolchain(runner: &dyn Runner, wanted: (u32, u32)) -> Option<String> {
    let list = runner.capture(&["rustup", "toolchain", "list"])?;
    let wanted = words(wanted);
    list.stdout
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .find(|name| {
            name.strip_prefix(&wanted)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '-']))
        })
        .map(str::to_string)
}

/// Cargo from an unpacked set of packages.
fn unpacked_cargo(root: &Path) -> Command {
    let programs = root.join("usr/bin");
    let mut cargo = unpacked::program(root, "cargo");
    cargo
        .env("RUSTC", programs.join("rustc"))
        .env("CARGO", programs.join("cargo"))
        .env_remove("RUSTUP_TOOLCHAIN");
    cargo
}

/// Fetches the distribution's packages of that release, with what they need and this machine lacks, and unpacks them.
/// False where the distribution has none.
fn unpack(runner: &dyn Runner, root: &Path) -> Outcome<bool> {
    let Some(version) = packaged(runner, promised()) else {
        return Ok(false);
    };
    let wanted: Vec<String> = ["rustc-web", "cargo-web", "libstd-rust-web-dev"]
        .iter()
        .map(|name| format!("{name}={version}"))
        .collect();
    let mut packages: Vec<&str> = vec!["--allow-downgrades"];
    packages.extend(wanted.iter().map(String::as_str));
    println!("fetching Rust {version} into target/, once");
    unpacked::fetch(runner, &packages, root)?;
    Ok(true)
}

/// The version of the package that holds that release.
fn packaged(runner: &dyn Runner, wanted: (u32, u32)) -> Option<String> {
    if !runner.has("apt-get") || !runner.has("dpkg-deb") {
        return None;
    }
    let versions = runner.capture(&["apt-cache", "madison", "rustc-web"])?;
    versions
        .stdout
        .lines()
        .filter_map(|line| line.split('|').nth(1).map(str::trim))
        .find(|version| release(version) == Some(wanted))
        .map(str::to_string)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::script::Script;

    fn packages(list: &str) -> Script {
        Script::default().says("apt-cache madison rustc-web", list)
    }

    #[test]
    fn the_packaged_version_is_that_release_and_no_other() {
        let both = packages(
            " rustc-web | 1.96.0+dfsg1-1~deb12u2 | http://example.org stable-security/main\n \
             rustc-web | 1.85.0+dfsg3-1~deb12u3 | http://example.org stable/main\n",
        );
        assert_eq!(
            packaged(&both, (1, 85)).as_deref(),
            Some("1.85.0+dfsg3-1~deb12u3")
        );
        let newer = packages(" rustc-web | 1.96.0+dfsg1 | x\n");
        assert_eq!(packaged(&newer, (1, 85)), None);
        assert_eq!(packaged(&packages(""), (1, 85)), None);
    }

    #[test]
    fn the_workspace_states_a_version() {
        let manifest = "[package]\nname = \"rust-version\"\nrust-version = \"1.85\"\n";
        assert_eq!(stated(manifest), Some((1, 85)));
        assert_eq!(stated("[workspace]\n"), None);
        assert_ne!(promised().0, u32::MAX);
    }

    #[test]
    fn toolchains_of_rustup() {
        let name = |list| {
            let script = Script::default().says("rustup toolchain list", list);
            rustup_toolchain(&script, (1, 85))
        };
        assert_eq!(
            name("stable-x86_64 (active)\n1.85.1-x86_64\n"),
            Some("1.85.1-x86_64".into())
        );
        assert_eq!(name("1.85-x86_64\n"), Some("1.85-x86_64".into()));
        assert_eq!(name("1.850.0-x86_64\nstable-x86_64\n"), None);
    }
}
