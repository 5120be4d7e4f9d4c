//! Joins what was counted on the cores with the errors found on the host.

use std::collections::BTreeMap;

use microbrdf_kernels::{Kernel, kernels};
use serde::Deserialize;

use crate::errors::Errors;
use crate::goals::{self, Instruction, Listings};
use crate::row::Row;

/// The name under which a counter reports the slow multiplier of a core.
const SLOW: &str = " (32-cycle multiplier)";
/// The core whose cycles are no estimate.
const EXACT: &str = "rv32imc";

/// What a counter wrote of one kernel.
#[derive(Debug, Deserialize)]
pub struct Counted {
    kernel: String,
    code_bytes: u64,
    table_bytes: u64,
    ram_bytes: u64,
    stack_bytes: u64,
    instructions: BTreeMap<String, Vec<u64>>,
    clock_models: BTreeMap<String, String>,
    cycles: BTreeMap<String, BTreeMap<String, Vec<u64>>>,
    #[serde(default)]
    listing: Vec<Instruction>,
}

/// The listings of kernels that have goals.
#[must_use]
pub fn listings(counted: &[Counted]) -> Listings {
    let mut listings = Listings::new();
    for counted in counted {
        if goals::is_listed(&counted.kernel) && !counted.listing.is_empty() {
            let kernel = kernels().find(|kernel| kernel.name == counted.kernel);
            let pixels = kernel.map_or(1, Kernel::pixels) as f64;
            let of_pixel = |line: &Instruction| line.divided(pixels);
            let of_targets = listings.entry(counted.kernel.clone()).or_default();
            of_targets.push(counted.listing.iter().map(of_pixel).collect());
        }
    }
    listings
}

/// The rows of everything that was counted, in the order of the kernels; only
/// of `core`, if one is named.
#[must_use]
pub fn rows(
    counted: &[Counted],
    errors: &[(String, Vec<Errors>)],
    core: Option<&str>,
    compiler: &str,
) -> Vec<Row> {
    let mut rows = Vec::new();
    for kernel in kernels() {
        let errors = errors
            .iter()
            .find(|(name, _)| name == kernel.name)
            .map_or(&[][..], |(_, errors)| errors);
        for counted in counted.iter().filter(|c| c.kernel == kernel.name) {
            let named = |name: &&String| core.is_none_or(|core| core == name.as_str());
            let plain = |name: &&String| !name.ends_with(SLOW);
            for core in counted.cycles.keys().filter(plain).filter(named) {
                let row = row(kernel, counted, core, compiler);
                rows.extend(with_errors(&row, errors));
            }
        }
    }
    rows
}

fn row(kernel: &Kernel, counted: &Counted, core: &str, compiler: &str) -> Row {
    let cycles = &counted.cycles[core];
    let slow = counted.cycles.get(&format!("{core}{SLOW}"));
    // Of a pixel, where a call shades a row of them.
    let pixels = kernel.pixels() as f64;
    let mean = |counts: &[u64]| mean(counts).map(|mean| rounded(mean / pixels, 10.0));
    let group = |name: &str| cycles.get(name).and_then(|cycles| mean(cycles));
    Row {
        kernel: kernel.name.to_owned(),
        model: kernel.model.to_owned(),
        parameters: kernel.fields.to_owned(),
        arithmetic: kernel.arithmetic.to_owned(),
        variant: kernel.variant.to_owned(),
        core: core.to_owned(),
        exposure: kernel.exposure.to_owned(),
        encoding: if kernel.model == "sphere" {
            "rgb565"
        } else {
            "srgb"
        }
        .to_owned(),
        samples: "lobe".to_owned(),
        cycles_mean: group("lobe").unwrap_or_default(),
        cycles_worst: (cycles.values().flatten().copied().max().unwrap_or_default())
            .div_ceil(kernel.pixels() as u64),
        cycles_outside: group("beyond"),
        cycles_unlit: group("unlit"),
        cycles_mean_slow_multiplier: slow.and_then(|slow| mean(slow.get("lobe")?)),
        instructions_mean: counted
            .instructions
            .get("lobe")
            .and_then(|counts| mean(counts))
            .unwrap_or_default(),
        code_bytes: counted.code_bytes,
        flash_table_bytes: counted.table_bytes,
        ram_bytes: counted.ram_bytes,
        stack_bytes: counted.stack_bytes,
        lsb_error_max: None,
        lsb_error_anywhere: None,
        code_error_share: None,
        code_error_over_one_share: None,
        estimate: core != EXACT,
        clock_model: counted.clock_models.get(core).cloned().unwrap_or_default(),
        compiler: compiler.to_owned(),
    }
}

/// A row for each set of samples; as it is, where there is none.
fn with_errors(row: &Row, errors: &[Errors]) -> Vec<Row> {
    if errors.is_empty() {
        return vec![row.clone()];
    }
    let anywhere = errors.iter().map(|e| e.lsb_error_max).fold(0.0, f64::max);
    errors
        .iter()
        .map(|errors| Row {
            samples: errors.samples.clone(),
            lsb_error_max: Some(rounded(errors.lsb_error_max, 1e3)),
            lsb_error_anywhere: Some(rounded(anywhere, 1e3)),
            code_error_share: Some(rounded(errors.code_error_share, 1e5)),
            code_error_over_one_share: Some(rounded(errors.code_error_over_one_share, 1e5)),
            ..row.clone()
        })
        .collect()
}

fn mean(counts: &[u64]) -> Option<f64> {
    let sum: u64 = counts.iter().sum();
    (!counts.is_empty()).then(|| rounded(sum as f64 / counts.len() as f64, 10.0))
}

/// To so many steps a unit.
fn rounded(value: f64, steps: f64) -> f64 {
    (value * steps).round() / steps
}
