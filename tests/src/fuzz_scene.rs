//! Scene files from arbitrary bytes, and what must hold for them.

use arbitrary::{Arbitrary as _, Unstructured};
use microbrdf_scene::{Description, HostArithmetic, SceneParts};

/// Bytes that a file takes at most.
pub const BYTES: usize = 512;

/// What files are spliced from: whole lines, of which most go together, and
/// pieces that go with nothing.
const LINES: &[&str] = &[
    "[camera]\nwidth = 8\nheight = 4\neye = [0, -5, 1]\ntarget = [0, 0, 0]\nfov = 40",
    "[[light]]\nkind = \"directional\"\ndirection = [0, -1, 1]\ncolor = 1",
    "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"it\"",
    "[[plane]]\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\nmaterial = \"it\"",
    "[material.it]\nmodel = \"metallic-phong\"\nexponent = 20",
    "[material.it]\nmodel = \"metal\"\nmetal = \"gold\"\nexponent = 36",
    "[material.it]\nmodel = \"plastic\"\nalbedo = 0.5\nspecular = 0.25\nexponent = 9",
    "[material.other]\nmodel = \"patch\"\nradius = 0.5",
    "[material.tinted]\nmodel = \"patch-metal\"\nmetal = \"gold\"\nsharpness = 9",
    "[material.paint]\nmodel = \"metallic-paint\"\neta = [1, 2, 3]\nk = [3, 2, 1]\nsharpness = 9",
    "[material.matt]\nmodel = \"generalised-lambert\"\nalbedo = 0.5\nsmoothness = 0.5\nclip = 1.5",
    "[material.glossy]\nmodel = \"plastic\"\nalbedo = 0.5\nspecular = 0.25\nexponent = 9\nindex = 1.5",
    "[daylight]\ncolor = [0.6, 0.6, 0.6]",
    "exposure = 0.5\nname = \"it\"",
    "background = [0.1, 0.2, 0.3]",
];
const PIECES: &[&str] = &[
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    "\"",
    "'",
    "\"\"\"",
    "\n",
    ",",
    ".",
    "#",
    "\\u0000",
    "\0",
    "é",
    "\u{10FFFF}",
    "nan",
    "-inf",
    "1e308",
    "-1",
    "0x7F",
    "9223372036854775808",
    "1e-300",
    "0",
    "true",
    "1979-05-27",
    "material",
    "camera",
    "sphere",
    "light",
    "exponent",
    "width",
    "radius",
];
/// Values that stand in for a number of a line.
const NUMBERS: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "127",
    "1024",
    "65536",
    "1e-3",
    "1e6",
    "1e8",
    "1e308",
    "nan",
    "inf",
    "\"1\"",
    "[1]",
    "[1, 1, 1]",
    "[0, 0, 0]",
    "[1000, -1000, 1000]",
    "[1e-9, 0, 0]",
    "2.0",
    "90",
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
    let mut order: Vec<usize> = (0..LINES.len()).collect();
    let mut text = String::new();
    // What has no table of its own stands first.
    let first = LINES.len() - 2;
    for line in &LINES[first..] {
        if u8::arbitrary(source)? % 4 == 0 {
            text.push_str(&numbers(source, line)?);
            text.push('\n');
        }
    }
    order.truncate(first);
    for index in order {
        let often = usize::from(u8::arbitrary(source)?);
        // A camera and a material are nearly always needed, twice never.
        let times = match index {
            0 | 4 => usize::from(often % 16 != 0),
            5 | 6 => usize::from(often % 32 == 0),
            _ => often % 4 / 2 + usize::from(often == 255) * 300,
        };
        for _ in 0..times {
            text.push_str(&numbers(source, LINES[index])?);
            text.push('\n');
        }
    }
    for _ in 0..(u8::arbitrary(source)? % 8).saturating_sub(4) {
        damage(source, &mut text)?;
    }
    Ok(text)
}

/// A block of lines, now and then with another number in it.
fn numbers(source: &mut Unstructured<'_>, block: &str) -> arbitrary::Result<String> {
    let chosen = usize::from(u8::arbitrary(source)?);
    let lines: Vec<_> = block.lines().collect();
    let mut out = String::new();
    for (index, line) in lines.iter().enumerate() {
        match line.split_once(" = ") {
            Some((key, _)) if chosen % (8 * lines.len()) == index => {
                let value = usize::from(u8::arbitrary(source)?);
                out.push_str(&format!("{key} = {}", NUMBERS[value % NUMBERS.len()]));
            }
            _ => out.push_str(line),
        }
        out.push('\n');
    }
    Ok(out)
}

/// Something cut out, put in or changed.
fn damage(source: &mut Unstructured<'_>, text: &mut String) -> arbitrary::Result<()> {
    let place = |source: &mut Unstructured<'_>, text: &str| -> arbitrary::Result<usize> {
        let mut at = u32::arbitrary(source)? as usize % (text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        Ok(at)
    };
    let at = place(source, text)?;
    match u8::arbitrary(source)? % 4 {
        0 => text.truncate(at),
        1 => {
            let end = place(source, text)?;
            text.replace_range(at.min(end)..at.max(end), "");
        }
        _ => {
            let piece = PIECES[usize::from(u8::arbitrary(source)?) % PIECES.len()];
            let times = match u8::arbitrary(source)? {
                0..=15 => 1000,
                _ => 1,
            };
            text.insert_str(at, &piece.repeat(times));
        }
    }
    Ok(())
}

/// What must hold: a file is refused at a place within it, in one line; or
/// each of its pixels can be shaded, and its source written.
///
/// # Errors
/// What does not.
pub fn check<A: HostArithmetic>(text: &str) -> Result<bool, String> {
    let description = match Description::from_toml("it.toml", "it", text) {
        Ok(description) => description,
        Err(error) => {
            let (line, column) = error.place.ok_or("no place")?;
            let lines = text.split('\n').count();
            let message = error.to_string();
            return if line == 0 || line > lines || column == 0 {
                Err(format!("line {line} of {lines}: {message}"))
            } else if message.contains('\n') || message.len() > 2000 {
                Err(format!("a message of {} bytes: {message}", message.len()))
            } else {
                Ok(false)
            };
        }
    };
    // What an arithmetic has no room for is named.
    let Ok(prepared) = description.prepare::<A>() else {
        return Ok(false);
    };
    let source = microbrdf_scene::bake::<A>(&description)?;
    if !source.contains("pub fn shade_row") {
        return Err("no row function is baked".to_owned());
    }
    let parts = SceneParts::new(prepared);
    let surfaces = parts.surfaces();
    let scene = parts.scene(&surfaces);
    for i in 0..64 {
        let (x, y) = (
            i % 8 * usize::from(description.camera.width) / 8,
            i / 8 * usize::from(description.camera.height) / 8,
        );
        let raw = scene.shade_pixel(x, y).to_raw();
        if raw.iter().any(|light| *light > 1 << 24) {
            return Err(format!("pixel ({x}, {y}) is {raw:?}"));
        }
    }
    Ok(true)
}
