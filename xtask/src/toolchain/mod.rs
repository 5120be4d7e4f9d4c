//! The cross compiler, found in one of two ways.
//!
//! 1. **The active toolchain**, where `core` for the boards' targets is installed beside it: what `rustup target add` does.
//! 2. **The distribution's compiler**, with `core` built once from the distribution's source package into a cached sysroot: for machines that rustup's servers can't be reached from.
//!
//! Whichever is complete is taken, the active toolchain first. Where neither is, setup tries rustup, then the distribution.

pub mod active;
pub mod distribution;
pub mod sysroot;

use std::env;
use std::path::PathBuf;
use std::process::Command;

use crate::command::Runner;
use crate::failure::{Failure, Outcome};
use crate::layout::Layout;

/// Oldest compiler that builds the firmware and the tools, major and minor number: `rust-version` of this crate.
pub fn oldest() -> (u32, u32) {
    distribution::release(env!("CARGO_PKG_RUST_VERSION")).unwrap_or((u32::MAX, 0))
}

/// The same, as one writes it.
pub fn oldest_words() -> String {
    let (major, minor) = oldest();
    format!("{major}.{minor}")
}

/// One of the two ways.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// The active toolchain with targets added.
    Active,
    /// The distribution's compiler with `core` from source.
    Distribution,
}

/// The way that `MICROBRDF_TOOLCHAIN` asks for: `rustup`, `distribution`, or (unset, `auto`) whichever there is.
pub fn asked_for() -> Outcome<Option<Way>> {
    match env::var("MICROBRDF_TOOLCHAIN").as_deref() {
        Err(_) | Ok("" | "auto") => Ok(None),
        Ok("rustup") => Ok(Some(Way::Active)),
        Ok("distribution") => Ok(Some(Way::Distribution)),
        Ok(other) => Err(Failure::mistake(format!(
            "MICROBRDF_TOOLCHAIN={other}: must be auto, rustup or distribution"
        ))),
    }
}

/// A compiler that can build for the boards.
#[derive(Debug, Clone)]
pub enum Cross {
    /// The active toolchain; the string is what `rustc --version` says.
    Active {
        /// What `rustc --version` says.
        version: String,
    },
    /// The distribution's compiler.
    Distribution {
        /// Programs and version.
        compiler: distribution::Compiler,
        /// Folder with `core` for each target.
        sysroot: PathBuf,
    },
}

impl Cross {
    /// What `rustc --version` says, for reports.
    pub fn version(&self) -> &str {
        match self {
            Self::Active { version } => version,
            Self::Distribution { compiler, .. } => &compiler.version,
        }
    }

    /// One line for the user: which way was chosen.
    pub fn chosen(&self, layout: &Layout) -> String {
        match self {
            Self::Active { version } => {
                format!("cross compiler: the active toolchain, {version}, with its own targets")
            }
            Self::Distribution { compiler, sysroot } => format!(
                "cross compiler: the distribution's {} ({}), with core built from source in {}",
                compiler.rustc.display(),
                compiler.version,
                layout.shown(sysroot)
            ),
        }
    }

    /// `cargo SUBCOMMAND --target TARGET`, in the workspace, with the cross compiler's own build folder.
    pub fn cargo(&self, layout: &Layout, subcommand: &str, target: &str) -> Command {
        let mut command = match self {
            Self::Active { .. } => {
                let mut command = crate::command::host_cargo(layout.root());
                command.arg(subcommand);
                command
            }
            Self::Distribution { compiler, sysroot } => {
                let mut command = compiler.cargo(subcommand);
                let mut linker = format!("CARGO_TARGET_{target}_LINKER").replace('-', "_");
                linker.make_ascii_uppercase();
                command.env(linker, &compiler.linker);
                command.env(
                    "CARGO_ENCODED_RUSTFLAGS",
                    format!("--sysroot\x1f{}", sysroot.display()),
                );
                command.current_dir(layout.root());
                command
            }
        };
        command
            .env("CARGO_TARGET_DIR", layout.cross_target())
            .args(["--target", target]);
        command
    }
}

/// The cross compiler that is there already and complete for these targets, if any; installs and builds nothing.
pub fn ready(
    layout: &Layout,
    runner: &dyn Runner,
    targets: &[&str],
    clippy: bool,
) -> Outcome<Option<Cross>> {
    let asked = asked_for()?;
    if asked != Some(Way::Distribution) {
        if let Some(cross) = active::ready(runner, targets) {
            return Ok(Some(cross));
        }
    }
    if asked != Some(Way::Active) {
        if let Some(compiler) = distribution::installed(runner, clippy) {
            let sysroot = sysroot::folder(layout, &compiler);
            if targets
                .iter()
                .all(|target| sysroot::holds(&sysroot, target))
            {
                return Ok(Some(Cross::Distribution { compiler, sysroot }));
            }
        }
    }
    Ok(None)
}
