//! `docs/trade.md`.

use std::fmt::Write as _;

use crate::plot;
use crate::row::Row;

/// The cores in their order, with what a column of them is called.
pub const CORES: [(&str, &str); 5] = [
    ("cortex-m0", "M0"),
    ("cortex-m0plus", "M0+"),
    ("cortex-m3", "M3"),
    ("cortex-m4f", "M4F"),
    ("rv32imc", "RV32IMC"),
];

/// Models in their order, with a title.
const MODELS: [(&str, &str); 22] = [
    ("metallic-phong", "Metallic Phong"),
    ("metal", "Metal, three channels with Fresnel's factor"),
    ("patch", "Basic patch"),
    ("patch-exponential", "Exponential patch"),
    ("profile", "Patch mixture with a tabulated profile"),
    ("phong", "Reciprocal Phong, and the p-model"),
    ("retro-phong", "Retro-reflective metallic Phong"),
    ("lambert", "Lambert"),
    ("generalised-lambert", "Generalised Lambert, three channels"),
    ("plastic", "Plastic and ceramic, three channels"),
    (
        "patch-metal",
        "Exponential patch with Fresnel's factor, three channels",
    ),
    ("metallic-paint", "Metallic paint, three channels"),
    ("srgb8", "Linear light to an 8-bit sRGB code, one channel"),
    (
        "nothing",
        "A function that gives back what it is given: a call and its frame",
    ),
    ("palette", "Light of 16 bits to RGB565 of one tint"),
    ("rgb565", "Three channels of linear light to RGB565"),
    ("grey16", "A luminance to one of 16 greys"),
    ("three dot products", "Three dot products: N·L, N·V, L·V"),
    ("versine", "N, L and V to 1 − R·V"),
    (
        "sphere light",
        "A light's tables for a sphere's rows, made anew, and one pixel",
    ),
    (
        "sphere normal",
        "A sphere's normal at a point of the picture",
    ),
    ("sphere", "A sphere's pixel to RGB565, normal included"),
];

const HEAD: &str = "# Error against cost

Made by `cargo xtask measure`; `cargo xtask test` fails when it is out of date.

What is measured: one light, reflected radiance as exposed linear light with 24 fraction bits, which every display's encoding starts from; material and gain constants in flash; the call included, what prepares its arguments left out. A kernel with the gain in its table gives 16 bits a channel instead, in registers; its error is that of the middle of their step. Directions go in as the arithmetic holds them, behind pointers, those of 16 bits by value. Each kernel is linked alone: its bytes are those of the function, all that it calls, and its constants.

* **Cycles** are the mean over directions within the lobe whose larger cosine is at least 1e-3 (both cosines in world space), in brackets the most of any call: beside the lobe also at the mirror direction, at grazing, anywhere above the horizon and below it. 64 calls in the mean and 48 others for fixed point, 16 and 16 where floats are emulated. Every result was compared, bit by bit, with the host's.
* Cycles on Cortex-M are **estimates**: executed instructions weighed with Arm's published timings at zero wait states ([measure/counter](../measure/counter/README.md) says what is modelled). M0 and M0+ have the single-cycle multiplier; with the 32-cycle one in the second table. Those of M0+ have a second source, rp2040js, an emulator of the RP2040: `cargo xtask test --only \"second source\"` runs every kernel in both, and each instruction takes the same cycles but for a PUSH of LR, which rp2040js leaves uncounted. Those of M0, M3 and M4F have none.
* Cycles on RV32IMC are **exact**: those of Ibex, simulated from its RTL, with a single-cycle multiplier, the branch-target ALU, the write-back stage and a memory that answers in the next cycle.
* **Error** is the arithmetic error of the displayed 8-bit sRGB code in LSB (see [conventions.md](conventions.md)), 0.50 being perfect rounding: the greatest over 2000 pairs within the lobe (cosines down to 1e-8), and the greatest over these and four further sets, at the mirror direction, at grazing, anywhere, and outside. In world space it is over pairs whose cosines are at least 1e-3, and outside. Then the share of codes within the lobe that are off by one, and by more.
* The pixels of a sphere are graded in levels of RGB565, over every pixel of a sphere of 200; where rows are shaded (`LitSphere`), over all pixels of 600 tiles of 64 by 16, and cycles are those of a pixel of a tile whose middle is in the lobe, everything that a picture begins with included. Of the exponent 0, whose light ends at once at α = 90°, pixels with |cosα| below 0.004 are not graded.
* What kernels were to cost, and where their cycles go, is in [goals.md](goals.md).
* K = 1 puts the peak at full scale; K = c is unit irradiance on the model's own peak.
";

/// The heading over a model.
///
/// # Panics
/// If it has none.
#[must_use]
pub fn title(model: &str) -> &'static str {
    let known = MODELS.iter().find(|(name, _)| *name == model);
    known.unwrap_or_else(|| panic!("{model} has no heading")).1
}

