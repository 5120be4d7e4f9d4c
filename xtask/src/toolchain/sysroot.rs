//! `core` built once from the distribution's source, kept in a folder that the compiler takes as its sysroot.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use super::distribution::Compiler;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// The sysroot of this compiler: another version gets another folder.
pub fn folder(layout: &Layout, compiler: &Compiler) -> PathBuf {
    let name: String = compiler
        .version
        .split_whitespace()
        .skip(1)
        .take(2)
        .collect::<Vec<_>>()
        .join("-")
        .replace(['(', ')'], "");
    layout.target().join("sysroot").join(name)
}

/// Whether a sysroot holds `core` for a target.
pub fn holds(sysroot: &Path, target: &str) -> bool {
    fs::read_dir(libraries(sysroot, target)).is_ok_and(|entries| {
        entries.flatten().any(|entry| {
            let name = entry.file_name();
            let name = name.to_string_lossy();
            name.starts_with("libcore-") && name.ends_with(".rlib")
        })
    })
}

/// Where the libraries of a target lie in a sysroot.
fn libraries(sysroot: &Path, target: &str) -> PathBuf {
    sysroot.join("lib/rustlib").join(target).join("lib")
}

/// Builds `core` for some targets at once. Interrupted, it leaves nothing that `holds` would take for whole.
pub fn build(layout: &Layout, compiler: &Compiler, targets: &[&str]) -> Outcome<()> {
    let scratch = layout.target().join("sysroot").join("build");
    empty_crate(&scratch)?;
    eprintln!(
        "building core for {} from the distribution's source (once)",
        targets.join(", ")
    );
    let mut cargo = compiler.cargo("build");
    for target in targets {
        cargo.args(["--target", target]);
    }
    let output = cargo
        .args(["--release", "--quiet"])
        .args(["-Z", "build-std=core"])
        .args(["-Z", "build-std-features=compiler-builtins-mem"])
        .current_dir(&scratch)
        // The released compiler builds its own library only when told that it may.
        .env("RUSTC_BOOTSTRAP", "1")
        // Without bitcode, link-time optimisation of the firmware fails.
        .env("CARGO_ENCODED_RUSTFLAGS", "-Cembed-bitcode=yes")
        .env("CARGO_TARGET_DIR", scratch.join("target"))
        .stdin(Stdio::null())
        .output()
        .during(|| format!("starting cargo beside {}", compiler.rustc.display()))?;
    if !output.status.success() {
        return Err(Failure::lacking(format!(
            "core could not be built with {} (at least Rust {} and its source package are needed):\n{}",
            compiler.version,
            super::oldest_words(),
            String::from_utf8_lossy(&output.stderr)
        )));
    }
    for target in targets {
        let made = scratch.join("target").join(target).join("release/deps");
        keep(&made, &libraries(&folder(layout, compiler), target))?;
    }
    let _ = fs::remove_dir_all(&scratch);
    Ok(())
}

/// A crate with nothing in it, built only for what cargo builds before it.
fn empty_crate(folder: &Path) -> Outcome<()> {
    fs::create_dir_all(folder).during(|| format!("creating {}", folder.display()))?;
    for (name, text) in [
        ("lib.rs", "#![no_std]\n"),
        (
            "Cargo.toml",
            "[package]\nname = \"sysroot\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\
             [lib]\npath = \"lib.rs\"\n[workspace]\n",
        ),
    ] {
        let path = folder.join(name);
        fs::write(&path, text).during(|| format!("writing {}", path.display()))?;
    }
    Ok(())
}

/// Copies the libraries out of a build; the folder appears only once it is whole.
fn keep(made: &Path, folder: &Path) -> Outcome<()> {
    let partial = folder.with_file_name("partial");
    let _ = fs::remove_dir_all(&partial);
    fs::create_dir_all(&partial).during(|| format!("creating {}", partial.display()))?;
    for entry in fs::read_dir(made).during(|| format!("reading {}", made.display()))? {
        let entry = entry.during(|| format!("reading {}", made.display()))?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".rlib") && !name.starts_with("libsysroot-") {
            fs::copy(entry.path(), partial.join(&name)).during(|| format!("copying {name}"))?;
        }
    }
    let _ = fs::remove_dir_all(folder);
    fs::rename(&partial, folder).during(|| format!("moving to {}", folder.display()))
}
