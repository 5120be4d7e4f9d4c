//! `microbrdf render` and `compare`: whole files or none, and the report.

mod support;

use std::fs;
use std::path::Path;

use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::picture::Picture;
use microbrdf_sim::{reference_picture, render};
use serde_json::Value;
use support::{Folder, Ran, SCENE, run};

fn description() -> Description {
    Description::from_toml("scene.toml", "scene", SCENE).expect("the scene")
}

fn host(arithmetic: ArithmeticName) -> Picture {
    render::frame(&description(), arithmetic)
        .expect("a frame")
        .srgb()
}

fn picture(path: &str) -> Picture {
    Picture::read_png(Path::new(path)).expect("a whole PNG")
}

#[test]
fn a_picture_is_what_the_library_shades() {
    let folder = Folder::new("a_picture_is_what_the_library_shades");
    let scene = folder.file("scene.toml", SCENE);
    for (arithmetic, expected) in [
        ("f32", host(ArithmeticName::F32)),
        ("q31", host(ArithmeticName::Q31)),
        (
            "reference",
            reference_picture::render(&description()).srgb(),
        ),
    ] {
        let png = folder.path("picture.png");
        let said = run(&["render", &scene, "--arithmetic", arithmetic, "-o", &png]).output();
        assert_eq!(said, "");
        let found = picture(&png);
        assert_eq!((found.width, found.height), (32, 16));
        assert!(found == expected, "{arithmetic}");
        assert!(found.pixels.iter().any(|pixel| pixel[0] > 100));
        // Nothing else is left lying about.
        assert_eq!(folder.names(), ["picture.png", "scene.toml"]);
    }
}

/// An older picture is replaced as a whole, or kept as it is.
#[test]
fn nothing_is_half_written() {
    let folder = Folder::new("nothing_is_half_written");
    let scene = folder.file("scene.toml", SCENE);
    let bad = folder.file("bad.toml", SCENE.replace("width = 32", "width = 0"));
    let png = folder.file("picture.png", "an older picture");
    let error: Ran = run(&["render", &bad, "-o", &png]);
    error.mistake(&[
        &format!("{bad}:4:9: camera.width = 0"),
        "a whole number from 1 to 1024",
    ]);
    assert_eq!(
        fs::read_to_string(&png).expect("the older one"),
        "an older picture"
    );
    run(&["render", &folder.path("missing.toml"), "-o", &png])
        .mistake(&["missing.toml", "can't be read"]);
    run(&["render", &scene, "-o", &folder.path("no/such/folder.png")])
        .mistake(&["no/such/folder.png"]);
    run(&["render", &scene, "-o", &folder.path("")]).mistake(&[]);
    run(&["render", &scene, "--arithmetic", "q99", "-o", &png]).mistake(&["q99", "q31"]);
    run(&["render", &scene]).mistake(&["--output"]);
    run(&[
        "render",
        &scene,
        "--arithmetic",
        "reference",
        "--panel",
        &png,
    ])
    .mistake(&["--panel"]);
    assert_eq!(folder.names(), ["bad.toml", "picture.png", "scene.toml"]);
    assert_eq!(
        fs::read_to_string(&png).expect("the older one"),
        "an older picture"
    );
    run(&["render", &scene, "-o", &png]).output();
    assert_eq!(picture(&png).pixels.len(), 512);
}

#[test]
fn bad_scenes_end_with_status_two() {
    let folder = Folder::new("bad_scenes_end_with_status_two");
    let png = folder.path("picture.png");
    for (name, content, parts) in [
        (
            "model.toml",
            SCENE
                .replace("\"metallic-phong\"", "\"metalic-phong\"")
                .into_bytes(),
            vec![
                "material.steel.model = \"metalic-phong\"",
                "`metallic-phong`",
            ],
        ),
        (
            "nan.toml",
            SCENE
                .replace("exponent = 12", "exponent = nan")
                .into_bytes(),
            vec!["material.steel.exponent = nan", "from 0 to 100000000"],
        ),
        (
            "fraction.toml",
            SCENE
                .replace("exponent = 12", "exponent = 0.5")
                .into_bytes(),
            vec!["material.steel", "exponent", "from 1 to 1e8"],
        ),
        (
            "bytes.toml",
            [SCENE.as_bytes(), b"\xC3\x28"].concat(),
            vec!["not UTF-8"],
        ),
        ("empty.toml", Vec::new(), vec!["`camera` is missing"]),
    ] {
        let scene = folder.file(name, content);
        for arguments in [
            vec!["render", &scene, "-o", &png],
            vec!["compare", &scene, "--arithmetic", "q31"],
            vec!["bake", &scene, "-o", &png],
        ] {
            let ran = run(&arguments);
            assert!(ran.stdout.is_empty(), "{ran:?}");
            assert!(ran.stderr.starts_with("microbrdf: "), "{ran:?}");
            assert!(
                ran.stderr.contains(name) || name == "fraction.toml",
                "{ran:?}"
            );
            ran.mistake(&parts);
        }
        assert!(!Path::new(&png).exists(), "{name}");
    }
}

const FIGURES: [&str; 7] = [
    "lsb_error_max",
    "code_error_max",
    "code_error_share",
    "code_error_over_one_share",
    "class_flips",
    "delta_e_p95",
    "delta_e_max",
];

