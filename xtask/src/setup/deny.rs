//! cargo-deny, which checks licences, sources and doubled crates. Only `cargo xtask test` uses it.

use std::path::PathBuf;
use std::process::Stdio;

use crate::command::{self, Runner};
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Version that is built where none is on the search path.
pub const VERSION: &str = "0.20.2";

/// The program, if there is one.
pub fn program(layout: &Layout, runner: &dyn Runner) -> Option<PathBuf> {
    let name = format!("cargo-deny{}", std::env::consts::EXE_SUFFIX);
    let own = layout.tools().join("bin").join(name);
    if own.is_file() {
        return Some(own);
    }
    runner
        .has("cargo-deny")
        .then(|| PathBuf::from("cargo-deny"))
}

/// Builds it into `target/tools`: unoptimised, which is several times quicker to build and fast enough to run.
pub fn install(layout: &Layout) -> Outcome<()> {
    eprintln!("building cargo-deny {VERSION} from crates.io (once, about 1 min)");
    let output = command::host_cargo(layout.root())
        .args([
            "install",
            "cargo-deny",
            "--version",
            VERSION,
            "--locked",
            "--debug",
        ])
        .args(["--no-default-features", "--quiet", "--root"])
        .arg(layout.tools())
        .env("CARGO_TARGET_DIR", layout.tools().join("build"))
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .stdin(Stdio::null())
        .output()
        .during(|| "starting cargo".to_string())?;
    let _ = std::fs::remove_dir_all(layout.tools().join("build"));
    if output.status.success() {
        return Ok(());
    }
    Err(Failure::lacking(format!(
        "cargo-deny {VERSION} could not be built: {}",
        String::from_utf8_lossy(&output.stderr)
    )))
}
