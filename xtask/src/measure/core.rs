//! The cores, and what counts cycles on them.

use std::ffi::OsStr;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use super::images::Library;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// A core that is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Core {
    /// Its name, as `trade.json` has it.
    pub name: &'static str,
    /// Compiler target made for it.
    pub target: &'static str,
}

/// Every core; those of one target stand together.
pub const CORES: [Core; 5] = [
    core("cortex-m0", "thumbv6m-none-eabi"),
    core("cortex-m0plus", "thumbv6m-none-eabi"),
    core("cortex-m3", "thumbv7m-none-eabi"),
    core("cortex-m4f", "thumbv7em-none-eabihf"),
    core("rv32imc", "riscv32imc-unknown-none-elf"),
];

/// The target whose code can be run by a second emulator that counts cycles.
pub const SECOND_SOURCE: &str = "thumbv6m-none-eabi";

const fn core(name: &'static str, target: &'static str) -> Core {
    Core { name, target }
}

/// Runs every kernel's calls on the cores of a target, and returns the file
/// with what they took.
pub fn count(layout: &Layout, target: &str) -> Outcome<PathBuf> {
    let output = super::folder(layout).join(format!("{target}.json"));
    Library::kernels(layout, target).count(layout, target, &output)?;
    Ok(output)
}

/// Runs every function's calls for a target, and compares what they give.
pub fn compare(layout: &Layout, target: &str) -> Outcome<()> {
    let library = Library::checksums(layout, target);
    run(layout, target, &library, &["--results".as_ref()])
}

/// Compares the cycles on Cortex-M0+ with those of another emulator.
pub fn second_source(layout: &Layout) -> Outcome<()> {
    let library = Library::kernels(layout, SECOND_SOURCE);
    let packages = layout.node();
    let further = ["--second-source".as_ref(), packages.as_os_str()];
    run(layout, SECOND_SOURCE, &library, &further)
}

pub(super) fn run(
    layout: &Layout,
    target: &str,
    library: &Library,
    further: &[&OsStr],
) -> Outcome<()> {
    let program = layout.venv_program("microbrdf-count");
    let status = Command::new(&program)
        .args(["--target", target, "--images"])
        .arg(&library.images)
        .arg("--calls")
        .arg(&library.calls)
        .args(further)
        .stdin(Stdio::null())
        .status()
        .during(|| format!("starting {}", program.display()))?;
    let words = || format!("not every function ran as it should for {target} (see above)");
    match status.code() {
        Some(0) => Ok(()),
        Some(3) => Err(Failure::lacking(words())),
        _ => Err(Failure::incomplete(words())),
    }
}
