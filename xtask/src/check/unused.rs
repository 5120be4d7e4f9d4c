//! What a scene does not use costs it nothing; and what the smallest scene takes.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use super::counts::Tally;
use super::{Bench, Step, step};
use crate::board::Board;
use crate::demo;
use crate::failure::{During, Failure, Outcome};
use crate::firmware::{self, BRIEF, Order};
use crate::host_sim::HostSim;
use crate::report;
use crate::sizes;

/// The board that images are built for: the smallest.
const BOARD: &str = "microbit";
/// How they compute.
const ARITHMETIC: &str = "q15";

/// Most flash that the smallest scene may take.
const SMALLEST_FLASH: u64 = 8 << 10;
/// Most RAM that it may take, its stack included.
const SMALLEST_RAM: u64 = 2 << 10;

/// A material of each model, with parameters of its own.
const MODELS: [(&str, &str); 14] = [
    ("lambert", "model = \"lambert\"\nalbedo = [0.7, 0.5, 0.3]"),
    ("phong", "model = \"phong\"\nexponent = 21"),
    (
        "metallic-phong",
        "model = \"metallic-phong\"\nexponent = 22",
    ),
    ("p-model", "model = \"phong\"\nexponent = 23\np = 0.5"),
    ("retro-phong", "model = \"retro-phong\"\nexponent = 24"),
    ("patch", "model = \"patch\"\nradius = 0.25"),
    (
        "patch-exponential",
        "model = \"patch-exponential\"\nsharpness = 26",
    ),
    (
        "metal",
        "model = \"metal\"\nmetal = \"copper\"\nexponent = 27",
    ),
    (
        "plastic",
        "model = \"plastic\"\nalbedo = 0.5\nspecular = 0.25\nexponent = 28",
    ),
    (
        "ceramic",
        "model = \"plastic\"\nalbedo = 0.5\nspecular = 0.25\nexponent = 29\nindex = 1.5",
    ),
    (
        "patch-metal",
        "model = \"patch-metal\"\nmetal = \"silver\"\nsharpness = 30",
    ),
    (
        "basic-patch-metal",
        "model = \"patch-metal\"\nmetal = \"gold\"\nradius = 0.31",
    ),
    (
        "metallic-paint",
        "model = \"metallic-paint\"\nmetal = \"aluminium\"\nsharpness = 32",
    ),
    (
        "generalised-lambert",
        "model = \"generalised-lambert\"\nalbedo = 0.6\nsmoothness = 0.75",
    ),
];

/// Every step.
pub fn steps() -> Vec<Step> {
    vec![
        step("nothing unused", nothing_unused).early(),
        step("smallest scene", smallest),
        step("scene too large", too_large_scene),
    ]
}

/// A scene with a sphere of each of `used`, and all of `defined` in its file.
fn scene(used: &[usize], defined: &[usize]) -> String {
    let mut text = String::from(
        "name = \"unused\"\n[camera]\nwidth = 32\nheight = 16\neye = [0, -6, 1]\n\
         target = [0, 0, 0]\nfov = 30\n[[light]]\nkind = \"directional\"\n\
         direction = [-1, -2, 2]\ncolor = 1\n",
    );
    for (place, index) in used.iter().enumerate() {
        let _ = write!(
            text,
            "[[sphere]]\ncenter = [{place}, {place}, 0]\nradius = 1\nmaterial = \"{}\"\n",
            MODELS[*index].0
        );
    }
    for index in defined {
        let (name, table) = MODELS[*index];
        let _ = write!(text, "[material.{name}]\n{table}\n");
    }
    text
}

/// An image's bytes, and the symbols of its scene.
struct Built {
    bytes: Vec<u8>,
    symbols: BTreeSet<String>,
    flash: u64,
}

fn build(bench: &Bench<'_>, host: &HostSim<'_>, name: &str, text: &str) -> Outcome<Built> {
    let folder = bench.layout.target().join("test").join("unused");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let path = folder.join(format!("unused-{name}.toml"));
    fs::write(&path, text).during(|| format!("writing {}", path.display()))?;
    let order = Order {
        board: Board::named(BOARD)?,
        scene: path,
        arithmetic: ARITHMETIC.to_string(),
        features: Vec::new(),
    };
    let image = firmware::build(bench.layout, bench.cross, host, &order, true)?;
    let elf = &image.elf;
    let bytes = fs::read(elf).during(|| format!("reading {}", elf.display()))?;
    let symbols = sizes::symbols(elf)?.into_iter().map(|(name, _)| name);
    Ok(Built {
        bytes,
        symbols: symbols.collect(),
        flash: image.sizes.flash,
    })
}

/// Statics of a scene's materials among an image's symbols.
fn materials(built: &Built) -> usize {
    let is_material = |name: &&String| {
        let number = name.split("MATERIAL_").nth(1);
        number.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
            && !name.contains("nested")
    };
    built.symbols.iter().filter(is_material).count()
}

