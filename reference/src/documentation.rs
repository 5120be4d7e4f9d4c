//! The table of all models, docs/models.md, generated where it holds figures.

use crate::measured::{Measured, measure};
use crate::models::ALL;
use crate::models::entry::Claim;
use crate::models::registry::NAMED_ONLY;
use crate::sampling::{Efficiency, variance_table};
use std::fmt::Write as _;

/// Samples for each row of the table of variances.
const SAMPLES: u32 = 200_000;

/// What every parameter set of every model measures, in the order of [`ALL`].
pub fn measure_all() -> Vec<Vec<Measured>> {
    ALL.iter()
        .map(|m| {
            (m.examples)()
                .iter()
                .map(|e| measure(e.model.as_ref()))
                .collect()
        })
        .collect()
}

/// docs/models.md as text. Takes some seconds.
pub fn models_markdown() -> String {
    models_markdown_of(&measure_all())
}

/// The same from measurements that are at hand.
pub fn models_markdown_of(measured: &[Vec<Measured>]) -> String {
    let mut out = String::from(HEAD);
    let costs = crate::cost::kept();
    let phong = cost_of(&costs, "phong");
    for (entry, measured) in ALL.iter().zip(measured) {
        let examples = (entry.examples)();
        let energy: Vec<String> = examples
            .iter()
            .zip(measured)
            .map(|(e, m)| format!("{}: {}", e.parameters, energy(e.claim, m)))
            .collect();
        let cost = match (cost_of(&costs, entry.name), phong) {
            (Some(c), Some(p)) => format!("{:.1}", (c / p).max(0.0)),
            _ => "–".into(),
        };
        let grazing = measured.first().map_or(f64::NAN, |m| m.grazing.value);
        writeln!(
            out,
            "| `{}` | {} | {} | {} | {} | {:.4}; {} | {} | {} | {} |",
            entry.name,
            cell(entry.formula),
            cell(entry.parameters),
            if entry.reciprocal { "yes" } else { "no" },
            cell(&energy.join("; ")),
            grazing,
            cell(entry.grazing),
            cost,
            if entry.sampler.is_some() {
                "yes"
            } else {
                "–"
            },
            cell(entry.source),
        )
        .expect("writing to memory");
    }
    out.push_str("\n## Named only\n\nThe texts name these without defining them; they are not invented here.\n\n");
    for (name, why) in NAMED_ONLY {
        writeln!(out, "- {name}: {why}.").expect("writing to memory");
    }
    out.push_str(&cost_section(&costs));
    out.push_str(&variance_section());
    out
}

fn energy(claim: Claim, m: &Measured) -> String {
    let a = m.greatest.value;
    let digits = if a < 10.0 {
        format!("{a:.6}")
    } else {
        format!("{a:.2}")
    };
    let azimuth = if m.azimuth == 0.0 {
        String::new()
    } else {
        format!(", azimuth {}°", m.azimuth)
    };
    // Near the horizon the angles are those of the grid; elsewhere a tenth is enough.
    let angle = if m.degrees > 89.0 {
        format!("{}", m.degrees)
    } else {
        format!("{:.1}", m.degrees)
    };
    let angle = angle.strip_suffix(".0").unwrap_or(&angle);
    let said = if claim == Claim::Conserves {
        "yes"
    } else {
        "no"
    };
    format!("{said}, at most {digits} (at {angle}°{azimuth})")
}

/// A cell may not hold a bar.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn cost_of(costs: &[(String, f64)], name: &str) -> Option<f64> {
    costs.iter().find(|(n, _)| n == name).map(|(_, c)| *c)
}

fn cost_section(costs: &[(String, f64)]) -> String {
    let ratio = |a: &str, b: &str| match (cost_of(costs, a), cost_of(costs, b)) {
        (Some(a), Some(b)) => format!("{:.2}", a / b),
        _ => "–".into(),
    };
    let comments: Vec<&str> = crate::cost::DATA
        .lines()
        .filter_map(|l| l.strip_prefix("# "))
        .collect();
    format!(
        "\n## Cost beside the thesis' claims\n\n{}\n\n\
         | claim | here |\n| --- | --- |\n\
         | the patch model takes practically the time of Phong–Blinn (4.8) | exponential patch / Blinn {}; basic patch / Blinn {} |\n\
         | the patch model takes half of Ward's time (4.8) | exponential patch / Ward {}; basic patch / Ward {} |\n\
         | Ward is simpler than Cook–Torrance (1.2.5) | Cook–Torrance / Ward {} |\n\
         | metallic Phong costs hardly more than Phong (3.5.1) | metallic Phong / Phong {} |\n",
        comments.join(" "),
        ratio("patch_exponential", "blinn"),
        ratio("patch", "blinn"),
        ratio("patch_exponential", "ward"),
        ratio("patch", "ward"),
        ratio("cook_torrance", "ward"),
        ratio("metallic_phong", "phong"),
    )
}

fn variance_section() -> String {
    let mut out = format!(
        "\n## Sampling patches: variance times cost\n\n\
         One sample's variance times its cost, counted in random numbers, over {SAMPLES} samples \
         with fixed seeds; the light is uniform (radiance 1) or a lamp (cos⁸ about 50° from \
         the normal). \"redraw\" draws the radius, if there is one, and the point again after \
         each miss: its weights are equal, so that under uniform light there is no variance at \
         all. \"two-step\" is the sampler as printed, one radius for all tries; \"roulette\" \
         rejects what misses; \"cosine\" knows nothing of the model.\n\n\
         | model, angle of V | sampler | numbers | mean, uniform | variance | × numbers | mean, lamp | variance | × numbers |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for row in variance_table(SAMPLES) {
        let light =
            |e: Efficiency| format!("{:.4} | {:.5} | {:.4}", e.mean, e.variance, e.product());
        writeln!(
            out,
            "| {} | {} | {:.2} | {} | {} |",
            row.model,
            row.way,
            row.uniform.numbers,
            light(row.uniform),
            light(row.lamp)
        )
        .expect("writing to memory");
    }
    out
}

const HEAD: &str = "<!-- Made by `cargo run --release -p microbrdf-reference --example models_markdown -- docs/models.md`. Don't edit. -->\n\
# Models\n\n\
Every model of the reference crate, one file each in `reference/src/models/`. Equation \
numbers mean A. Neumann, *Constructions of Bidirectional Reflection Distribution \
Functions*, TU Wien 2001. c_n = (n + 2)/2π; α is the angle between R and V, δ the one \
between H and N, m the patch metric, Θmin the smaller of the angles of L and V.\n\n\
- **Energy**: the greatest albedo of any channel that was found at angles of incidence up to \
89.9995° (0, 45° and 90° of azimuth for anisotropic models), and where; by quadrature, \
relative error below 1e-6 except for measured tables (tested).\n\
- **Grazing**: the albedo at 89.9° for the first parameters, and what happens there.\n\
- **Cost**: instructions of one evaluation in f64, relative to reciprocal Phong's, for the \
first parameters.\n\
- **Sampler**: whether the texts give importance sampling, for the model or for what it is a \
sum of; it is then implemented, and tested against its density by a million samples.\n\n\
| model | f(L, V) | parameters | reciprocal | conserves energy? | grazing | cost | sampler | source |\n\
| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
