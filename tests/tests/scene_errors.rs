//! Mistakes in scene and material files: the message names file, line and
//! column, field, value and what is accepted.

use std::fs;

use microbrdf_scene::{Description, Material, SceneError};

/// A scene in which every kind of table stands.
const GOOD: &str = r#"name = "good"
exposure = 0.5
background = [0.1, 0.1, 0.1]

[camera]
width = 64
height = 48
eye = [0.0, -9.0, 1.0]
target = [0.0, 0.0, 0.0]
fov = 24.0

[daylight]
color = 0.3

[[light]]
kind = "directional"
direction = [0.0, -1.0, 1.0]
color = [1.0, 0.9, 0.8]

[[sphere]]
center = [0.0, 0.0, 0.0]
radius = 1.0
material = "steel"

[[plane]]
point = [0.0, 0.0, -1.0]
normal = [0.0, 0.0, 1.0]
material = "floor"

[material.steel]
model = "metallic-phong"
exponent = 40

[material.floor]
model = "plastic"
albedo = [0.5, 0.5, 0.4]
specular = 0.2
exponent = 12

[material.gold]
model = "metal"
eta = [0.2, 0.4, 1.4]
k = [3.0, 2.5, 1.9]
exponent = 60

[material.disc]
model = "patch"
radius = 0.5

[material.soft]
model = "patch-exponential"
sharpness = 5.0
"#;

fn read(text: &str) -> Result<Description, SceneError> {
    Description::from_toml("folder/bad.toml", "bad", text)
}

/// Line and column, from 1, of the only place where `token` stands.
fn place(text: &str, token: &str) -> (usize, usize) {
    assert_eq!(text.matches(token).count(), 1, "{token} stands elsewhere");
    let offset = text.find(token).expect("counted");
    let line_start = text[..offset].rfind('\n').map_or(0, |end| end + 1);
    (
        text[..offset].matches('\n').count() + 1,
        text[line_start..offset].chars().count() + 1,
    )
}

/// Asserts that `GOOD` with `from` replaced by `to` is refused at `token`,
/// in a message that holds all of `parts`.
#[track_caller]
fn refused(from: &str, to: &str, token: &str, parts: &[&str]) {
    assert_eq!(GOOD.matches(from).count(), 1, "{from:?} is not there once");
    let text = GOOD.replace(from, to);
    let error = read(&text).expect_err(to);
    let (line, column) = place(&text, token);
    let message = error.to_string();
    assert_eq!(error.place, Some((line, column)), "{message}");
    let start = format!("folder/bad.toml:{line}:{column}: ");
    assert!(message.starts_with(&start), "{message} for {start}");
    assert!(!message.contains('\n'), "{message}");
    for part in parts {
        assert!(message.contains(part), "{message:?} lacks {part:?}");
    }
}

#[test]
fn the_good_one_is_read() {
    let scene = read(GOOD).expect("no mistake");
    assert_eq!(scene.name, "good");
    assert_eq!(scene.materials.len(), 2);
    assert_eq!(
        scene.spheres.len() + scene.planes.len() + scene.lights.len(),
        3
    );
}

#[test]
fn models() {
    refused(
        "\"metallic-phong\"",
        "\"metalic-phong\"",
        "\"metalic-phong\"",
        &[
            "material.steel.model = \"metalic-phong\"",
            "`metallic-phong`",
            "`plastic`",
        ],
    );
    refused(
        "model = \"patch\"",
        "model = 7",
        "7\nradius",
        &["material.disc.model = 7", "must be a string"],
    );
    refused(
        "model = \"patch\"\n",
        "",
        "disc]",
        &["material.disc", "the field `model` is missing"],
    );
}

#[test]
fn fields() {
    refused(
        "exponent = 40",
        "exponent = 40\nenergie = \"strict\"",
        "energie",
        &[
            "material.steel",
            "unknown field `energie`",
            "did you mean `energy`?",
        ],
    );
    refused(
        "width = 64",
        "width = 64\nzoom = 2",
        "zoom",
        &["camera", "unknown field `zoom`", "`fov`"],
    );
    refused(
        "exposure = 0.5",
        "exposures = 0.5",
        "exposures",
        &["`exposures`", "`exposure`?"],
    );
    refused(
        "radius = 1.0",
        "radius = 1.0\nradius = 2.0",
        "radius = 2.0",
        &["duplicate key"],
    );
}

