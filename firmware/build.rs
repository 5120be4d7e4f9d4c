//! Puts together what the device's build needs: the board's linker script, the
//! baked scene, and the compiler's name for the frame header.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// Boards, as their features and folders call them.
const BOARDS: [&str; 3] = ["lm3s6965evb", "microbit", "netduinoplus2"];

/// Path of the file that `microbrdf bake` wrote.
const SCENE: &str = "MICROBRDF_SCENE_RS";

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=MICROBRDF_COMPILER={}", compiler());
    if env::var("CARGO_CFG_TARGET_OS").as_deref() != Ok("none") {
        return ExitCode::SUCCESS; // the host has no board: library and tests only
    }
    match linker_script().and_then(|()| scene()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            println!("cargo::error={message}");
            ExitCode::FAILURE
        }
    }
}

/// First line of `rustc --version`.
fn compiler() -> String {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    Command::new(rustc)
        .arg("--version")
        .output()
        .ok()
        .and_then(|output| String::from_utf8(output.stdout).ok())
        .and_then(|text| text.lines().next().map(str::to_owned))
        .unwrap_or_else(|| "rustc, version unknown".to_owned())
}

/// Lets the linker find the one board's regions.
fn linker_script() -> Result<(), String> {
    let chosen: Vec<_> = BOARDS
        .into_iter()
        .filter(|board| has_feature(board))
        .collect();
    let [board] = chosen[..] else {
        return Err(format!(
            "features: {} boards are chosen, must be 1 of board-{}",
            chosen.len(),
            BOARDS.join(", board-"),
        ));
    };
    let source = Path::new("src/boards").join(board).join("board.x");
    copy(&source, "board.x")?;
    println!("cargo::rerun-if-changed=../memory.x");
    println!("cargo::rustc-link-search={}", out_dir().display());
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    // Sections start where they must, not at the next 64 KiB page of a system with an MMU.
    println!("cargo::rustc-link-arg-bins=--nmagic");
    // An image that is too large is told by all that does not fit.
    println!("cargo::rustc-link-arg-bins=--error-limit=0");
    if env::var_os("CARGO_FEATURE_DEFMT").is_some() {
        println!("cargo::rustc-link-arg-bins=-Tdefmt.x");
        log_level();
    }
    Ok(())
}

/// Has `info` logged and what is graver, unless the environment asks for other
/// levels: defmt's own default is errors alone.
fn log_level() {
    const LEVEL: &str = "DEFMT_LOG";
    println!("cargo::rerun-if-env-changed={LEVEL}");
    if env::var_os(LEVEL).is_none() {
        println!("cargo::rustc-env={LEVEL}=info");
    }
}

fn has_feature(board: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_BOARD_{}", board.to_uppercase())).is_some()
}

/// Brings the baked scene to where `main.rs` includes it from.
fn scene() -> Result<(), String> {
    println!("cargo::rerun-if-env-changed={SCENE}");
    let path = env::var_os(SCENE).ok_or_else(|| {
        format!("{SCENE} is not set: it must be the path of a scene made by `microbrdf bake`")
    })?;
    let path = Path::new(&path);
    if path.is_relative() {
        return Err(format!(
            "{SCENE} is {}: it must be an absolute path",
            path.display()
        ));
    }
    copy(path, "scene.rs")
}

fn copy(from: &Path, name: &str) -> Result<(), String> {
    println!("cargo::rerun-if-changed={}", from.display());
    fs::copy(from, out_dir().join(name))
        .map(drop)
        .map_err(|error| format!("{}: {error}", from.display()))
}

fn out_dir() -> PathBuf {
    env::var_os("OUT_DIR")
        .map(PathBuf::from)
        .unwrap_or_default()
}
