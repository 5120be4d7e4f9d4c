//! How many times fewer cycles than `f32` with libm's `powf`.

use std::fmt::Write as _;

use crate::document::CORES;
use crate::row::Row;

/// What one would write without this project's core.
const PLAIN: &str = "powf of libm";
/// Greatest errors, in LSB of sRGB.
const WITHIN: [f64; 2] = [0.75, 0.55];
/// Cores that have goals at the greater of them, and the least factor on each.
const AT_LEAST: [(&str, f64); 2] = [("cortex-m0plus", 150.0), ("cortex-m4f", 6.0)];

/// The cheapest kernel of a parameter on a core within a bound.
struct Cheapest<'a> {
    row: &'a Row,
    factor: f64,
}

impl<'a> Cheapest<'a> {
    fn new(rows: &'a [Row], plain: &Row, core: &str, within: f64) -> Option<Self> {
        let alike = |row: &&Row| {
            row.core == core
                && row.model == plain.model
                && row.parameters == plain.parameters
                && row.exposure == plain.exposure
                && row.samples == "lobe"
        };
        let exact = |row: &&Row| {
            let errors = [row.lsb_error_max, row.lsb_error_anywhere];
            errors
                .into_iter()
                .all(|error| error.is_some_and(|error| error <= within))
        };
        let cost = rows
            .iter()
            .filter(alike)
            .find(|row| row.variant == PLAIN)?
            .cycles_mean;
        let row = (rows.iter().filter(alike).filter(exact))
            .min_by(|a, b| a.cycles_mean.total_cmp(&b.cycles_mean))?;
        Some(Self {
            row,
            factor: cost / row.cycles_mean,
        })
    }
}

/// What was written without this project's core, once for each parameter.
fn plain(rows: &[Row]) -> impl Iterator<Item = &Row> {
    rows.iter()
        .filter(|row| row.variant == PLAIN && row.core == AT_LEAST[0].0)
}

/// A section of the document.
pub fn markdown(rows: &[Row]) -> String {
    let goals = AT_LEAST.map(|(core, factor)| {
        let name = CORES.iter().find(|(of, _)| *of == core).map(|of| of.1);
        format!("{factor:.0} on {}", name.unwrap_or(core))
    });
    let mut text = format!(
        "\n## Beside `f32` with libm's `powf`\n\n\
         Metallic Phong in the shading frame at K = 1: how many times fewer cycles the cheapest \
         kernel takes whose error is within {:.2} LSB anywhere (goal: {}), and the cheapest within \
         {:.2}.\n\n| | within |",
        WITHIN[0],
        goals.join(", "),
        WITHIN[1],
    );
    for (_, name) in CORES {
        let _ = write!(text, " {name} | kernel |");
    }
    text.push_str("\n| --- | ---: |");
    text.push_str(&" ---: | --- |".repeat(CORES.len()));
    text.push('\n');
    for plain in plain(rows) {
        for within in WITHIN {
            let _ = write!(text, "| {} | {within:.2} |", plain.parameters);
            for (core, _) in CORES {
                match Cheapest::new(rows, plain, core, within) {
                    Some(Cheapest { row, factor }) => {
                        let _ = write!(text, " {factor:.1} | `{}` |", row.kernel);
                    }
                    None => text.push_str(" | none |"),
                }
            }
            text.push('\n');
        }
    }
    text
}

/// The goals that are missed on the cores that there are figures of.
pub fn missed(rows: &[Row]) -> Vec<String> {
    let mut faults = Vec::new();
    for plain in plain(rows) {
        for (core, at_least) in AT_LEAST {
            if !rows.iter().any(|row| row.core == core) {
                continue;
            }
            let factor = Cheapest::new(rows, plain, core, WITHIN[0]).map_or(0.0, |of| of.factor);
            if factor < at_least {
                faults.push(format!(
                    "{} on {core}: {factor:.1} times fewer cycles than {PLAIN}, the goal is {at_least}",
                    plain.parameters,
                ));
            }
        }
    }
    faults
}