/// A field that must be there is no less misspelt for it.
#[test]
fn misspelt_fields_that_are_required() {
    for (from, to, table, field) in [
        ("radius = 0.5", "radus = 0.5", "material.disc", "radius"),
        (
            "sharpness = 5.0",
            "sharpnes = 5.0",
            "material.soft",
            "sharpness",
        ),
        ("width = 64", "widht = 64", "camera", "width"),
    ] {
        let misspelt = to.split(' ').next().expect("a key");
        refused(
            from,
            to,
            to,
            &[
                table,
                &format!("unknown field `{misspelt}`"),
                &format!("did you mean `{field}`?"),
            ],
        );
    }
    refused("[camera]", "[kamera]", "kamera]", &["`kamera`", "`camera`"]);
}

/// A field that is not there, nor anything like it.
#[test]
fn missing_fields() {
    for (line, name, table, field) in [
        ("radius = 0.5\n", "disc]", "material.disc", "radius"),
        ("width = 64\n", "[camera]", "camera", "width"),
        ("color = 0.3\n", "[daylight]", "daylight", "color"),
    ] {
        refused(
            line,
            "",
            name,
            &[table, &format!("the field `{field}` is missing")],
        );
    }
}

#[test]
fn numbers_out_of_range() {
    for (value, shown) in [
        ("nan", "nan"),
        ("-nan", "-nan"),
        ("inf", "inf"),
        ("-1", "-1"),
        ("-0.001", "-0.001"),
        ("100000001", "100000001"),
        ("1e9", "1e9"),
        ("\"40\"", "\"40\""),
        ("true", "true"),
        ("[40]", "an array of 1"),
        ("2020-01-01", "2020-01-01"),
    ] {
        refused(
            "exponent = 40",
            &format!("exponent = {value} # here"),
            &format!("{value} # here"),
            &[
                &format!("material.steel.exponent = {shown}"),
                "a number from 0 to 100000000",
            ],
        );
    }
    for (from, field, value, accepted) in [
        (
            "radius = 0.5",
            "material.disc.radius",
            "2.0001",
            "from 0.0001 to 2",
        ),
        (
            "radius = 0.5",
            "material.disc.radius",
            "0.00009",
            "from 0.0001 to 2",
        ),
        (
            "sharpness = 5.0",
            "material.soft.sharpness",
            "4096.5",
            "from 0 to 4096",
        ),
        (
            "sharpness = 5.0",
            "material.soft.sharpness",
            "-1.5",
            "from 0 to 4096",
        ),
        ("fov = 24.0", "camera.fov", "0.5", "from 1 to 90"),
        ("fov = 24.0", "camera.fov", "91", "from 1 to 90"),
        (
            "exposure = 0.5",
            "exposure",
            "0.0",
            "from 0.000001 to 1000000",
        ),
        (
            "specular = 0.2",
            "material.floor.specular",
            "1.25",
            "from 0 to 1",
        ),
        (
            "radius = 1.0",
            "sphere[1].radius",
            "-3.5",
            "from 0.001 to 100",
        ),
        (
            "width = 64",
            "camera.width",
            "0",
            "a whole number from 1 to 1024",
        ),
        (
            "height = 48",
            "camera.height",
            "1025",
            "a whole number from 1 to 1024",
        ),
        (
            "height = 48",
            "camera.height",
            "48.5",
            "a whole number from 1 to 1024",
        ),
        (
            "width = 64",
            "camera.width",
            "-64",
            "a whole number from 1 to 1024",
        ),
        (
            "color = 0.3",
            "daylight.color",
            "-0.25",
            "from 0 to 1000000",
        ),
    ] {
        let key = from.split(' ').next().expect("a key");
        refused(
            from,
            &format!("{key} = {value} # here"),
            &format!("{value} # here"),
            &[&format!("{field} = {value}"), accepted],
        );
    }
}