/// The whole document.
#[must_use]
pub fn markdown(rows: &[Row]) -> String {
    let mut text = HEAD.to_owned();
    let compilers: Vec<&str> = distinct(rows.iter().map(|row| row.compiler.as_str()));
    let _ = writeln!(text, "\nCompiler: {}.", compilers.join("; "));
    for (core, name) in CORES {
        if rows.iter().any(|row| row.core == core) {
            let _ = write!(text, "\n![Pareto fronts on {name}]({})", plot::file(core));
        }
    }
    text.push('\n');
    for (model, title) in MODELS {
        let of_model: Vec<_> = rows.iter().filter(|row| row.model == model).collect();
        if !of_model.is_empty() {
            let _ = write!(text, "\n## {title}\n\n{}", table(&of_model));
        }
    }
    let _ = write!(
        text,
        "\n## Beyond the lobe, below the horizon, and with the slow multiplier\n\n\
         Mean cycles of directions beyond the lobe / below the horizon. For M0 and M0+ then the mean \
         within the lobe where a multiplication takes 32 cycles.\n\n{}",
        outside(rows)
    );
    text
}

/// One table: a line for each kernel, a column for each core.
#[must_use]
pub fn table(rows: &[&Row]) -> String {
    let cores = cores(rows);
    let mut text = String::from("| parameters | arithmetic | how | K |");
    for (_, name) in &cores {
        let _ = write!(text, " {name} |");
    }
    text.push_str(" error, in the lobe | anywhere | off by one | by more | bytes of code (M0+ / M3) | of tables | of stack (M0+ / M3) | kernel |\n|");
    text.push_str(&" --- |".repeat(cores.len() + 12));
    text.push('\n');
    for kernel in distinct(rows.iter().map(|row| row.kernel.as_str())) {
        let of_kernel: Vec<_> = rows.iter().filter(|row| row.kernel == kernel).collect();
        let row = of_kernel[0];
        let _ = write!(
            text,
            "| {} | `{}` | {} | {} |",
            row.parameters, row.arithmetic, row.variant, row.exposure
        );
        for (core, _) in &cores {
            match of_kernel.iter().find(|row| row.core == *core) {
                Some(row) => {
                    let _ = write!(text, " {:.0} ({}) |", row.cycles_mean, row.cycles_worst);
                }
                None => text.push_str(" |"),
            }
        }
        let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.2}"));
        let share = |value: Option<f64>| {
            value.map_or("–".into(), |value| format!("{:.1} %", 100.0 * value))
        };
        let two = |value: fn(&Row) -> u64| {
            let of = |core: &str| of_kernel.iter().find(|row| row.core == core);
            let both = ["cortex-m0plus", "cortex-m3"].map(of);
            let text = both.map(|row| row.map_or("–".into(), |row| value(row).to_string()));
            text.join(" / ")
        };
        let _ = writeln!(
            text,
            " {} | {} | {} | {} | {} | {} | {} | `{kernel}` |",
            number(row.lsb_error_max),
            number(row.lsb_error_anywhere),
            share(row.code_error_share),
            share(row.code_error_over_one_share),
            two(|row| row.code_bytes),
            row.flash_table_bytes,
            two(|row| row.stack_bytes),
        );
    }
    text
}

fn outside(rows: &[Row]) -> String {
    let rows: Vec<_> = rows
        .iter()
        .filter(|row| row.exposure == "1" && row.cycles_outside.is_some())
        .collect();
    let cores = cores(&rows);
    let mut text = String::from("| model | parameters | arithmetic | how |");
    for (_, name) in &cores {
        let _ = write!(text, " {name} |");
    }
    text.push_str(" M0, slow | M0+, slow |\n|");
    text.push_str(&" --- |".repeat(cores.len() + 6));
    text.push('\n');
    for kernel in distinct(rows.iter().map(|row| row.kernel.as_str())) {
        let of = |core: &str| rows.iter().find(|r| r.kernel == kernel && r.core == core);
        let Some(row) = rows.iter().find(|row| row.kernel == kernel) else {
            continue;
        };
        let _ = write!(
            text,
            "| `{}` | {} | `{}` | {} |",
            row.model, row.parameters, row.arithmetic, row.variant
        );
        let mean = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.0}"));
        for (core, _) in &cores {
            let (beyond, unlit) =
                of(core).map_or((None, None), |row| (row.cycles_outside, row.cycles_unlit));
            let _ = write!(text, " {} / {} |", mean(beyond), mean(unlit));
        }
        for core in ["cortex-m0", "cortex-m0plus"] {
            let slow = of(core).and_then(|row| row.cycles_mean_slow_multiplier);
            let _ = write!(text, " {} |", mean(slow));
        }
        text.push('\n');
    }
    text
}

/// The cores that rows are of, in their order.
fn cores(rows: &[&Row]) -> Vec<(&'static str, &'static str)> {
    CORES
        .into_iter()
        .filter(|(core, _)| rows.iter().any(|row| row.core == *core))
        .collect()
}

/// Each once, in the order of their first appearance.
fn distinct<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for name in names {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}
