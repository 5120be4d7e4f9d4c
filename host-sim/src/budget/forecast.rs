//! The forecast for one scene.

use microbrdf_link::{PixelFormat, max_row_wire_bytes};
use microbrdf_scene::{Description, HostArithmetic, Prepared};

use super::bytes::Contents;
use super::fit::{Costs, sum};
use super::measured::{Board, InArithmetic};
use super::steps::{self, Step, Steps, light_kind};
use crate::exit::{Failure, Outcome};

/// What a scene will take.
#[derive(Clone, Debug, PartialEq)]
pub struct Forecast {
    /// Bytes of flash.
    pub flash: u64,
    /// Of these, tables of the scene.
    pub tables: u64,
    /// Bytes of RAM with a fixed place.
    pub ram: u64,
    /// Bytes of stack.
    pub stack: u64,
    /// Cycles a pixel, shading and encoding, an estimate as a core's timings are.
    pub cycles: f64,
    /// The same of each row by itself.
    pub rows: Vec<f64>,
    /// Cycles a pixel for putting it into packets.
    pub packing: f64,
    /// What each material adds, in the order of the scene's.
    pub materials: Vec<Added>,
    /// What each light adds.
    pub lights: Vec<Added>,
}

/// What one thing adds: how much less it would be without it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Added {
    /// A material's name, or a light's kind and number.
    pub name: String,
    /// Bytes of flash.
    pub flash: u64,
    /// Cycles a pixel, of all pixels of the picture.
    pub cycles: f64,
}

/// Bytes and cycles of a scene on a board.
///
/// # Errors
/// A material that the arithmetic does not take; a part of the scene of which
/// no cost was measured.
pub fn forecast<A: HostArithmetic>(
    description: &Description,
    board: &Board,
    arithmetic: &str,
) -> Outcome<Forecast> {
    let costs = board.costs(arithmetic)?;
    let prepared = description.prepare::<A>().map_err(Failure::Usage)?;
    let names = description.materials.iter().map(|(name, _)| name.clone());
    sums(&prepared, names, board, costs).map_err(|name| {
        Failure::Incomplete(format!(
            "what `{name}` costs in {arithmetic} on {} was not measured; \
             `cargo xtask forecast` does",
            board.name
        ))
    })
}

fn sums<A: HostArithmetic>(
    prepared: &Prepared<A>,
    names: impl Iterator<Item = String>,
    board: &Board,
    costs: &InArithmetic,
) -> Result<Forecast, String> {
    let flash = |prepared: &Prepared<A>| -> Result<f64, String> {
        let contents = Contents::of(prepared);
        Ok(sum(&costs.code, &contents.code)? + contents.tables() as f64)
    };
    let contents = Contents::of(prepared);
    let whole = flash(prepared)?;
    let side = microbrdf::shade::Samples::side(prepared.samples);
    let (width, height) = (prepared.camera.width / side, prepared.camera.height / side);
    let pixels = f64::from(width) * f64::from(height);
    let rows = steps::of_rows(prepared, 0..usize::from(height));
    let cost = |row: &Steps| -> Result<f64, String> {
        let named: Vec<_> = row
            .iter()
            .map(|(step, times)| (step.name(), *times as f64))
            .collect();
        let cycles = sum(
            &costs.steps,
            named.iter().map(|(name, times)| (name, times)),
        )?;
        Ok(cycles / f64::from(width))
    };
    let of_rows = rows.iter().map(cost).collect::<Result<_, _>>()?;
    let counted: Vec<(Step, f64)> = rows
        .into_iter()
        .flatten()
        .map(|(step, times)| (step, times as f64 / pixels))
        .collect();
    let cycles = |wanted: &dyn Fn(&Step) -> bool| -> Result<f64, String> {
        let some = counted.iter().filter(|(step, _)| wanted(step));
        let named: Vec<_> = some.map(|(step, times)| (step.name(), *times)).collect();
        sum(
            &costs.steps,
            named.iter().map(|(name, times)| (name, times)),
        )
    };
    let added =
        |name, less: Prepared<A>, wanted: &dyn Fn(&Step) -> bool| -> Result<Added, String> {
            Ok(Added {
                name,
                flash: (whole - flash(&less)?).round().max(0.0) as u64,
                cycles: cycles(wanted)?,
            })
        };
    let materials = names
        .enumerate()
        .map(|(index, name)| {
            let mut less = prepared.clone();
            less.coats.remove(index);
            added(name, less, &|step| step.material == Some(index))
        })
        .collect::<Result<_, _>>()?;
    let lights = (0..prepared.lights.len())
        .map(|index| {
            let name = format!("{} {}", light_kind(&prepared.lights[index]), index + 1);
            let mut less = prepared.clone();
            less.lights.remove(index);
            for part in less.coats.iter_mut().flat_map(|coat| &mut coat.parts) {
                part.gains.remove(index);
            }
            added(name, less, &|step| step.light == Some(index))
        })
        .collect::<Result<_, _>>()?;
    let bytes = PixelFormat::Srgb8.bytes_per_pixel();
    Ok(Forecast {
        flash: whole.round() as u64,
        tables: contents.tables() as u64,
        ram: costs.ram + row_buffers(width),
        stack: stack(&costs.stack, &contents),
        cycles: cycles(&|_| true)?,
        rows: of_rows,
        packing: board.packing * bytes as f64,
        materials,
        lights,
    })
}

/// Bytes of RAM for a row of pixels, and for the queue of its packets.
#[must_use]
pub fn row_buffers(width: u16) -> u64 {
    let row = PixelFormat::Srgb8.bytes_per_pixel() * usize::from(width);
    let queue = (max_row_wire_bytes(width, PixelFormat::Srgb8) + 1).next_power_of_two();
    (row.next_multiple_of(4) + queue) as u64
}

/// What is not known to take stack takes none.
fn stack(costs: &Costs, contents: &Contents) -> u64 {
    let cost = |(name, count): (&String, &f64)| costs.get(name).map_or(0.0, |cost| cost * count);
    contents.code.iter().map(cost).sum::<f64>().round() as u64
}
