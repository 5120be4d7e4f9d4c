//! OBJ files from arbitrary bytes, and what must hold for them.

use std::path::Path;

use arbitrary::{Arbitrary as _, Unstructured};
use microbrdf_scene::{Description, HostArithmetic, Obj, SceneParts};

/// Bytes that a file takes at most.
pub const BYTES: usize = 384;

/// The scene that the file is put into, with its material under any name.
const SCENE: &str = r#"
[camera]
width = 16
height = 12
eye = [0.2, -6, 1]
target = [0, 0, 0]
fov = 40
[[light]]
kind = "directional"
direction = [0, -1, 1]
color = 1
[[light]]
kind = "point"
position = [1, -2, 3]
intensity = 3
[[mesh]]
file = "it.obj"
material = "it"
[material.it]
model = "metallic-phong"
exponent = 20
"#;

const NUMBERS: &[&str] = &[
    "0",
    "1",
    "-1",
    "0.5",
    "-0.25",
    "2",
    "1e-7",
    "-0.0",
    "1e6",
    "1e7",
    "nan",
    "inf",
    "1e999",
    "x",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551616",
    "0x1",
    "1/2",
    "٣",
];
const WORDS: &[&str] = &[
    "v",
    "vn",
    "vt",
    "f",
    "o",
    "g",
    "usemtl",
    "mtllib",
    "s",
    "l",
    "p",
    "#",
    "\\",
    "curv",
    "call",
    "\u{FEFF}v",
    "g\u{2003}a",
    "usemtl\u{3000}é",
    "mtllib it.obj",
    "\0",
];

/// The file that some bytes stand for; beyond their end they are 0.
///
/// # Panics
/// Never: integers can be made of any bytes.
#[must_use]
pub fn text(bytes: &[u8]) -> String {
    read(&mut Unstructured::new(bytes)).expect("integers of any bytes")
}

fn read(source: &mut Unstructured<'_>) -> arbitrary::Result<String> {
    let mut text = String::new();
    let points = usize::from(u8::arbitrary(source)? % 12);
    let normals = usize::from(u8::arbitrary(source)? % 4);
    for _ in 0..points {
        line(source, &mut text, "v", 3, coordinate)?;
    }
    for _ in 0..normals {
        line(source, &mut text, "vn", 3, coordinate)?;
    }
    for _ in 0..u8::arbitrary(source)? % 6 {
        let with_normals = normals > 0 && u8::arbitrary(source)? % 2 == 0;
        let corners = match u8::arbitrary(source)? {
            0..=7 => u8::arbitrary(source)? % 3,
            8..=60 => 4,
            250..=255 => u8::arbitrary(source)?,
            _ => 3,
        };
        // Neighbours, so that they seldom coincide.
        let start = usize::from(u8::arbitrary(source)?);
        let number = std::cell::Cell::new(start);
        line(source, &mut text, "f", corners.into(), |source| {
            let mut corner = index(source, number.replace(number.get() + 1), points)?;
            if with_normals {
                corner += "//";
                corner += &index(source, start, normals)?;
            }
            Ok(corner)
        })?;
        if u8::arbitrary(source)? % 16 == 0 {
            text.push_str(pick(source, WORDS)?);
            text.push('\n');
        }
    }
    if u8::arbitrary(source)? % 4 == 0 {
        let mut at = u16::arbitrary(source)? as usize % (text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        match u8::arbitrary(source)? % 3 {
            0 => text.truncate(at),
            1 => text.insert_str(at, pick(source, NUMBERS)?),
            _ => text.insert_str(at, pick(source, WORDS)?),
        }
    }
    Ok(text)
}

fn pick(source: &mut Unstructured<'_>, of: &[&'static str]) -> arbitrary::Result<&'static str> {
    Ok(of[usize::from(u8::arbitrary(source)?) % of.len()])
}

fn line(
    source: &mut Unstructured<'_>,
    text: &mut String,
    kind: &str,
    count: usize,
    word: impl Fn(&mut Unstructured<'_>) -> arbitrary::Result<String>,
) -> arbitrary::Result<()> {
    text.push_str(kind);
    for _ in 0..count {
        text.push(' ');
        text.push_str(&word(source)?);
    }
    text.push('\n');
    Ok(())
}

/// Mostly a small number.
fn coordinate(source: &mut Unstructured<'_>) -> arbitrary::Result<String> {
    let byte = u8::arbitrary(source)?;
    if byte == 255 {
        return Ok(pick(source, NUMBERS)?.to_owned());
    }
    Ok((f64::from(byte) / 64.0 - 2.0).to_string())
}

/// Mostly an index within range, forwards or backwards.
fn index(source: &mut Unstructured<'_>, number: usize, count: usize) -> arbitrary::Result<String> {
    Ok(match u8::arbitrary(source)? {
        255 => pick(source, NUMBERS)?.to_owned(),
        254 => (count + 1).to_string(),
        200..=253 => format!("-{}", number % count.max(1) + 1),
        _ => (number % count.max(1) + 1).to_string(),
    })
}

/// What must hold: a file is refused with a line within it, in one line; or
/// its indices are within range and the scene that it stands in can be shaded.
/// `folder` is for the file.
///
/// # Errors
/// What does not.
pub fn check<A: HostArithmetic>(text: &str, folder: &Path) -> Result<bool, String> {
    let read = Obj::read("it.obj", text);
    std::fs::write(folder.join("it.obj"), text).map_err(|error| error.to_string())?;
    let scene = folder.join("it.toml").display().to_string();
    let description = match (&read, Description::from_toml(&scene, "it", SCENE)) {
        (Err(inner), Err(outer)) => {
            let (message, lines) = (outer.to_string(), text.lines().count());
            return if message.contains('\n') || message.len() > 2000 {
                Err(format!("a message of {} bytes: {message}", message.len()))
            } else if inner.line.is_some_and(|line| line == 0 || line > lines) {
                Err(format!("{inner}: of {lines}"))
            } else if !message.contains(&folder.join("it.obj").display().to_string()) {
                Err(format!("{message}: names no file"))
            } else {
                Ok(false)
            };
        }
        (Err(inner), Ok(_)) => return Err(format!("{inner}, but the scene is read")),
        // Too far off, or behind the camera.
        (Ok(_), Err(outer)) if outer.message.starts_with("mesh: ") => return Ok(false),
        (Ok(_), Err(outer)) => return Err(outer.to_string()),
        (Ok(_), Ok(description)) => description,
    };
    let obj = read.map_err(|error| error.to_string())?;
    for triangle in &obj.triangles {
        let within = |indices: [usize; 3], count: usize| indices.iter().all(|i| *i < count);
        if !within(triangle.corners, obj.positions.len())
            || triangle
                .normals
                .is_some_and(|normals| !within(normals, obj.normals.len()))
        {
            return Err(format!("{triangle:?}"));
        }
    }
    let parts = SceneParts::new(description.prepare::<A>()?);
    let surfaces = parts.surfaces();
    let scene = parts.scene(&surfaces);
    for y in 0..12 {
        for x in 0..16 {
            let raw = scene.shade_pixel(x, y).to_raw();
            if raw.iter().any(|light| *light > 1 << 24) {
                return Err(format!("pixel ({x}, {y}) is {raw:?}"));
            }
            let seen = description.view.as_ref().and_then(|view| view.at(x, y));
            let unit = |n: [f64; 3]| (n.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-9;
            if let Some(seen) = seen
                && !(unit(seen.normal) && seen.depth > 0.0)
            {
                return Err(format!("pixel ({x}, {y}): {seen:?}"));
            }
        }
    }
    Ok(true)
}
