//! The command under limits, and what it must say.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A scene without a mistake.
pub(crate) const GOOD: &str = r#"[camera]
width = 8
height = 4
eye = [0, -5, 1]
target = [0, 0, 0]
fov = 40
[[light]]
kind = "directional"
direction = [0, -1, 1]
color = 1
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "it"
[material.it]
model = "metallic-phong"
exponent = 20
"#;

/// What a process may map: more than it may ever hold.
const KILOBYTES: u32 = 500_000;
/// Seconds of a core's time that it may take: what else the machine does meanwhile
/// does not count.
const SECONDS: u32 = 1;

/// A scene file, and what it is called with.
pub(crate) struct Bench {
    pub(crate) folder: PathBuf,
}

impl Bench {
    pub(crate) fn new(name: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("microbrdf-hostile-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Self { folder }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The command over a scene, limited by the shell.
    pub(crate) fn run(&self, command: &str, text: &[u8]) -> Output {
        let scene = self.path("bad.toml");
        fs::write(&scene, text).expect("a scene");
        limited(command, &scene, &self.path("out"))
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// A command that writes a file, as [`within_limits`].
pub(crate) fn limited(command: &str, scene: &Path, output: &Path) -> Output {
    let _ = fs::remove_file(output);
    within_limits(&[
        command.as_ref(),
        scene.as_os_str(),
        "-o".as_ref(),
        output.as_os_str(),
    ])
}

/// The program; the system ends it where it takes more than it may.
pub(crate) fn within_limits(arguments: &[&OsStr]) -> Output {
    Command::new("sh")
        .arg("-c")
        .arg(format!(
            "ulimit -v {KILOBYTES}; ulimit -t {SECONDS}; exec \"$@\""
        ))
        .arg("sh")
        .arg(env!("CARGO_BIN_EXE_microbrdf"))
        .args(arguments)
        // Stacks are mapped in full: as many as cores would be counted.
        .env("RAYON_NUM_THREADS", "2")
        .stdin(Stdio::null())
        .output()
        .expect("a shell")
}

/// Asserts that a scene is refused at a place, in words that hold `parts`.
#[track_caller]
pub(crate) fn refused(name: &str, text: impl AsRef<[u8]>, place: &str, parts: &[&str]) {
    let bench = Bench::new(&name.replace(|c: char| !c.is_ascii_alphanumeric(), "-"));
    refused_in(&bench, name, text, place, parts);
}

/// As [`refused`], where other files lie beside the scene.
#[track_caller]
pub(crate) fn refused_in(
    bench: &Bench,
    name: &str,
    text: impl AsRef<[u8]>,
    place: &str,
    parts: &[&str],
) {
    for command in ["render", "bake", "compare"] {
        let output = if command == "compare" {
            within_limits(&[command.as_ref(), bench.path("bad.toml").as_os_str()])
        } else {
            bench.run(command, text.as_ref())
        };
        let said = String::from_utf8_lossy(&output.stderr);
        let short: String = said.chars().take(400).collect();
        assert_eq!(output.status.code(), Some(2), "{name}, {command}: {short}");
        assert!(
            said.len() < 1000,
            "{name}, {command}: {} bytes: {short}",
            said.len()
        );
        assert_eq!(said.lines().count(), 1, "{name}, {command}: {short}");
        // A library that gives up says where itself: the line is given then.
        let there = match place.matches(':').count() {
            1 => format!("bad.toml{place}:"),
            _ => format!("bad.toml{place}: "),
        };
        assert!(
            said.contains(&there),
            "{name}, {command}: {short} lacks {there}"
        );
        for part in parts {
            assert!(
                said.contains(part),
                "{name}, {command}: {short} lacks {part}"
            );
        }
        assert!(!said.contains("panicked"), "{name}, {command}: {short}");
        assert!(
            !bench.path("out").exists(),
            "{name}, {command} wrote a file"
        );
    }
}
