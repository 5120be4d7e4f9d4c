//! Programs of the distribution that are unpacked under `target/`, not installed: where installing them would change the machine.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{self, Runner};
use crate::failure::{During, Failure, Outcome};
use crate::setup::apt;

/// Fetches packages, with what they need and this machine lacks, and unpacks them into `root`. Options of apt-get may stand among them.
pub fn fetch(runner: &dyn Runner, packages: &[&str], root: &Path) -> Outcome<()> {
    let quote = apt::quote(runner, packages);
    if let Some(refused) = quote.refused {
        return Err(Failure::incomplete(format!(
            "apt-get does not resolve {packages:?}: {refused}"
        )));
    }
    let partial = root.with_extension("partial");
    let _ = fs::remove_dir_all(&partial);
    fs::create_dir_all(&partial).during(|| format!("creating {}", partial.display()))?;
    let exact: Vec<String> = quote
        .install
        .iter()
        .map(|(name, version)| format!("{name}={version}"))
        .collect();
    run_in(
        &partial,
        Command::new("apt-get")
            .arg("-q")
            .arg("download")
            .args(&exact),
    )?;
    for entry in fs::read_dir(&partial)
        .during(|| "listing packages".to_string())?
        .flatten()
    {
        let package = entry.path();
        if package.extension().is_some_and(|ending| ending == "deb") {
            run_in(
                &partial,
                Command::new("dpkg-deb")
                    .arg("-x")
                    .arg(&package)
                    .arg(&partial),
            )?;
            let _ = fs::remove_file(&package);
        }
    }
    let _ = fs::remove_dir_all(root);
    fs::rename(&partial, root).during(|| format!("moving to {}", root.display()))
}

/// A program of `usr/bin` in `root`, with the libraries beside it.
pub fn program(root: &Path, name: &str) -> Command {
    let programs = root.join("usr/bin");
    let mut command = Command::new(programs.join(name));
    let libraries: Vec<PathBuf> = ["usr/lib", "lib"]
        .iter()
        .flat_map(|folder| {
            fs::read_dir(root.join(folder))
                .into_iter()
                .flatten()
                .flatten()
        })
        .map(|entry| entry.path())
        .filter(|path| path.to_string_lossy().ends_with("-linux-gnu"))
        .collect();
    let mut path = vec![programs];
    path.extend(env::split_paths(&env::var_os("PATH").unwrap_or_default()));
    if let (Ok(libraries), Ok(path)) = (env::join_paths(libraries), env::join_paths(path)) {
        command.env("LD_LIBRARY_PATH", libraries).env("PATH", path);
    }
    command
}

fn run_in(folder: &Path, command: &mut Command) -> Outcome<()> {
    let output = command
        .current_dir(folder)
        .output()
        .during(|| format!("starting {}", command::shown(command)))?;
    if output.status.success() {
        return Ok(());
    }
    Err(Failure::incomplete(format!(
        "{} failed:\n{}",
        command::shown(command),
        String::from_utf8_lossy(&output.stderr)
    )))
}
