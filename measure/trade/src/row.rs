//! `trade.json`: one row for each kernel, core and set of samples.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

/// One row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The kernel's symbol, in `measure/kernels`.
    pub kernel: String,
    /// The model, as in material files; or a step's name.
    pub model: String,
    /// The material's fields, as in material files.
    pub parameters: String,
    /// How numbers are represented.
    pub arithmetic: String,
    /// What sets the kernel apart within its arithmetic.
    pub variant: String,
    /// The core.
    pub core: String,
    /// `1` or `c`: K, or the model's peak.
    pub exposure: String,
    /// What errors are measured in: 8-bit codes of this encoding.
    pub encoding: String,
    /// The set of samples that the errors are over.
    pub samples: String,
    /// Mean over the lobe, where the larger cosine is at least 1e-3.
    pub cycles_mean: f64,
    /// The most that any call took.
    pub cycles_worst: u64,
    /// Mean over directions above the horizon and beyond the lobe.
    pub cycles_outside: Option<f64>,
    /// Mean over directions below the horizon.
    pub cycles_unlit: Option<f64>,
    /// As `cycles_mean`, with the 32-cycle multiplier that this core can have.
    pub cycles_mean_slow_multiplier: Option<f64>,
    /// Mean over the lobe.
    pub instructions_mean: f64,
    /// The function and all that it calls.
    pub code_bytes: u64,
    /// Constant data.
    pub flash_table_bytes: u64,
    /// Variables with a fixed place.
    pub ram_bytes: u64,
    /// The deepest stack of any call.
    pub stack_bytes: u64,
    /// Greatest |code − 255 · encoded reference|.
    pub lsb_error_max: Option<f64>,
    /// The greatest of all sets.
    pub lsb_error_anywhere: Option<f64>,
    /// Share of codes off by one.
    pub code_error_share: Option<f64>,
    /// Share of codes off by more.
    pub code_error_over_one_share: Option<f64>,
    /// Whether the cycles are an estimate from a table of timings.
    pub estimate: bool,
    /// Which table, or which configuration of the core's source.
    pub clock_model: String,
    /// What compiled it.
    pub compiler: String,
}

impl Row {
    /// The set of samples whose row stands for its kernel and core in
    /// documents; other sets only enter `lsb_error_anywhere`.
    #[must_use]
    pub fn shown_samples(&self) -> &'static str {
        if self.variant.starts_with("world space") {
            "lobe, cosines from 1e-3"
        } else {
            "lobe"
        }
    }
}

/// Reads rows.
///
/// # Errors
/// A file that is not there, or not of this form.
pub fn read(path: &Path) -> Result<Vec<Row>> {
    let text = fs::read_to_string(path).with_context(|| format!("reading {}", path.display()))?;
    serde_json::from_str(&text).with_context(|| format!("reading {}", path.display()))
}

/// The rows as JSON, each on a line.
///
/// # Errors
/// None that this form of data could cause.
pub fn json(rows: &[Row]) -> Result<String> {
    let lines: Vec<_> = rows
        .iter()
        .map(serde_json::to_string)
        .collect::<Result<_, _>>()?;
    Ok(format!("[\n{}\n]\n", lines.join(",\n")))
}
