//! Whole runs on emulated boards: the demo for every board and arithmetic, and frames that end badly.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::counts::Tally;
use super::line::{self, End};
use super::{Bench, Step, step};
use crate::board::{ARITHMETICS, BOARDS, Board};
use crate::demo;
use crate::failure::{During, Failure, Outcome};
use crate::firmware::{self, Order};
use crate::forecast::{Program, held};
use crate::gallery;
use crate::host_sim::HostSim;
use crate::picture::Picture;
use crate::qemu::Emulator;
use crate::receiver::{Received, Reception};
use crate::report;

/// Most codes that the demo scene may be off by, but for counted class flips.
const CODE_ERROR: f64 = 1.0;
/// Most pixels that may fall on the other side of a jump.
const CLASS_FLIPS: f64 = 20.0;
/// Greatest share of codes that may be off by one.
const CODE_ERROR_SHARE: f64 = 0.01;

/// One of so many rows of the demo scene is counted.
const EVERY: usize = 32;

/// Features of the firmware that change what it sends, but not that the frame is whole.
const OPTIONS: [&str; 2] = ["rgb565", "defmt"];

/// Colour that the receiver hatches missing pixels with, beside black.
const MISSING: [u8; 3] = [255, 0, 255];

/// Every step that boots an emulator.
pub fn steps() -> Vec<Step> {
    let mut steps = Vec::new();
    for board in BOARDS {
        for arithmetic in ARITHMETICS {
            steps.push(step(
                format!("demo, {} {arithmetic}", board.name),
                move |bench| demonstrate(bench, board, arithmetic, "demo"),
            ));
        }
    }
    // A mesh: the table that is looked up in place of it.
    steps.push(step(
        format!("demo of a mesh, {}", BOARDS[0].name),
        |bench| demonstrate(bench, BOARDS[0], "q31", "teapot"),
    ));
    for name in gallery::names() {
        let exhibit = step(format!("gallery, {name}"), move |bench| {
            gallery::check(bench.layout, bench.cross, name)?;
            Ok(Tally::PASSED)
        });
        steps.push(exhibit.early());
    }
    for board in BOARDS {
        let name = format!("{}, {}", OPTIONS.join(" and "), board.name);
        steps.push(step(name, move |bench| with_options(bench, board)));
    }
    for board in BOARDS {
        for (feature, fault) in [
            ("provoke-panic", "panic"),
            ("provoke-hardfault", "hard fault"),
        ] {
            steps.push(step(format!("{fault}, {}", board.name), move |bench| {
                provoke(bench, board, feature, fault)
            }));
        }
    }
    // Silence of two seconds ends them: what comes must come in time.
    for (name, end) in [("cut", End::HangsUp), ("silent", End::FallsSilent)] {
        let name = format!("line {name} in mid-frame");
        steps.push(step(name, move |bench| broken_line(bench, end)).alone());
    }
    steps
}

fn order(bench: &Bench<'_>, board: Board, arithmetic: &str, features: &[&str]) -> Order {
    Order {
        board,
        scene: bench.layout.at("scenes/demo.toml"),
        arithmetic: arithmetic.to_string(),
        features: features.iter().map(ToString::to_string).collect(),
    }
}

fn folder(bench: &Bench<'_>, name: &str) -> Outcome<PathBuf> {
    let folder = bench.layout.target().join("test").join(name);
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    Ok(folder)
}

/// The demo: whole, equal to the host, and near the reference.
fn demonstrate(bench: &Bench<'_>, board: Board, arithmetic: &str, scene: &str) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let order = Order {
        scene: bench.layout.at(&format!("scenes/{scene}.toml")),
        ..order(bench, board, arithmetic, &[])
    };
    let out = folder(bench, &format!("{scene}-{}-{arithmetic}", board.name))?;
    let mut report = demo::run(bench.layout, bench.cross, &host, &order, &out, true)?;
    let program = Program::build(bench.layout, true)?;
    if held::is_forecast(board, arithmetic) {
        held::add(
            bench.layout,
            bench.cross,
            &host,
            &program,
            (&order, &out),
            EVERY,
            &mut report,
        )?;
    }
    print!("{}", report::lines(&report));
    let mut faults = report::faults(&report);
    faults.extend(far_from_reference(&report));
    if held::is_forecast(board, arithmetic) {
        print!("{}", held::line(&report));
        faults.extend(held::faults(&report));
    }
    if faults.is_empty() {
        return Ok(Tally::PASSED);
    }
    Err(Failure::incomplete(format!(
        "{} ({})",
        faults.join("; "),
        bench.layout.shown(&out)
    )))
}