#[track_caller]
fn check_figures(report: &Value, arithmetic: &str) {
    assert_eq!(report["arithmetic"], arithmetic);
    assert_eq!(report["exposure"], 0.6);
    for figure in FIGURES {
        let value = report[figure].as_f64().expect(figure);
        assert!(value >= 0.0 && value.is_finite(), "{figure}: {value}");
    }
    assert!(report["lsb_error_max"].as_f64().expect("a number") < 1.0);
    for share in ["code_error_share", "code_error_over_one_share"] {
        assert!(report[share].as_f64().expect("a number") <= 1.0);
    }
}

#[test]
fn a_report_of_one_arithmetic_is_an_object_of_several_a_list() {
    let folder = Folder::new("a_report_of_one_arithmetic");
    let scene = folder.file("scene.toml", SCENE);
    let json = |arguments: &[&str]| -> Value {
        let mut all = vec!["compare", &scene, "--json"];
        all.extend(arguments);
        serde_json::from_str(&run(&all).output()).expect("JSON")
    };
    let one = json(&["--arithmetic", "q31"]);
    check_figures(&one, "q31");
    assert!(one.get("device_equals_host").is_none());
    let both = json(&["--arithmetic", "f32,q31"]);
    let list = both.as_array().expect("a list");
    assert_eq!(list.len(), 2);
    check_figures(&list[0], "f32");
    assert_eq!(list[1], one);
}

#[test]
fn a_devices_picture_is_compared_with_the_hosts() {
    let folder = Folder::new("a_devices_picture");
    let scene = folder.file("scene.toml", SCENE);
    let (png, out) = (folder.path("device.png"), folder.path("out"));
    run(&["render", &scene, "--arithmetic", "q31", "-o", &png]).output();
    let compare = |status: i32| -> Value {
        let ran = run(&[
            "compare",
            &scene,
            "--arithmetic",
            "q31",
            "--device",
            &png,
            "--out",
            &out,
            "--json",
        ]);
        assert_eq!(ran.status, status, "{ran:?}");
        assert_eq!(
            ran.stderr.contains("device.png: differs"),
            status == 1,
            "{ran:?}"
        );
        serde_json::from_str(&ran.stdout).expect("JSON")
    };
    assert_eq!(compare(0)["device_equals_host"], true);
    assert_eq!(picture(&format!("{out}/host.png")), picture(&png));
    for name in ["host.png", "reference.png", "error.png"] {
        assert_eq!(picture(&format!("{out}/{name}")).pixels.len(), 512);
    }
    // One bit of one pixel.
    let mut changed = picture(&png);
    changed.pixels[300][1] ^= 1;
    changed.write_png(Path::new(&png)).expect("a picture");
    assert_eq!(compare(1)["device_equals_host"], false);

    let small = Picture {
        width: 16,
        height: 32,
        ..changed
    };
    small.write_png(Path::new(&png)).expect("a picture");
    run(&["compare", &scene, "--arithmetic", "q31", "--device", &png])
        .mistake(&["--device", "16 x 32", "32 x 16"]);
    run(&["compare", &scene, "--device", &png]).mistake(&["--device", "one --arithmetic"]);
    let text = folder.file("device.txt", "no picture");
    run(&["compare", &scene, "--arithmetic", "q31", "--device", &text]).mistake(&["device.txt"]);
}

#[test]
fn help_has_an_example_for_every_command() {
    let top = run(&["--help"]).output();
    assert!(top.contains("Example: microbrdf "), "{top}");
    for command in ["render", "compare", "eval", "albedo", "device", "bake"] {
        assert!(top.contains(command), "{top}");
        let help = run(&[command, "--help"]).output();
        assert!(help.contains("Example: "), "{help}");
    }
    assert_eq!(run(&[]).status, 2);
    run(&["paint"]).mistake(&["paint"]);
}

/// What is no file is written to, and a link stays one.
#[cfg(unix)]
#[test]
fn only_files_are_replaced() {
    use std::os::unix::fs::{FileTypeExt as _, symlink};

    let folder = Folder::new("only_files_are_replaced");
    let scene = folder.file("scene.toml", SCENE);
    let is_device = || {
        fs::metadata("/dev/null")
            .expect("a device")
            .file_type()
            .is_char_device()
    };
    if is_device() {
        run(&["render", &scene, "-o", "/dev/null"]).output();
        assert!(is_device());
    }
    let (target, link) = (folder.path("target.png"), folder.path("link.png"));
    fs::write(&target, "what was there").expect("a file");
    symlink(&target, &link).expect("a link");
    run(&["render", &scene, "-o", &link]).output();
    assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
    assert_eq!(picture(&target).pixels.len(), 512);
}

/// Nobody reads on: told, not a panic.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_told() {
    let folder = Folder::new("a_full_standard_output");
    let scene = folder.file("scene.toml", SCENE);
    for arguments in [
        &["compare", &scene][..],
        &["compare", &scene, "--json"],
        &[
            "albedo",
            "--material",
            "model = \"lambert\", albedo = 1",
            "--angles",
            "0",
        ],
    ] {
        let full = fs::File::options().write(true).open("/dev/full");
        let output = support::command(arguments)
            .stdout(full.expect("a device"))
            .output()
            .expect("the command");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("standard output: "), "{said}");
    }
}
