//! `budgets.toml`: what each kernel may cost on each core.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::{Context, Result};
use serde::Deserialize;

use crate::row::Row;

/// Mean and greatest cycles, bytes of code, of tables, of stack.
pub type Cost = [f64; 5];

/// What the figures of [`Cost`] are.
pub const NAMES: [&str; 5] = ["mean cycles", "most cycles", "code", "tables", "stack"];

/// The file.
#[derive(Debug, Deserialize)]
pub struct Budgets {
    /// What compiled the kernels when the budgets were set.
    pub compiler: String,
    /// By core, then by kernel.
    pub core: BTreeMap<String, BTreeMap<String, Cost>>,
}

impl Budgets {
    /// Reads the file's text.
    ///
    /// # Errors
    /// Text that is not of this form.
    pub fn read(text: &str) -> Result<Self> {
        toml::from_str(text).context("reading budgets.toml")
    }
}

/// What a row costs.
#[must_use]
pub fn cost(row: &Row) -> Cost {
    [
        row.cycles_mean,
        row.cycles_worst as f64,
        row.code_bytes as f64,
        row.flash_table_bytes as f64,
        row.stack_bytes as f64,
    ]
}

/// The file with every budget set to what rows cost.
#[must_use]
pub fn text(rows: &[Row]) -> String {
    let compiler = rows.first().map_or("", |row| row.compiler.as_str());
    let mut text = format!(
        "# What each kernel may cost on each core: mean cycles, most cycles, bytes of\n\
         # code, of tables, of stack. `cargo xtask test` fails where one costs more.\n\
         # Set by `cargo xtask measure --set-budgets`; one that is raised needs a line\n\
         # in CHANGELOG.md.\n\n\
         compiler = {compiler:?}\n"
    );
    let mut cores: BTreeMap<&str, Vec<&Row>> = BTreeMap::new();
    for row in rows {
        cores.entry(&row.core).or_default().push(row);
    }
    for (core, rows) in cores {
        let _ = writeln!(text, "\n[core.{core}]");
        for row in rows {
            let figures: Vec<_> = cost(row)
                .iter()
                .map(|figure| format!("{figure:.1}"))
                .collect();
            let _ = writeln!(text, "{} = [{}]", row.kernel, figures.join(", "));
        }
    }
    text
}