/// Where a report exceeds what the demo scene is held to.
fn far_from_reference(report: &Value) -> Vec<String> {
    [
        ("code_error_max", CODE_ERROR),
        ("code_error_over_one_share", 0.0),
        ("code_error_share", CODE_ERROR_SHARE),
        ("class_flips", CLASS_FLIPS),
    ]
    .into_iter()
    // A figure that is missing is not a small one.
    .filter(|(field, most)| !report[*field].as_f64().is_some_and(|value| value <= *most))
    .map(|(field, most)| format!("{field} is {}, at most {most} is allowed", report[field]))
    .collect()
}

/// The firmware with everything that can be chosen beside board and scene: the frame is whole, and logs came.
fn with_options(bench: &Bench<'_>, board: Board) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let order = order(bench, board, ARITHMETICS[0], &OPTIONS);
    let image = firmware::build(bench.layout, bench.cross, &host, &order, true)?;
    println!("{}", firmware::describe(bench.layout, &order, &image));
    let out = folder(bench, &format!("options-{}", board.name))?;
    let mut reception = Reception::into(&out);
    reception.messages = Some(out.join("receiver.log"));
    reception.log = Some(out.join("defmt.bin"));
    let received = reception.run(
        bench.layout,
        &mut Emulator::halted(bench.layout, &board, &image.elf)?,
    )?;
    let mut faults = Vec::new();
    if received.status.code() != Some(0) {
        faults.push(format!(
            "the receiver ended with {}, not with 0",
            received.status
        ));
    }
    if received.report["pixel_format"] != "rgb565" {
        faults.push(format!(
            "the pixel format is {}, not rgb565",
            received.report["pixel_format"]
        ));
    }
    let predicted = out.join("rgb565.png");
    host.run([
        "render".as_ref(),
        order.scene.as_os_str(),
        "--arithmetic".as_ref(),
        order.arithmetic.as_ref(),
        "--rgb565".as_ref(),
        predicted.as_os_str(),
    ])?;
    let picture = Picture::read_png(&reception.picture)?;
    if picture.differing(&Picture::read_png(&predicted)?) != Some(0) {
        faults.push("the picture differs from the host's in RGB565".into());
    }
    if fs::metadata(out.join("defmt.bin")).map_or(0, |file| file.len()) == 0 {
        faults.push("no log came".into());
    }
    verdict(&faults)
}

/// A frame that the firmware breaks off itself: the receiver says why, and keeps what arrived.
fn provoke(bench: &Bench<'_>, board: Board, feature: &str, fault: &str) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let order = order(bench, board, ARITHMETICS[0], &[feature]);
    let image = firmware::build(bench.layout, bench.cross, &host, &order, true)?;
    let out = folder(bench, &format!("{feature}-{}", board.name))?;
    let mut reception = Reception::into(&out);
    reception.messages = Some(out.join("receiver.log"));
    let received = reception.run(
        bench.layout,
        &mut Emulator::halted(bench.layout, &board, &image.elf)?,
    )?;
    let mut faults = partial(&received, &reception.picture)?;
    if received.report["fault"]["name"] != fault {
        faults.push(format!(
            "reported is {}, not a {fault}",
            received.report["fault"]
        ));
    }
    let said = fs::read_to_string(out.join("receiver.log")).unwrap_or_default();
    if !said.contains(fault) {
        faults.push(format!("the receiver does not say {fault:?}: {said}"));
    }
    println!(
        "{}",
        said.lines()
            .find(|line| line.contains(fault))
            .unwrap_or_default()
    );
    verdict(&faults)
}

