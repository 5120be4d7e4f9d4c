//! Other programs: finding them, and running them behind a trait that tests can replace.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Builds one of this project's programs, showing what cargo does unless that is not wanted.
pub fn build(mut cargo: Command, quiet: bool, program: &str) -> Outcome<()> {
    let built = cargo
        .args(quiet.then_some("--quiet"))
        .stdin(Stdio::null())
        .status()
        .during(|| "starting cargo".to_string())?;
    if built.success() {
        return Ok(());
    }
    Err(Failure::incomplete(format!(
        "{program} does not build (see above)"
    )))
}

/// `cargo build` of one of this project's programs, in release profile.
pub fn release(layout: &Layout, package: &str, program: &str) -> Command {
    let mut cargo = host_cargo(layout.root());
    cargo
        .args(["build", "--release", "--locked"])
        .args(["--package", package, "--bin", program])
        // Where `built` finds it.
        .env("CARGO_TARGET_DIR", layout.target());
    cargo
}

/// The program that `release` has built: started without cargo, which would wait for other builds.
pub fn built(layout: &Layout, program: &str) -> Command {
    let file = format!("{program}{}", env::consts::EXE_SUFFIX);
    let mut command = Command::new(layout.target().join("release").join(file));
    command.current_dir(layout.root()).stdin(Stdio::null());
    command
}

/// What a program left behind.
#[derive(Debug, Clone, Default)]
pub struct Finished {
    /// Whether it exited with 0.
    pub success: bool,
    /// Its standard output.
    pub stdout: String,
    /// Its standard error.
    pub stderr: String,
}

/// Runs programs of the machine. The real one starts them; tests answer from a script.
pub trait Runner {
    /// Whether a program of this name can be started.
    fn has(&self, program: &str) -> bool;
    /// Runs quietly and returns what it printed; `None` where it could not be started.
    fn capture(&self, line: &[&str]) -> Option<Finished>;
    /// Runs with the terminal shared, and ends it after `limit`; true where it exited with 0.
    fn show(&self, line: &[&str], limit: Option<Duration>) -> bool;
}

/// The machine itself.
#[derive(Debug)]
pub struct Machine;

impl Runner for Machine {
    fn has(&self, program: &str) -> bool {
        on_path(program).is_some()
    }

    fn capture(&self, line: &[&str]) -> Option<Finished> {
        let (program, arguments) = line.split_first()?;
        let output = Command::new(program)
            .args(arguments)
            // What they print is parsed, so it has to be in one language.
            .env("LC_ALL", "C")
            .stdin(Stdio::null())
            .output()
            .ok()?;
        Some(Finished {
            success: output.status.success(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        })
    }

    fn show(&self, line: &[&str], limit: Option<Duration>) -> bool {
        let Some((program, arguments)) = line.split_first() else {
            return false;
        };
        let started = Instant::now();
        let Ok(mut child) = Command::new(program)
            .args(arguments)
            .env("DEBIAN_FRONTEND", "noninteractive")
            .stdin(Stdio::null())
            .spawn()
        else {
            return false;
        };
        let Some(limit) = limit else {
            return child.wait().is_ok_and(|status| status.success());
        };
        loop {
            match child.try_wait() {
                Ok(Some(status)) => return status.success(),
                Ok(None) if started.elapsed() < limit => thread::sleep(Duration::from_millis(50)),
                _ => {
                    let _ = child.kill();
                    let _ = child.wait();
                    return false;
                }
            }
        }
    }
}

/// Where a program lies on the search path.
pub fn on_path(program: &str) -> Option<PathBuf> {
    let name = format!("{program}{}", env::consts::EXE_SUFFIX);
    env::split_paths(&env::var_os("PATH")?)
        .map(|dir| dir.join(&name))
        .find(|path| path.is_file())
}

/// Cargo of the toolchain that runs this command, rooted in the workspace.
pub fn host_cargo(root: &Path) -> Command {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(root);
    command
}

/// A command line as one would type it.
pub fn typed(line: &[&str]) -> String {
    line.join(" ")
}

/// A command as one would type it, for messages.
pub fn shown(command: &Command) -> String {
    std::iter::once(command.get_program())
        .chain(command.get_args())
        .map(|word| word.to_string_lossy())
        .collect::<Vec<_>>()
        .join(" ")
}
