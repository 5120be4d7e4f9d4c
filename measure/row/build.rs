//! Brings the baked scene to where the library includes it from.

use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

/// Path of the file that `microbrdf bake` wrote, as firmware takes it.
const SCENE: &str = "MICROBRDF_SCENE_RS";

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={SCENE}");
    if env::var("CARGO_CFG_TARGET_OS").as_deref() != Ok("none") {
        return ExitCode::SUCCESS; // the host has no scene
    }
    let Some(scene) = env::var_os(SCENE).map(PathBuf::from) else {
        println!("cargo::error={SCENE} is not set: `cargo xtask forecast` sets it");
        return ExitCode::FAILURE;
    };
    println!("cargo::rerun-if-changed={}", scene.display());
    let folder = env::var_os("OUT_DIR")
        .map(PathBuf::from)
        .unwrap_or_default();
    if let Err(error) = fs::copy(&scene, folder.join("scene.rs")) {
        println!("cargo::error={}: {error}", scene.display());
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
