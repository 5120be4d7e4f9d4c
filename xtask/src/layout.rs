//! Where things lie: everything that the commands make goes under `target/`.

use std::env;
use std::path::{Path, PathBuf};

use crate::failure::{Failure, Outcome};

/// The repository's folders.
#[derive(Debug, Clone)]
pub struct Layout {
    root: PathBuf,
}

impl Layout {
    /// The workspace that xtask was started in: cargo says where, else the nearest `Cargo.toml` with a `[workspace]` upwards.
    pub fn find() -> Outcome<Self> {
        let start = match env::var_os("CARGO_MANIFEST_DIR") {
            Some(dir) => PathBuf::from(dir),
            None => env::current_dir()
                .map_err(|e| Failure::incomplete(format!("cannot tell the current folder: {e}")))?,
        };
        start
            .ancestors()
            .find(|dir| {
                std::fs::read_to_string(dir.join("Cargo.toml"))
                    .is_ok_and(|text| text.lines().any(|line| line.trim() == "[workspace]"))
            })
            .map(|root| Self {
                root: root.to_path_buf(),
            })
            .ok_or_else(|| {
                Failure::mistake(format!("no workspace at or above {}", start.display()))
            })
    }

    /// Top of the repository.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// A path below the top of the repository.
    pub fn at(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// Everything made, and nothing else.
    pub fn target(&self) -> PathBuf {
        self.root.join("target")
    }

    /// Build folder of the cross compiler, apart from the host's so that neither empties the other's cache.
    pub fn cross_target(&self) -> PathBuf {
        self.target().join("cross")
    }

    /// Held from the begin of a cross build until what it made is copied: builds of one package with different scenes write the same file.
    pub fn cross_lock(&self) -> PathBuf {
        self.cross_target().join("xtask.lock")
    }

    /// Virtual environment with the receiver.
    pub fn venv(&self) -> PathBuf {
        self.target().join("venv")
    }

    /// A program of the virtual environment.
    pub fn venv_program(&self, name: &str) -> PathBuf {
        let folder = if cfg!(windows) { "Scripts" } else { "bin" };
        self.venv()
            .join(folder)
            .join(format!("{name}{}", env::consts::EXE_SUFFIX))
    }

    /// Packages of npm.
    pub fn node(&self) -> PathBuf {
        self.target().join("node")
    }

    /// Tools built from crates.io for `cargo xtask test`.
    pub fn tools(&self) -> PathBuf {
        self.target().join("tools")
    }

    /// A path as shown to the user: relative to the top of the repository where it lies below it.
    pub fn shown(&self, path: &Path) -> String {
        path.strip_prefix(&self.root)
            .unwrap_or(path)
            .display()
            .to_string()
    }
}