/// One model at a time: defining all the others changes no byte; using one does.
fn nothing_unused(bench: &Bench<'_>) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let all: Vec<usize> = (0..MODELS.len()).collect();
    let mut tally = Tally::default();
    for index in all.iter().copied() {
        let name = MODELS[index].0;
        let other = (index + 1) % MODELS.len();
        let alone = build(bench, &host, "alone", &scene(&[index], &[index]))?;
        let defined = build(bench, &host, "defined", &scene(&[index], &all))?;
        let both = build(bench, &host, "both", &scene(&[index, other], &all))?;
        let mut faults = Vec::new();
        if alone.bytes != defined.bytes {
            faults.push("the image changes with materials that no object uses".to_owned());
        }
        if alone.symbols != defined.symbols {
            faults.push("so do its symbols".to_owned());
        }
        if both.flash <= alone.flash || both.symbols == alone.symbols {
            faults.push(format!("using {} as well changes nothing", MODELS[other].0));
        }
        // One material without tables may be nothing but instructions.
        let [one, same, two] = [&alone, &defined, &both].map(materials);
        if one > 1 || same != one || two != 2 {
            faults.push(format!(
                "the linked materials are {one}, {same} and {two}, not 0 or 1, as many, and 2"
            ));
        }
        if !faults.is_empty() {
            return Err(Failure::incomplete(format!(
                "{name}: {}",
                faults.join("; ")
            )));
        }
        println!(
            "{name}: {} bytes of flash, to the byte the same with {} more defined; {} more with a \
             sphere of {}",
            alone.flash,
            MODELS.len() - 1,
            both.flash - alone.flash,
            MODELS[other].0
        );
        tally += Tally::PASSED;
    }
    Ok(tally)
}

/// The smallest scene, with streaming and all: it fits, and the device's picture is the host's.
fn smallest(bench: &Bench<'_>) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let order = Order {
        board: Board::named(BOARD)?,
        scene: bench.layout.at("scenes/smallest.toml"),
        arithmetic: ARITHMETIC.to_string(),
        features: vec![BRIEF.to_string()],
    };
    let out = bench.layout.target().join("test").join("smallest");
    let report = demo::run(bench.layout, bench.cross, &host, &order, &out, true)?;
    print!("{}", report::lines(&report));
    let mut faults = report::faults(&report);
    faults.extend(too_large(&report));
    if faults.is_empty() {
        return Ok(Tally::PASSED);
    }
    Err(Failure::incomplete(faults.join("; ")))
}

/// Tables of so many materials do not fit into the board's flash.
const TOO_MANY: usize = 62;

/// A scene that no board of this size can hold: refused with the figures, and no image is left.
fn too_large_scene(bench: &Bench<'_>) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let folder = bench.layout.target().join("test").join("unused");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let mut text = scene(&[], &[]);
    for number in 0..TOO_MANY {
        let _ = write!(
            text,
            "[[sphere]]\ncenter = [0, {number}, 0]\nradius = 1\nmaterial = \"m{number}\"\n\
             [material.m{number}]\nmodel = \"phong\"\nexponent = {}\n",
            20 + number
        );
    }
    let path = folder.join("too-large.toml");
    fs::write(&path, text).during(|| format!("writing {}", path.display()))?;
    let order = Order {
        board: Board::named(BOARD)?,
        scene: path,
        arithmetic: "q31".to_string(),
        features: Vec::new(),
    };
    match firmware::build(bench.layout, bench.cross, &host, &order, true) {
        Ok(image) => Err(Failure::incomplete(format!(
            "it is built, and takes {} bytes of flash",
            image.sizes.flash
        ))),
        Err(failure) if failure.status == 2 && order.elf(bench.layout).exists() => {
            Err(Failure::incomplete(format!("an image is left: {failure}")))
        }
        Err(failure) if failure.status == 2 => {
            println!("{failure}");
            let figures = [BOARD, "bytes of flash", &order.board.flash.to_string()];
            if figures
                .iter()
                .all(|figure| failure.message.contains(figure))
            {
                Ok(Tally::PASSED)
            } else {
                Err(failure)
            }
        }
        Err(failure) => Err(failure),
    }
}

/// Where a report exceeds what the smallest scene is held to.
fn too_large(report: &serde_json::Value) -> Vec<String> {
    let bytes = |field: &str| report[field].as_u64();
    let ram = bytes("ram_bytes").zip(bytes("stack_bytes"));
    [
        ("flash", bytes("flash_bytes"), SMALLEST_FLASH),
        (
            "RAM and stack",
            ram.map(|(ram, stack)| ram + stack),
            SMALLEST_RAM,
        ),
    ]
    .into_iter()
    // A figure that is missing is not a small one.
    .filter(|(_, found, most)| !found.is_some_and(|found| found <= *most))
    .map(|(what, found, most)| format!("{what}: {found:?} bytes, at most {most} are allowed"))
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_limits_bite() {
        let small = json!({ "flash_bytes": 8192, "ram_bytes": 1000, "stack_bytes": 1048 });
        assert!(too_large(&small).is_empty());
        for (field, value) in [
            ("flash_bytes", json!(8193)),
            ("ram_bytes", json!(1001)),
            ("stack_bytes", json!(1049)),
            ("stack_bytes", json!(null)),
        ] {
            let mut large = small.clone();
            large[field] = value;
            assert_eq!(too_large(&large).len(), 1, "{field}");
        }
    }

    #[test]
    fn a_scene_defines_more_than_it_uses() {
        let text = scene(&[0], &[0, 1]);
        assert_eq!(text.matches("[[sphere]]").count(), 1);
        assert_eq!(text.matches("[material.").count(), 2);
    }
}
