//! The virtual environment under `target/venv`, with the receiver and the counter of cycles in it.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::command::Runner;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// A package of ours with the lock file of what it needs, exact versions and checksums.
struct Package {
    /// Its folder.
    folder: &'static str,
    /// Name of the file, in the environment, that says that it is installed.
    stamp: &'static str,
}

/// The receiver; its lock file holds what everything is tested with.
const RECEIVER: Package = Package {
    folder: "receiver",
    stamp: "installed",
};

/// The counter of cycles.
const COUNTER: Package = Package {
    folder: "measure/counter",
    stamp: "installed-counter",
};

/// The interpreter that environments are made with.
pub const PYTHON: &str = if cfg!(windows) { "python" } else { "python3" };

impl Package {
    fn lock(&self) -> String {
        format!("{}/requirements.lock", self.folder)
    }

    /// Everything that the environment's contents depend on, as one text.
    fn fingerprint(&self, layout: &Layout) -> Outcome<String> {
        let read = |path: String| {
            let path = layout.at(&path);
            fs::read_to_string(&path).during(|| format!("reading {}", path.display()))
        };
        let lock = read(self.lock())?;
        let project = read(format!("{}/pyproject.toml", self.folder))?;
        // Programs of an environment hold its path, so that a moved repository needs a new one.
        Ok(format!("{}\n{lock}\n{project}", layout.venv().display()))
    }

    /// Where the fingerprint of a finished installation is kept.
    fn stamp(&self, layout: &Layout) -> PathBuf {
        layout.venv().join(self.stamp)
    }

    fn current(&self, layout: &Layout) -> bool {
        layout.venv_program("python").exists()
            && fs::read_to_string(self.stamp(layout))
                .is_ok_and(|found| self.fingerprint(layout) == Ok(found))
    }

    /// Installs from the lock file, and then the package itself.
    fn install(&self, layout: &Layout) -> Outcome<()> {
        let fingerprint = self.fingerprint(layout)?;
        let pip = || {
            let mut command = Command::new(layout.venv_program("python"));
            command.args(["-m", "pip", "--disable-pip-version-check"]);
            command.args(["install", "--quiet"]);
            command
        };
        let mut locked = pip();
        locked
            .args(["--require-hashes", "-r"])
            .arg(layout.at(&self.lock()));
        finish(locked, "installing from the lock file")?;
        let mut own = pip();
        own.args(["--no-deps", "--no-build-isolation", "--editable"])
            .arg(layout.at(self.folder));
        finish(own, &format!("installing {}", self.folder))?;
        let stamp = self.stamp(layout);
        fs::write(&stamp, fingerprint).during(|| format!("writing {}", stamp.display()))
    }
}

/// Whether the environment is there and holds what the receiver's lock file says.
pub fn current(layout: &Layout) -> bool {
    RECEIVER.current(layout)
}

/// Whether it holds the counter, too.
pub fn counter_current(layout: &Layout) -> bool {
    current(layout) && COUNTER.current(layout)
}

/// Whether Python is there and can make environments; Debian and Ubuntu ship that part on its own.
pub fn can_make_venv(runner: &dyn Runner) -> bool {
    runner
        .capture(&[PYTHON, "-c", "import ensurepip, venv"])
        .is_some_and(|run| run.success)
}

/// Makes the environment anew where needed and installs the receiver into it.
pub fn install(layout: &Layout) -> Outcome<()> {
    let venv = layout.venv();
    eprintln!("installing the receiver into {}", layout.shown(&venv));
    let fingerprint = RECEIVER.fingerprint(layout)?;
    let moved = fs::read_to_string(RECEIVER.stamp(layout))
        .is_ok_and(|old| old.lines().next() != fingerprint.lines().next());
    let mut make = Command::new(PYTHON);
    make.args(["-m", "venv"]).arg(&venv);
    if moved || !layout.venv_program("python").exists() {
        make.arg("--clear");
    }
    finish(make, "making the virtual environment")?;
    RECEIVER.install(layout)
}

/// Installs the counter into the receiver's environment.
pub fn install_counter(layout: &Layout) -> Outcome<()> {
    eprintln!(
        "installing the counter of cycles into {}",
        layout.shown(&layout.venv())
    );
    COUNTER.install(layout)
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
