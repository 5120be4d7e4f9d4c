//! The distribution's Rust packages: which compiler is installed, and which packages would bring one.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::oldest;
use crate::command::{Runner, on_path};

/// A set of packages that bring a compiler, its source and its lints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Family {
    /// Compiler, cargo and the source of `core`.
    pub packages: [&'static str; 3],
    /// Clippy for this compiler, which only `cargo xtask test` needs.
    pub clippy: &'static str,
}

/// Families in order of preference. Debian keeps the `-web` ones new enough in its stable releases.
pub const FAMILIES: [Family; 2] = [
    Family {
        packages: ["rustc-web", "cargo-web", "rust-web-src"],
        clippy: "rust-web-clippy",
    },
    Family {
        packages: ["rustc", "cargo", "rust-src"],
        clippy: "rust-clippy",
    },
];

/// Package with the linker.
pub const LINKER: &str = "lld";

/// The distribution's compiler, complete with the source of `core` and a linker.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Compiler {
    /// `rustc`.
    pub rustc: PathBuf,
    /// What `rustc --version` says.
    pub version: String,
    /// `ld.lld`.
    pub linker: PathBuf,
}

impl Compiler {
    /// Cargo of this compiler. Whatever points at another toolchain is taken out of its environment.
    pub fn cargo(&self, subcommand: &str) -> Command {
        let folder = self.rustc.parent().unwrap_or(Path::new("/usr/bin"));
        // Cargo would look for `cargo clippy` among rustup's programs first, so that one is started by its own name.
        let program = if subcommand == "clippy" {
            "cargo-clippy"
        } else {
            "cargo"
        };
        let mut command = Command::new(folder.join(program));
        for name in ["RUSTUP_TOOLCHAIN", "LD_LIBRARY_PATH", "RUSTFLAGS"] {
            command.env_remove(name);
        }
        let mut path = vec![folder.to_path_buf()];
        path.extend(std::env::split_paths(
            &std::env::var_os("PATH").unwrap_or_default(),
        ));
        if let Ok(path) = std::env::join_paths(path) {
            command.env("PATH", path);
        }
        command
            .env("CARGO", folder.join("cargo"))
            .env("RUSTC", &self.rustc)
            .arg(subcommand);
        command
    }
}

/// Where distributions put the compiler.
const RUSTC: &str = "/usr/bin/rustc";

/// The distribution's compiler, if it is installed with everything that is needed and new enough.
pub fn installed(runner: &dyn Runner, clippy: bool) -> Option<Compiler> {
    let rustc = Path::new(RUSTC);
    let beside = |name: &str| rustc.with_file_name(name).is_file();
    if !rustc.is_file() || !beside("cargo") || (clippy && !beside("cargo-clippy")) {
        return None;
    }
    let linker = on_path("ld.lld")?;
    let sysroot = runner
        .capture(&[RUSTC, "--print", "sysroot"])
        .filter(|run| run.success)?;
    let source = Path::new(sysroot.stdout.trim()).join("lib/rustlib/src/rust/library/core");
    if !source.is_dir() {
        return None;
    }
    let version = runner
        .capture(&[RUSTC, "--version"])?
        .stdout
        .trim()
        .to_string();
    (release(version.strip_prefix("rustc ")?)? >= oldest()).then(|| Compiler {
        rustc: rustc.to_path_buf(),
        version,
        linker,
    })
}

/// Major and minor number that a version begins with, as in `1.96.0+dfsg1-1~deb12u2`.
pub fn release(version: &str) -> Option<(u32, u32)> {
    let mut numbers = version.split(|c: char| !c.is_ascii_digit());
    Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn release_of_package_versions() {
        assert_eq!(release("1.96.0+dfsg1-1~deb12u2"), Some((1, 96)));
        assert_eq!(release("1.85.0 (4d91de4e4 2025-02-17)"), Some((1, 85)));
        assert_eq!(release("(none)"), None);
        assert_eq!(release(""), None);
    }
}
