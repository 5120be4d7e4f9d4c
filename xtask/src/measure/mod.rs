//! `cargo xtask measure`: cost and error of every kernel, core by core.

mod core;
mod images;
mod trade;

use std::fs;
use std::path::PathBuf;

use crate::board::Board;
use crate::failure::{During, Outcome};
use crate::layout::Layout;
use crate::toolchain::Cross;
pub use core::{CORES, Core};
pub use images::Library;
use trade::Trade;

/// What to measure.
#[derive(Debug, Clone, Default)]
pub struct Order {
    /// Only on this core.
    pub core: Option<String>,
    /// Only kernels with this in their names.
    pub only: Option<String>,
    /// Whether the budgets are to be set to what is found.
    pub set_budgets: bool,
}

impl Order {
    /// Whether everything is measured.
    pub fn is_whole(&self) -> bool {
        self.core.is_none() && self.only.is_none()
    }

    /// The cores asked for.
    pub fn cores(&self) -> Vec<Core> {
        let chosen = |core: &Core| self.core.as_ref().is_none_or(|name| name == core.name);
        CORES.into_iter().filter(chosen).collect()
    }

    /// Compiler targets of these cores, each once.
    pub fn targets(&self) -> Vec<&'static str> {
        let mut targets: Vec<_> = self.cores().iter().map(|core| core.target).collect();
        targets.dedup();
        targets
    }
}

/// Compiler targets of all boards and all cores, each once.
pub fn with_boards() -> Vec<&'static str> {
    let mut targets = Board::targets();
    for target in Order::default().targets() {
        if !targets.contains(&target) {
            targets.push(target);
        }
    }
    targets
}

/// Where everything that is measured lies.
pub fn folder(layout: &Layout) -> PathBuf {
    layout.target().join("measure")
}

/// `cargo xtask measure`.
pub fn command(layout: &Layout, cross: &Cross, order: &Order) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    run(layout, cross, order, false)?;
    let trade = Trade::build(layout, true)?;
    if order.is_whole() {
        trade.publish(order.set_budgets)?;
        println!("wrote docs/trade.md, its plots, and host-sim/data/trade.json");
    } else {
        trade.print()?;
        println!("only a part was measured: docs/trade.md is left as it is");
    }
    Ok(())
}

/// Compares what was measured last with what is kept, and with the budgets.
pub fn check(layout: &Layout) -> Outcome<()> {
    Trade::build(layout, true)?.check()
}

/// Runs what sums up many of the core's results in an unoptimised build for this
/// host and for every target, and compares that with what a release gives here.
pub fn compare_bits(layout: &Layout, cross: &Cross) -> Outcome<u32> {
    let folder = folder(layout);
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    Trade::build(layout, true)?.checksums()?;
    images::compare_unoptimised(layout)?;
    let targets = Order::default().targets();
    for target in &targets {
        Library::checksums(layout, target).link(layout, cross, target, true)?;
        core::compare(layout, target)?;
    }
    Ok(1 + targets.len() as u32)
}

/// Compares the cycles of every kernel on Cortex-M0+ with those of another emulator.
pub fn compare_cycles(layout: &Layout, cross: &Cross) -> Outcome<()> {
    let folder = folder(layout);
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    Trade::build(layout, true)?.calls("")?;
    let target = core::SECOND_SOURCE;
    Library::kernels(layout, target).link(layout, cross, target, true)?;
    core::second_source(layout)
}

/// Measures, and leaves `trade.json` in the folder.
pub fn run(layout: &Layout, cross: &Cross, order: &Order, quiet: bool) -> Outcome<()> {
    let folder = folder(layout);
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let trade = Trade::build(layout, quiet)?;
    trade.prepare(order.only.as_deref().unwrap_or_default())?;
    let mut counts = Vec::new();
    for target in order.targets() {
        Library::kernels(layout, target).link(layout, cross, target, quiet)?;
        counts.push(core::count(layout, target)?);
    }
    trade.join(&counts, order.core.as_deref(), cross)
}
