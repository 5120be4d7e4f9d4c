//! Scene files.

use std::fmt::Write as _;

use crate::bench::{Bench, GOOD, limited, refused};

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