/// A whole frame over a line that breaks in its middle.
fn broken_line(bench: &Bench<'_>, end: End) -> Outcome<Tally> {
    let host = HostSim::build(bench.layout, true)?;
    let board = BOARDS[0];
    let order = order(bench, board, ARITHMETICS[0], &[]);
    let image = firmware::build(bench.layout, bench.cross, &host, &order, true)?;
    let out = folder(bench, &format!("broken-{end:?}").to_lowercase())?;
    let mut emulator = Emulator::halted(bench.layout, &board, &image.elf)?;
    let mut reception = Reception::into(&out);
    // Less than half of the smallest frame that 256 x 128 pixels of 3 bytes can be.
    reception.port = Some(line::cut_after(emulator.line()?, 40_000, end)?);
    reception.silence = Some(2);
    reception.messages = Some(out.join("receiver.log"));
    let received = reception.run(bench.layout, &mut emulator)?;
    let said = fs::read_to_string(out.join("receiver.log")).unwrap_or_default();
    println!("{}", said.lines().last().unwrap_or_default());
    verdict(&partial(&received, &reception.picture)?)
}

/// What is wrong with a reception that had to end early: it must say so, keep what came, and mark the rest.
fn partial(received: &Received, picture: &Path) -> Outcome<Vec<String>> {
    let mut faults = Vec::new();
    if received.status.code() != Some(1) {
        faults.push(format!(
            "the receiver ended with {}, not with 1",
            received.status
        ));
    }
    for field in ["rows_received", "rows_missing"] {
        if received.report[field].as_u64().unwrap_or(0) == 0 {
            faults.push(format!(
                "{field} is {}, must be above 0",
                received.report[field]
            ));
        }
    }
    let picture = Picture::read_png(picture)?;
    let mut rows = picture.rgb.chunks_exact(picture.width as usize * 3);
    if rows.next().is_none_or(is_hatched) {
        faults.push("the first row, which came, is marked as missing".into());
    }
    if !rows.next_back().is_some_and(is_hatched) {
        faults.push("the last row, which did not come, is not marked as missing".into());
    }
    Ok(faults)
}

/// Whether a row is what the receiver draws for pixels that did not come: magenta and black, and nothing else.
fn is_hatched(row: &[u8]) -> bool {
    let mut pixels = row.chunks_exact(3);
    let marked = pixels.clone().filter(|pixel| *pixel == MISSING).count();
    marked > 0
        && 2 * marked <= pixels.len() + 4
        && pixels.all(|pixel| pixel == MISSING || pixel == [0, 0, 0])
}

fn verdict(faults: &[String]) -> Outcome<Tally> {
    if faults.is_empty() {
        Ok(Tally::PASSED)
    } else {
        Err(Failure::incomplete(faults.join("; ")))
    }
}

#[cfg(test)]
mod tests {
    use super::{far_from_reference, is_hatched};
    use serde_json::json;

    #[test]
    fn the_limits_bite() {
        let near = json!({ "code_error_max": 1, "code_error_over_one_share": 0.0,
                           "code_error_share": 0.01, "class_flips": 20 });
        assert!(far_from_reference(&near).is_empty());
        for (field, value) in [
            ("code_error_max", json!(2)),
            ("code_error_over_one_share", json!(1e-6)),
            ("code_error_share", json!(0.0101)),
            ("class_flips", json!(21)),
            ("class_flips", json!(null)),
        ] {
            let mut far = near.clone();
            far[field] = value;
            assert_eq!(far_from_reference(&far).len(), 1, "{field}");
        }
    }

    #[test]
    fn a_hatch_is_told_from_a_picture_with_its_colours() {
        let hatch: Vec<u8> = (0..32)
            .flat_map(|x| {
                if x / 4 % 2 == 0 {
                    [255, 0, 255]
                } else {
                    [0; 3]
                }
            })
            .collect();
        assert!(is_hatched(&hatch));
        assert!(!is_hatched(&[0; 96]), "black");
        assert!(!is_hatched(&[255, 0, 255].repeat(32)), "magenta");
        let mut picture = hatch;
        picture[30] = 9;
        assert!(!is_hatched(&picture));
    }
}
