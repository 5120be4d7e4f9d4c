//! The virtual environment under `target/venv`, with the receiver in it.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::command::Runner;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Exact versions and checksums of everything that the receiver runs with and is tested with.
const LOCK: &str = "receiver/requirements.lock";

/// The receiver's own metadata: its commands among them.
const PROJECT: &str = "receiver/pyproject.toml";

/// The interpreter that environments are made with.
pub const PYTHON: &str = if cfg!(windows) { "python" } else { "python3" };

/// Everything that the environment's contents depend on, as one text.
fn fingerprint(layout: &Layout) -> Option<String> {
    let lock = fs::read_to_string(layout.at(LOCK)).ok()?;
    let project = fs::read_to_string(layout.at(PROJECT)).ok()?;
    // Programs of an environment hold its path, so that a moved repository needs a new one.
    Some(format!("{}\n{lock}\n{project}", layout.venv().display()))
}

/// Where the fingerprint of a finished installation is kept.
fn stamp(layout: &Layout) -> PathBuf {
    layout.venv().join("installed")
}

/// Whether the environment is there and holds what the lock file says.
pub fn current(layout: &Layout) -> bool {
    layout.venv_program("python").exists()
        && fs::read_to_string(stamp(layout)).is_ok_and(|found| Some(found) == fingerprint(layout))
}

/// Whether Python is there and can make environments; Debian and Ubuntu ship that part on its own.
pub fn can_make_venv(runner: &dyn Runner) -> bool {
    runner
        .capture(&[PYTHON, "-c", "import ensurepip, venv"])
        .is_some_and(|run| run.success)
}

/// Makes the environment anew where needed and installs into it from the lock file.
pub fn install(layout: &Layout) -> Outcome<()> {
    let venv = layout.venv();
    eprintln!("installing the receiver into {}", layout.shown(&venv));
    let fingerprint = fingerprint(layout)
        .ok_or_else(|| Failure::incomplete(format!("{LOCK} or {PROJECT} cannot be read")))?;
    let stamp = stamp(layout);
    let moved = fs::read_to_string(&stamp)
        .is_ok_and(|old| old.lines().next() != fingerprint.lines().next());
    let mut make = Command::new(PYTHON);
    make.args(["-m", "venv"]).arg(&venv);
    if moved || !layout.venv_program("python").exists() {
        make.arg("--clear");
    }
    finish(make, "making the virtual environment")?;
    let python = layout.venv_program("python");
    let pip = || {
        let mut command = Command::new(&python);
        command.args([
            "-m",
            "pip",
            "--disable-pip-version-check",
            "install",
            "--quiet",
        ]);
        command
    };
    let mut locked = pip();
    locked.args(["--require-hashes", "-r"]).arg(layout.at(LOCK));
    finish(locked, "installing from the lock file")?;
    let mut own = pip();
    own.args(["--no-deps", "--no-build-isolation", "--editable"])
        .arg(layout.at("receiver"));
    finish(own, "installing the receiver")?;
    fs::write(&stamp, fingerprint).during(|| format!("writing {}", stamp.display()))
}

/// Runs to the end, quietly unless it fails.
fn finish(mut command: Command, what: &str) -> Outcome<()> {
    let output = command
        .stdin(Stdio::null())
        .output()
        .during(|| format!("{what}: starting {PYTHON}"))?;
    if output.status.success() {
        return Ok(());
    }
    Err(Failure::lacking(format!(
        "{what} failed:\n{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    )))
}
