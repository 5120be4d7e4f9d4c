//! `microbrdf budget`.

use std::fmt::Write as _;

use microbrdf_link::{Header, PixelFormat};
use microbrdf_scene::Description;
use serde_json::{Value, json};

use crate::budget::measured::{Board, Measured as Costs};
use crate::budget::{Added, Forecast, forecast};
use crate::cli::Budget;
use crate::exit::{Failure, Outcome};
use crate::measure::Measured;
use crate::{reference_picture, render, with_arithmetic};

/// Bits on a line for each byte: start, eight, stop.
const BITS: f64 = 10.0;

/// Forecasts the scene for one board, or for all.
pub fn run(arguments: &Budget) -> Outcome<()> {
    let costs = Costs::read()?;
    let boards: Vec<&Board> = match &arguments.board {
        Some(name) => vec![costs.board(name)?],
        None => {
            let knows = |board: &&Board| board.costs(arguments.arithmetic.name()).is_ok();
            costs.boards.iter().filter(knows).collect()
        }
    };
    for board in &boards {
        board.costs(arguments.arithmetic.name())?;
    }
    if boards.is_empty() {
        return Err(Failure::Usage(format!(
            "--arithmetic {}: was not measured on any board",
            arguments.arithmetic.name()
        )));
    }
    let description = Description::from_file(&arguments.scene)?;
    let frame = render::frame(&description, arguments.arithmetic)?;
    let exact = reference_picture::render(&description);
    let error = Measured::new(&frame.srgb(), &exact);
    let mut text = String::new();
    let mut reports = Vec::new();
    for board in boards {
        let found = with_arithmetic!(arguments.arithmetic, A => {
            forecast::<A>(&description, board, arguments.arithmetic.name())?
        });
        let header = Header {
            exposure: Some(description.exposure),
            board: &board.name,
            core: &board.core,
            compiler: &costs.compiler,
            arithmetic: arguments.arithmetic.name(),
            scene: &description.name,
            ..frame.header(PixelFormat::Srgb8)
        };
        let mut wire = Vec::new();
        frame
            .send(&mut wire, &header)
            .map_err(|error| Failure::Usage(error.to_string()))?;
        let scene = Scene {
            description: &description,
            arithmetic: arguments.arithmetic.name(),
            error: &error,
            wire: wire.len(),
        };
        if arguments.json {
            reports.push(scene.json(board, &found));
        } else {
            if !text.is_empty() {
                text.push('\n');
            }
            scene.write(&mut text, board, &found);
        }
    }
    if arguments.json {
        text = format!("{:#}\n", Value::Array(reports));
    }
    super::print(&text)
}

/// What of a budget does not depend on the board.
struct Scene<'a> {
    description: &'a Description,
    arithmetic: &'a str,
    error: &'a Measured,
    /// Bytes of a frame on the line.
    wire: usize,
}

impl Scene<'_> {
    fn pixels(&self) -> f64 {
        let camera = &self.description.camera;
        f64::from(camera.width) * f64::from(camera.height)
    }

    /// Frames a second of shading and packing alone, and over the line.
    fn rates(&self, board: &Board, found: &Forecast) -> (f64, f64) {
        let shading = board.hz as f64 / (self.pixels() * (found.cycles + found.packing));
        let line = board.baud as f64 / (BITS * self.wire as f64);
        (shading, line)
    }

    fn json(&self, board: &Board, found: &Forecast) -> Value {
        let (shading, line) = self.rates(board, found);
        let added = |added: &[Added]| -> Value {
            let entry = |added: &Added| {
                json!({
                    "name": added.name,
                    "flash_bytes": added.flash,
                    "cycles_per_pixel": added.cycles,
                })
            };
            added.iter().map(entry).collect()
        };
        json!({
            "board": board.name,
            "core": board.core,
            "arithmetic": self.arithmetic,
            "flash_bytes": found.flash,
            "table_bytes": found.tables,
            "ram_bytes": found.ram,
            "stack_bytes": found.stack,
            "cycles_per_pixel": found.cycles,
            "cycles_per_pixel_of_rows": found.rows,
            "packing_cycles_per_pixel": found.packing,
            "frame_bytes": self.wire,
            "frames_per_second": shading,
            "frames_per_second_on_line": line,
            "lsb_error_max": self.error.lsb_error_max,
            "code_error_share": self.error.off_by_one,
            "materials": added(&found.materials),
            "lights": added(&found.lights),
        })
    }

    fn write(&self, text: &mut String, board: &Board, found: &Forecast) {
        let (shading, line) = self.rates(board, found);
        let fits = |bytes: u64, of: u64| if bytes > of { "  TOO LARGE" } else { "" };
        let _ = writeln!(
            text,
            "{} on {} ({}, {} MHz), {}\n\
             flash       {} of {} bytes, {} of them tables{}\n\
             RAM         {} of {} bytes, {} of them stack{}\n\
             cycles      {:.0} a pixel (estimate): {:.0} shading, {:.0} packing\n\
             frames      {} a second shaded, {} over the line ({} bytes at {} baud)\n\
             error       {:.2} codes at most, {:.2} % of the codes off by one",
            self.description.name,
            board.name,
            board.core,
            board.hz / 1_000_000,
            self.arithmetic,
            found.flash,
            board.flash,
            found.tables,
            fits(found.flash, board.flash),
            found.ram + found.stack,
            board.ram,
            found.stack,
            fits(found.ram + found.stack, board.ram),
            found.cycles + found.packing,
            found.cycles,
            found.packing,
            digits(shading),
            digits(line),
            self.wire,
            board.baud,
            self.error.lsb_error_max,
            100.0 * self.error.off_by_one,
        );
        let _ = writeln!(
            text,
            "{:24} {:>14} {:>15}",
            "adds", "bytes of flash", "cycles a pixel"
        );
        for Added {
            name,
            flash,
            cycles,
        } in found.materials.iter().chain(&found.lights)
        {
            let _ = writeln!(text, "  {name:22} {flash:>14} {cycles:>15.0}");
        }
    }
}

/// Three digits.
fn digits(value: f64) -> String {
    let places = 2 - value.abs().max(1e-9).log10().floor() as i32;
    format!("{value:.*}", places.clamp(0, 9) as usize)
}