#[test]
fn arrays() {
    for (value, shown) in [
        ("[0.2, 0.4]", "an array of 2"),
        ("[0.2, 0.4, 1.4, 1.0]", "an array of 4"),
        ("0.25", "0.25"),
        ("[]", "an array of 0"),
    ] {
        refused(
            "eta = [0.2, 0.4, 1.4]",
            &format!("eta = {value} # here"),
            &format!("{value} # here"),
            &[
                &format!("material.gold.eta = {shown}"),
                "must be three numbers",
            ],
        );
    }
    refused(
        "eta = [0.2, 0.4, 1.4]",
        "eta = [0.2, 0.0, 1.4]",
        "0.0, 1.4",
        &["material.gold.eta[2] = 0.0", "from 0.01 to 100"],
    );
    refused(
        "k = [3.0, 2.5, 1.9]",
        "k = [3.0, 2.5, nan]",
        "nan",
        &["material.gold.k[3] = nan", "from 0 to 100"],
    );
    refused(
        "albedo = [0.5, 0.5, 0.4]",
        "albedo = [0.5, 1.5, 0.4]",
        "1.5, 0.4",
        &["material.floor.albedo[2] = 1.5", "from 0 to 1"],
    );
    refused(
        "eye = [0.0, -9.0, 1.0]",
        "eye = [0.0, \"far\", 1.0]",
        "\"far\"",
        &["camera.eye[2] = \"far\"", "from -1000 to 1000"],
    );
    refused(
        "direction = [0.0, -1.0, 1.0]",
        "direction = [0, 0, 0]",
        "[0, 0, 0]",
        &["light[1].direction", "longer than 0"],
    );
}

#[test]
fn parameters_that_do_not_go_together() {
    refused(
        "specular = 0.2",
        "specular = 0.6",
        "floor]",
        &[
            "material.floor",
            "specular plus the greatest albedo is 1.1",
            "at most 1",
        ],
    );
    refused(
        "eta = [0.2, 0.4, 1.4]",
        "metal = \"gold\"",
        "gold]",
        &["material.gold", "either `metal`", "`eta` and `k`"],
    );
    refused(
        "k = [3.0, 2.5, 1.9]\n",
        "",
        "gold]",
        &["material.gold", "`eta` and `k`"],
    );
    refused(
        "eta = [0.2, 0.4, 1.4]\nk = [3.0, 2.5, 1.9]",
        "metal = \"lead\"",
        "\"lead\"",
        &["material.gold.metal = \"lead\"", "`gold`", "`aluminium`"],
    );
    refused(
        "target = [0.0, 0.0, 0.0]",
        "target = [0.0, -9.0, 1.0]",
        "[camera]",
        &["`eye` and `target`"],
    );
    refused(
        "eye = [0.0, -9.0, 1.0]",
        "eye = [0.0, 0.0, 9.0]",
        "[camera]",
        &["straight up or down"],
    );
    refused(
        "radius = 1.0",
        "radius = 10.0",
        "[[sphere]]",
        &["sphere[1]", "inside this sphere"],
    );
    refused(
        "point = [0.0, 0.0, -1.0]",
        "point = [0.0, 0.0, 1.0]",
        "[[plane]]",
        &["plane[1]", "0.0000", "from 0.001 to 127"],
    );
}

#[test]
fn names_and_kinds() {
    refused(
        "material = \"steel\"",
        "material = \"stele\"",
        "\"stele\"",
        &["sphere[1].material = \"stele\"", "`steel`", "`floor`"],
    );
    refused(
        "kind = \"directional\"",
        "kind = \"spot\"",
        "\"spot\"",
        &["light[1].kind = \"spot\"", "\"directional\""],
    );
    refused(
        "name = \"good\"",
        "name = \"gööd\"",
        "\"gööd\"",
        &["name = ", "1 to 32 printable ASCII characters"],
    );
    // What the wire does not take.
    refused(
        "name = \"good\"",
        "name = \"a\\u0007b\"",
        "\"a\\u0007b\"",
        &["name = ", "1 to 32 printable ASCII characters"],
    );
    refused(
        "[[sphere]]",
        "[sphere]",
        "[sphere]",
        &["sphere", "[[sphere]]"],
    );
    refused(
        "[daylight]",
        "[[daylight]]",
        "[[daylight]]",
        &["daylight", "a table"],
    );
}

