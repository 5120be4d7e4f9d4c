//! From what was measured of the small scenes to what single things cost.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use microbrdf_scene::HostArithmetic;
use microbrdf_sim::budget::bytes::Contents;
use microbrdf_sim::budget::fit::{Sample, fit, sum};
use microbrdf_sim::budget::measured::{Board, InArithmetic, Measured};
use microbrdf_sim::budget::{row_buffers, steps};
use microbrdf_sim::with_arithmetic;
use serde::Deserialize;
use serde_json::Value;

use crate::calls;

/// What `cargo xtask forecast` found.
#[derive(Debug, Deserialize)]
pub struct Found {
    /// What compiled the scenes.
    compiler: String,
    /// Every how many rows one was counted.
    every: usize,
    /// The boards, without costs.
    boards: Vec<OfBoard>,
}

#[derive(Debug, Deserialize)]
struct OfBoard {
    name: String,
    core: String,
    flash: u64,
    ram: u64,
    hz: u64,
    baud: u64,
    /// What the counter wrote of packing.
    packing: PathBuf,
    scenes: Vec<OfScene>,
}

#[derive(Debug, Deserialize)]
struct OfScene {
    scene: PathBuf,
    arithmetic: String,
    flash: u64,
    ram: u64,
    stack: Option<u64>,
    /// What the counter wrote of its rows.
    rows: PathBuf,
}

/// A scene, its contents, and the steps of its rows.
struct Known<'a> {
    found: &'a OfScene,
    width: u16,
    contents: Contents,
    rows: Vec<Sample>,
}

/// The costs of everything, printing how well they agree.
pub fn fitted(found: &Found, each: bool) -> Result<Measured> {
    let boards = found
        .boards
        .iter()
        .map(|board| of_board(board, found.every, each).with_context(|| board.name.clone()))
        .collect::<Result<_>>()?;
    Ok(Measured {
        compiler: found.compiler.clone(),
        boards,
    })
}

/// What is known, with what was found last in its place.
pub fn merged(mut known: Measured, fresh: Measured) -> Measured {
    known.compiler = fresh.compiler;
    for mut board in fresh.boards {
        let old = known.boards.iter().position(|old| old.name == board.name);
        if let Some(index) = old {
            let mut all = known.boards.remove(index).arithmetics;
            all.append(&mut board.arithmetics);
            board.arithmetics = all;
        }
        known.boards.push(board);
    }
    known.boards.sort_by(|a, b| a.name.cmp(&b.name));
    known
}

fn of_board(board: &OfBoard, every: usize, each: bool) -> Result<Board> {
    let cycles = cycles(&board.packing, &board.core)?;
    let packing = calls::packing(&cycles).context("packing takes two calls")?;
    let mut scenes: BTreeMap<&str, Vec<Known<'_>>> = BTreeMap::new();
    for found in &board.scenes {
        let known =
            known(found, &board.core, every).with_context(|| found.scene.display().to_string())?;
        scenes.entry(&found.arithmetic).or_default().push(known);
    }
    let arithmetics = scenes
        .into_iter()
        .map(|(arithmetic, known)| {
            let costs = of_arithmetic(&known)?;
            print(board, arithmetic, &known, &costs, each)?;
            Ok((arithmetic.to_owned(), costs))
        })
        .collect::<Result<_>>()?;
    Ok(Board {
        name: board.name.clone(),
        core: board.core.clone(),
        flash: board.flash,
        ram: board.ram,
        hz: board.hz,
        baud: board.baud,
        packing,
        arithmetics,
    })
}

fn known<'a>(found: &'a OfScene, core: &str, every: usize) -> Result<Known<'a>> {
    let (description, name) = calls::read(&found.scene, &found.arithmetic)?;
    let height = usize::from(description.camera.height);
    let (contents, counted) = with_arithmetic!(name, A => {
        let prepared = description
            .prepare::<A>()
            .map_err(|error| anyhow!(error))?;
        counted(&prepared, calls::rows(height, every))
    });
    let cycles = cycles(&found.rows, core)?;
    anyhow::ensure!(
        cycles.len() == counted.len(),
        "not as many rows were counted"
    );
    // Rows are added up: an error counts beside the picture's mean.
    let scale = cycles.iter().sum::<f64>() / cycles.len().max(1) as f64;
    let rows = counted
        .into_iter()
        .zip(cycles)
        .map(|(counts, measured)| Sample {
            counts,
            measured,
            scale,
        })
        .collect();
    Ok(Known {
        found,
        width: description.camera.width,
        contents,
        rows,
    })
}

