//! Scene files that mean no good: refused with a place and status 2, within a
//! second of a core and 500 MB, and nothing is written.
#![cfg(unix)]

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A scene without a mistake.
const GOOD: &str = r#"[camera]
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
struct Bench {
    folder: PathBuf,
}

impl Bench {
    fn new(name: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("microbrdf-hostile-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The command over a scene, limited by the shell.
    fn run(&self, command: &str, text: &[u8]) -> Output {
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
fn limited(command: &str, scene: &Path, output: &Path) -> Output {
    let _ = fs::remove_file(output);
    within_limits(&[
        command.as_ref(),
        scene.as_os_str(),
        "-o".as_ref(),
        output.as_os_str(),
    ])
}

/// The program; the system ends it where it takes more than it may.
fn within_limits(arguments: &[&OsStr]) -> Output {
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
fn refused(name: &str, text: impl AsRef<[u8]>, place: &str, parts: &[&str]) {
    let bench = Bench::new(&name.replace(|c: char| !c.is_ascii_alphanumeric(), "-"));
    refused_in(&bench, name, text, place, parts);
}

/// As [`refused`], where other files lie beside the scene.
#[track_caller]
fn refused_in(bench: &Bench, name: &str, text: impl AsRef<[u8]>, place: &str, parts: &[&str]) {
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

/// `GOOD` with one of its lines replaced.
fn spoilt(line: usize, by: &str) -> String {
    let mut lines: Vec<_> = GOOD.lines().collect();
    lines[line - 1] = by;
    lines.join("\n")
}

/// Without this, all that follows would show nothing.
#[test]
fn the_good_scene_is_rendered_within_the_limits() {
    let bench = Bench::new("good");
    for command in ["render", "bake"] {
        let output = bench.run(command, GOOD.as_bytes());
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{command}: {said}");
        assert!(bench.path("out").exists());
    }
}

#[test]
fn truncated() {
    refused("empty", "", ":1:1", &["`camera` is missing"]);
    refused(
        "cut",
        &GOOD[..GOOD.len() - 40],
        ":15:11",
        &["`model` is missing"],
    );
    refused(
        "cut string",
        &GOOD[..100],
        ":8:16",
        &["invalid basic string"],
    );
    // Cut behind any line, it is a smaller scene, or is refused at a place.
    for (number, _) in GOOD.match_indices('\n').take(6) {
        let bench = Bench::new("lines");
        let output = bench.run("render", &GOOD.as_bytes()[..number]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 2)), "{said}");
    }
}

#[test]
fn wrong_types() {
    for (line, by, place, parts) in [
        (
            2,
            "width = \"8\"",
            ":2:9",
            &["camera.width", "whole number"][..],
        ),
        (2, "width = [8]", ":2:9", &["an array of 1"]),
        (2, "width = {}", ":2:9", &["a table"]),
        (
            4,
            "eye = true",
            ":4:7",
            &["camera.eye = true", "three numbers"],
        ),
        (4, "eye = [0, [0], 1]", ":4:11", &["camera.eye[2]"]),
        (1, "[[camera]]", ":1:1", &["camera", "a table"]),
        (11, "[sphere]", ":11:1", &["[[sphere]]"]),
        (14, "material = 3", ":14:12", &["a string"]),
        (8, "kind = 1979-05-27", ":8:8", &["1979-05-27", "a string"]),
        (15, "[[material.it]]", ":15:12", &["material.it"]),
    ] {
        refused(by, spoilt(line, by), place, parts);
    }
}

#[test]
fn numbers_that_are_none() {
    for (line, by, place) in [
        (17, "exponent = nan", ":17:12"),
        (17, "exponent = -inf", ":17:12"),
        (17, "exponent = 1e999", ":17:12"),
        (6, "fov = nan", ":6:7"),
        (4, "eye = [0, nan, 1]", ":4:11"),
        (10, "color = +inf", ":10:9"),
        (13, "radius = -nan", ":13:10"),
        (13, "radius = 1e-400", ":13:10"),
    ] {
        refused(by, spoilt(line, by), place, &["must be a number from"]);
    }
}

#[test]
fn huge_sizes() {
    for (line, by, place, part) in [
        (2, "width = 4294967297", ":2:9", "from 1 to 1024"),
        (2, "width = 65536", ":2:9", "from 1 to 1024"),
        (3, "height = 9223372036854775807", ":3:10", "from 1 to 1024"),
        (
            3,
            "height = 0xFFFFFFFFFFFFFFFFFFFF",
            ":3:10",
            "from 1 to 1024",
        ),
        (13, "radius = 1e300", ":13:10", "from 0.001 to 100"),
        (17, "exponent = 1e300", ":17:12", "from 0 to 100000000"),
    ] {
        refused(by, spoilt(line, by), place, &[part]);
    }
    let digits = format!("width = {}", "9".repeat(500_000));
    refused("digits", spoilt(2, &digits), ":2:9", &["from 1 to 1024"]);
    let text = format!("material = \"{}\"", "x".repeat(500_000));
    refused("a long string", spoilt(14, &text), ":14:12", &["`it`"]);
    let key = format!("{} = 1", "k".repeat(500_000));
    refused(
        "a long key",
        format!("{GOOD}{key}"),
        ":18:1",
        &["unknown field `kkk"],
    );
    let long = format!("{GOOD}\n[material.{}]\nmodel = 1", "k".repeat(500_000));
    refused("a long name", long, ":20:9", &["must be a string", "kkk…"]);
    refused(
        "too many bytes",
        vec![b'#'; (1 << 20) + 1],
        "",
        &["at most 1048576"],
    );
    refused("zeros", vec![0; 1 << 20], ":1:1048577", &[]);
}

#[test]
fn many_objects() {
    let spheres = |count| {
        let one = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"it\"\n";
        GOOD.to_owned() + &one.repeat(count)
    };
    refused(
        "10 000 spheres",
        spheres(10_000),
        ":11:1",
        &["10001 [[sphere]]", "at most 255"],
    );
    refused(
        "empty spheres",
        GOOD.to_owned() + &"[[sphere]]\n".repeat(90_000),
        ":11:1",
        &["at most 255"],
    );
    let mut materials = spoilt(14, "material = \"other\"");
    for index in 0..20_000 {
        let _ = writeln!(
            materials,
            "\n[material.m{index}]\nmodel = \"lambert\"\nalbedo = 0"
        );
    }
    refused(
        "20 000 materials",
        materials,
        ":14:12",
        &["\"other\"", "`it`"],
    );
    let mut keys = GOOD.to_owned();
    for index in 0..60_000 {
        let _ = write!(keys, "\nk{index} = 1");
    }
    refused(
        "60 000 keys",
        keys,
        ":19:1",
        &["material.it: unknown field `k0`"],
    );
    let lanes = format!("width = [{}]", "8,".repeat(400_000));
    refused(
        "a long array",
        spoilt(2, &lanes),
        ":2:9",
        &["an array of 400000"],
    );
}

#[test]
fn not_utf8() {
    let mut bytes = GOOD.as_bytes().to_vec();
    bytes[100] = 0xFF;
    refused("0xFF", &bytes, ":8:16", &["is not UTF-8 text"]);
    // UTF-16, and a character cut in two.
    let wide: Vec<u8> = GOOD.encode_utf16().flat_map(u16::to_le_bytes).collect();
    refused(
        "UTF-16",
        [&[0xFF, 0xFE], &wide[..]].concat(),
        ":1:1",
        &["is not UTF-8 text"],
    );
    refused(
        "half a character",
        [GOOD.as_bytes(), &[0xE2, 0x82]].concat(),
        ":18:1",
        &["is not UTF-8"],
    );
}

#[test]
fn deep_nesting() {
    for depth in [100, 10_000, 500_000] {
        let arrays = format!("width = {}", "[".repeat(depth));
        refused(&format!("{depth} arrays"), spoilt(2, &arrays), ":2", &[]);
        let tables = format!("width = {}", "{a=".repeat(depth.min(300_000)));
        refused(&format!("{depth} tables"), spoilt(2, &tables), ":2", &[]);
        let keys = format!("width{} = 1", ".a".repeat(depth.min(450_000)));
        refused(&format!("{depth} keys"), spoilt(2, &keys), ":2", &[]);
        let header = format!("[camera{}]", ".a".repeat(depth.min(450_000)));
        refused(&format!("{depth} headers"), spoilt(15, &header), ":15", &[]);
    }
}

/// What the good scene needs for a mesh; line 20 names its file.
const MESH: &str = "[[mesh]]\nmaterial = \"it\"\nfile = ";
/// A mesh without a mistake.
const TRIANGLE: &str = "v -1 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n";

/// `GOOD` with a mesh of this file in it.
fn with_mesh(file: &str) -> String {
    format!("{GOOD}{MESH}{file:?}\n")
}

#[test]
fn a_good_mesh_is_rendered_within_the_limits() {
    let bench = Bench::new("good mesh");
    // As many triangles as a file may have.
    let vertices = "v -1 0 0\nv 1 0 0\nv 0 0 1\n";
    let all = vertices.to_owned() + &"f 1 2 3\n".repeat(100_000);
    fs::write(bench.path("it.obj"), all).expect("a mesh");
    for command in ["render", "bake"] {
        let output = bench.run(command, with_mesh("it.obj").as_bytes());
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{command}: {said}");
    }
}

/// OBJ files that mean no good: told with the place in the scene, and with
/// file and line of the mesh.
#[test]
fn meshes() {
    let bench = Bench::new("meshes");
    let refused_mesh = |name: &str, obj: &[u8], parts: &[&str]| {
        fs::write(bench.path("it.obj"), obj).expect("a mesh");
        let parts = [&["mesh[1].file: ", "it.obj:"], parts].concat();
        refused_in(&bench, name, with_mesh("it.obj"), ":20:8", &parts);
    };
    let after = |rest: &str| format!("{TRIANGLE}{rest}").into_bytes();
    for (name, obj, parts) in [
        ("an empty mesh", Vec::new(), &["has no face"][..]),
        ("a cut corner", after("f 1 2"), &["line 5", "2 corners"]),
        ("a cut number", after("v 1 2"), &["line 5", "three numbers"]),
        (
            "bad indices",
            after("f 1 2 4"),
            &["line 5", "`4` is no vertex"],
        ),
        (
            "backwards",
            after("f 1 2 -4"),
            &["line 5", "`-4` is no vertex"],
        ),
        (
            "overflow",
            after("f 1 2 99999999999999999999"),
            &["line 5", "is no vertex"],
        ),
        (
            "no such normal",
            after("f 1//1 2//-9223372036854775808 3//1"),
            &["line 5", "is no normal"],
        ),
        ("NaN", after("v nan 0 0"), &["line 5", "`nan` is no number"]),
        (
            "infinite",
            after("v 0 1e400 0"),
            &["line 5", "is no number"],
        ),
        (
            "a line",
            after("v 2 0 0\nf 1 2 4"),
            &["line 6", "on a line"],
        ),
        ("a point", after("f 1 1 1"), &["line 5", "on a line"]),
        (
            "itself",
            after("mtllib it.obj"),
            &["line 5", "the file itself"],
        ),
        (
            "controls",
            after("\u{7}\u{1b}[2J"),
            &["line 5", "no statement"],
        ),
        (
            "too many triangles",
            after(&"f 1 2 3\n".repeat(100_000)),
            &["line 100004", "at most 100000"],
        ),
        (
            "a huge face",
            after(&format!("f{}", " 1 2 3".repeat(500_000))),
            &["line 5", "too many triangles"],
        ),
        (
            "a huge word",
            after(&format!("f 1 2 {}", "9".repeat(3_000_000))),
            &["line 5", "is no vertex"],
        ),
        (
            "too many bytes",
            vec![b'#'; (4 << 20) + 1],
            &["at most 4194304"],
        ),
        ("zeros", vec![0; 4 << 20], &["no statement"]),
        (
            "not UTF-8",
            [TRIANGLE.as_bytes(), &[0xFF]].concat(),
            &["it.obj:5:1: is not UTF-8"],
        ),
    ] {
        refused_mesh(name, &obj, parts);
    }
    // Each triangle covers the picture, which is as large as one may be.
    let wide = with_mesh("it.obj").replace("width = 8", "width = 1024");
    let wide = wide.replace("height = 4", "height = 1024");
    let large = "v -9 0 -9\nv 9 0 -9\nv 0 0 19\n".to_owned() + &"f 1 2 3\n".repeat(90_000);
    fs::write(bench.path("it.obj"), large).expect("a mesh");
    refused_in(&bench, "covering", wide, ":18:1", &["mesh: ", "pixels"]);
}

#[test]
fn meshes_that_can_not_be_read() {
    let bench = Bench::new("no mesh");
    fs::create_dir_all(bench.path("folder.obj")).expect("a folder");
    for (file, parts) in [
        ("missing.obj", &["missing.obj: can't be read"][..]),
        ("folder.obj", &["folder.obj: is not a file"]),
        (
            "bad.toml",
            &["bad.toml: line 1: `[camera]` is no statement"],
        ),
        ("/dev/zero", &["/dev/zero: is not a file"]),
        ("", &["mesh[1].file"]),
    ] {
        refused_in(&bench, file, with_mesh(file), ":20:8", parts);
    }
}

/// What is no file at all.
#[test]
fn what_can_not_be_read() {
    let bench = Bench::new("none");
    for scene in [
        bench.path("missing.toml"),
        bench.folder.clone(),
        "/dev/zero".into(),
    ] {
        let output = limited("render", &scene, &bench.path("out"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(&scene.display().to_string()), "{said}");
    }
}