/// A column counts characters, not bytes.
#[test]
fn columns_are_characters() {
    let text = GOOD
        .replace("[daylight]\ncolor = 0.3\n", "")
        .replace("exposure = 0.5", "daylight = { \"éé\" = 1, color = -0.5 }");
    let error = read(&text).expect_err("a negative colour");
    assert_eq!(error.place, Some((2, 32)), "{error}");
    assert_eq!(error.place, Some(place(&text, "-0.5")));
}

#[test]
fn broken_toml_is_placed() {
    for (text, line) in [
        ("exposure = ", 1),
        ("\n\n[camera\n", 3),
        ("[camera]\nwidth = 64\nheight = \"48\n", 3),
        ("[camera]\nwidth 64\n", 2),
        ("[camera]\neye = [0.0, 1.0\n", 2),
    ] {
        let error = read(text).expect_err(text);
        let (found, column) = error.place.expect("a place");
        assert!(found == line && column >= 1, "{error}");
        assert!(error.to_string().starts_with("folder/bad.toml:"), "{error}");
        assert!(!error.message.is_empty());
    }
}

/// Cut anywhere, a file is refused or is a smaller scene; nothing panics.
#[test]
fn truncated_files_never_panic() {
    let (mut read_on, mut refused) = (0, 0);
    for end in (0..GOOD.len()).filter(|end| GOOD.is_char_boundary(*end)) {
        match read(&GOOD[..end]) {
            Ok(_) => read_on += 1,
            Err(error) => {
                refused += 1;
                assert!(error.place.is_some(), "{error}");
            }
        }
    }
    assert!(
        refused > 500 && read_on > 0,
        "{refused} refused, {read_on} read"
    );
}

/// Any byte changed to any of a few never panics either.
#[test]
fn garbled_files_never_panic() {
    for offset in 0..GOOD.len() {
        for byte in [b'\0', b'"', b'[', b'-', b'9', b'\n', 0xFF] {
            let mut bytes = GOOD.as_bytes().to_vec();
            bytes[offset] = byte;
            if let Ok(text) = String::from_utf8(bytes) {
                let _ = read(&text);
            }
        }
    }
}

#[test]
fn files_that_can_not_be_read() {
    let folder =
        std::env::temp_dir().join(format!("microbrdf-scene-errors-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let missing = folder.join("missing.toml");
    let binary = folder.join("binary.toml");
    fs::write(&binary, b"exposure = 0.5\n\xFF\xFE").expect("a file");
    let large = folder.join("large.toml");
    fs::write(&large, vec![b'#'; (1 << 20) + 1]).expect("a file");
    for (path, part) in [
        (&missing, "can't be read"),
        (&binary, "not UTF-8 text from byte 15 on"),
        (&large, "at most 1048576"),
        (&folder, "is not a file"),
    ] {
        let error = Description::from_file(path).expect_err("unreadable");
        let message = error.to_string();
        assert!(message.contains(part), "{message}");
        assert!(message.contains(&path.display().to_string()), "{message}");
    }
    fs::remove_dir_all(&folder).expect("ours");
}

/// Materials as a command's argument: inline, in braces, or in a file.
#[test]
fn materials_as_arguments() {
    for text in [
        "model = \"lambert\", albedo = 0.5",
        "{model = \"lambert\", albedo = 0.5}",
        " { model = \"lambert\", albedo = 0.5 } ",
        "model = \"lambert\"\nalbedo = 0.5\n",
    ] {
        let material = Material::from_argument(text).expect(text);
        assert_eq!(
            material,
            Material::from_argument("model = \"lambert\", albedo = 0.5").expect("one")
        );
    }
    for (text, parts) in [
        ("model = \"lambert\"", vec!["`albedo`", "missing"]),
        (
            "model = \"lambert\", albedo = 2",
            vec!["albedo = 2", "from 0 to 1"],
        ),
        ("model = \"mirror\"", vec!["model = \"mirror\"", "`patch`"]),
        ("model = \"lambert\", albedo =", vec!["--material"]),
        (
            "no/such/file.toml",
            vec!["no/such/file.toml", "can't be read"],
        ),
        ("", vec!["can't be read"]),
    ] {
        let message = Material::from_argument(text).expect_err(text).to_string();
        for part in parts {
            assert!(
                message.contains(part),
                "{text:?}: {message:?} lacks {part:?}"
            );
        }
    }
}
