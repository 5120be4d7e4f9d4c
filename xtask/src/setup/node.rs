//! rp2040js under `target/node`: the emulator that cycles of Cortex-M0+ are compared with.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Where its manifest and lock file are, exact version and checksum.
const FOLDER: &str = "measure/counter/src/microbrdf_counter/rp2040";
/// Both, with the lock file last: a copy of it says that all is there.
const FILES: [&str; 2] = ["package.json", "package-lock.json"];

/// What is missing without Node.js: programs with their packages.
pub const PROGRAMS: [(&str, &str); 2] = [("node", "nodejs"), ("npm", "npm")];

fn stamp(layout: &Layout) -> PathBuf {
    layout.node().join("installed")
}

fn lock(layout: &Layout) -> Outcome<String> {
    let path = layout.at(FOLDER).join(FILES[1]);
    fs::read_to_string(&path).during(|| format!("reading {}", path.display()))
}

/// Whether it is there as the lock file says.
pub fn current(layout: &Layout) -> bool {
    fs::read_to_string(stamp(layout)).is_ok_and(|found| lock(layout) == Ok(found))
}

/// Installs it from the lock file; no script of a package is run.
pub fn install(layout: &Layout) -> Outcome<()> {
    let folder = layout.node();
    eprintln!("installing rp2040js into {}", layout.shown(&folder));
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    for file in FILES {
        fs::copy(layout.at(FOLDER).join(file), folder.join(file))
            .during(|| format!("copying {file} to {}", folder.display()))?;
    }
    let output = Command::new("npm")
        .args(["ci", "--ignore-scripts", "--no-audit", "--no-fund"])
        .current_dir(&folder)
        .stdin(Stdio::null())
        .output()
        .during(|| "starting npm".to_string())?;
    if !output.status.success() {
        return Err(Failure::lacking(format!(
            "npm ci failed:\n{}{}",
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        )));
    }
    let stamp = stamp(layout);
    fs::write(&stamp, lock(layout)?).during(|| format!("writing {}", stamp.display()))
}
