//! OBJ files beside a good scene.

use std::fs;

use crate::bench::{Bench, GOOD, refused_in};

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