type Counts = BTreeMap<String, f64>;

fn counted<A: HostArithmetic>(
    prepared: &microbrdf_scene::Prepared<A>,
    rows: impl Iterator<Item = usize>,
) -> (Contents, Vec<Counts>) {
    let by_name = |steps: steps::Steps| {
        let mut counts = Counts::new();
        for (step, times) in steps {
            *counts.entry(step.name()).or_default() += times as f64;
        }
        counts
    };
    let rows = steps::of_rows(prepared, rows);
    (
        Contents::of(prepared),
        rows.into_iter().map(by_name).collect(),
    )
}

fn of_arithmetic(known: &[Known<'_>]) -> Result<InArithmetic> {
    let code: Vec<_> = known
        .iter()
        .map(|known| {
            let code = known.found.flash as f64 - known.contents.tables() as f64;
            Sample::alone(known.contents.code.clone(), code)
        })
        .collect();
    let stack: Vec<_> = known
        .iter()
        .filter_map(|known| {
            let stack = known.found.stack? as f64;
            Some(Sample::alone(known.contents.code.clone(), stack))
        })
        .collect();
    let steps: Vec<_> = known.iter().flat_map(|known| known.rows.clone()).collect();
    let ram = known
        .iter()
        .map(|known| known.found.ram.checked_sub(row_buffers(known.width)))
        .max()
        .flatten()
        .context("RAM holds no row")?;
    Ok(InArithmetic {
        code: fit(&code),
        ram,
        stack: fit(&stack),
        steps: fit(&steps),
    })
}

/// Cycles of each call on a core.
fn cycles(path: &Path, core: &str) -> Result<Vec<f64>> {
    let text = fs::read(path).with_context(|| path.display().to_string())?;
    let counts: Value = serde_json::from_slice(&text)?;
    let cycles = counts[0]["cycles"][core]["row"].as_array();
    let cycles = cycles.with_context(|| format!("{}: no {core}", path.display()))?;
    cycles
        .iter()
        .map(|cycles| cycles.as_f64().context("no number"))
        .collect()
}

/// How far the sums are from what was measured.
fn print(
    board: &OfBoard,
    arithmetic: &str,
    known: &[Known<'_>],
    costs: &InArithmetic,
    each: bool,
) -> Result<()> {
    let absent = |name: String| anyhow!("{name} has no cost");
    let mut worst = [
        (0.0, String::new()),
        (0.0, String::new()),
        (0.0, String::new()),
    ];
    for known in known {
        let Known {
            found,
            contents,
            rows,
            ..
        } = known;
        let code = sum(&costs.code, &contents.code).map_err(absent)? + contents.tables() as f64;
        let mut cycles = [0.0; 2];
        for row in rows {
            cycles[0] += sum(&costs.steps, &row.counts).map_err(absent)?;
            cycles[1] += row.measured;
        }
        let stack: f64 = contents
            .code
            .iter()
            .map(|(name, count)| costs.stack.get(name).map_or(0.0, |cost| cost * count))
            .sum();
        let pairs = [
            (code, found.flash as f64),
            (cycles[0], cycles[1]),
            (stack, found.stack.map_or(stack, |stack| stack as f64)),
        ];
        let name = found
            .scene
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy();
        if each {
            let pairs = pairs.map(|(forecast, measured)| {
                format!(
                    "{measured:.0} {:+.1} %",
                    100.0 * (forecast / measured - 1.0)
                )
            });
            println!("{name}, {arithmetic}: {}", pairs.join(", "));
        }
        for ((forecast, measured), worst) in pairs.into_iter().zip(&mut worst) {
            let off: f64 = forecast / measured - 1.0;
            if off.abs() > f64::abs(worst.0) {
                *worst = (off, name.to_string());
            }
        }
    }
    for ((off, name), what) in worst.iter().zip(["flash", "cycles", "stack"]) {
        println!(
            "{}, {arithmetic}: {what} of {} small scenes within {:.1} %, farthest {name}",
            board.name,
            known.len(),
            100.0 * off
        );
    }
    Ok(())
}
