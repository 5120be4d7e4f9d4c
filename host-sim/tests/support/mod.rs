//! Runs the command as a person would.
#![allow(
    dead_code,
    reason = "every file of tests takes what it needs of this one"
)]

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// A small scene: one sphere, one light, a sky.
pub const SCENE: &str = r#"exposure = 0.6
background = 0.05
[camera]
width = 32
height = 16
eye = [0.0, -6.0, 0.5]
target = [0.0, 0.0, 0.0]
fov = 30.0
[daylight]
color = 0.2
[[light]]
kind = "directional"
direction = [-0.4, -0.8, 0.9]
color = [2.0, 1.8, 1.5]
[[sphere]]
center = [0.0, 0.0, 0.0]
radius = 1.3
material = "steel"
[material.steel]
model = "metallic-phong"
exponent = 12
"#;

/// How a command ended, and what it said.
#[derive(Debug)]
pub struct Ran {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

impl Ran {
    /// Standard output, if all went well and nothing was complained of.
    #[track_caller]
    pub fn output(self) -> String {
        assert_eq!((self.status, self.stderr.as_str()), (0, ""), "{self:?}");
        self.stdout
    }

    /// Asserts a mistake of the user's, told in one line that holds `parts`.
    #[track_caller]
    pub fn mistake(self, parts: &[&str]) {
        assert_eq!(self.status, 2, "{self:?}");
        for part in parts {
            assert!(self.stderr.contains(part), "no {part:?} in {self:?}");
        }
        for word in ["panicked", "backtrace", "RUST_"] {
            assert!(!self.stderr.contains(word), "{self:?}");
        }
    }
}

/// The command, not yet run.
pub fn command<S: AsRef<std::ffi::OsStr>>(arguments: &[S]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_microbrdf"));
    command
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// Runs it with bytes on standard input.
pub fn run_with(arguments: &[&str], input: &[u8]) -> Ran {
    let mut child = command(arguments).spawn().expect("the command starts");
    // It may stop at a mistake before it has read all.
    let _ = child.stdin.take().expect("piped").write_all(input);
    let output = child.wait_with_output().expect("the command ends");
    Ran {
        status: output.status.code().expect("no signal ended it"),
        stdout: String::from_utf8(output.stdout).expect("UTF-8"),
        stderr: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

/// Runs it with nothing on standard input.
pub fn run(arguments: &[&str]) -> Ran {
    run_with(arguments, b"")
}

/// A command that is running; ended when this goes out of scope.
pub struct Running(pub Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// An empty folder of one test.
pub struct Folder(PathBuf);

impl Folder {
    /// Named after the test.
    pub fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    /// Path of a file in it.
    pub fn path(&self, name: &str) -> String {
        self.0
            .join(name)
            .to_str()
            .expect("a path in UTF-8")
            .to_owned()
    }

    /// Writes a file and gives its path.
    pub fn file(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        let path = self.path(name);
        fs::write(&path, content).expect("a file");
        path
    }

    /// Names of all that lies in it, in order.
    pub fn names(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(&self.0)
            .expect("the folder")
            .map(|entry| {
                entry
                    .expect("an entry")
                    .file_name()
                    .into_string()
                    .expect("UTF-8")
            })
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            let _ = fs::remove_dir_all(&self.0);
        }
    }
}
