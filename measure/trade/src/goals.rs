//! `docs/goals.md`: what kernels were to cost, what they do cost, and where
//! the cycles go of those that cost more.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::{Deserialize, Serialize};

use crate::beside_libm;
use crate::document::CORES;
use crate::row::Row;

/// Cores that have goals.
const AIMED: [&str; 3] = ["cortex-m0plus", "cortex-m3", "cortex-m4f"];

/// A call and its frame alone.
const NOTHING: &str = "nothing";

/// What some kernels were to cost.
struct Goal {
    title: &'static str,
    /// The kernels; the first is listed.
    kernels: &'static [&'static str],
    /// How many of what is aimed at a kernel does in a call.
    at_once: f64,
    /// The most cycles on each of the aimed cores.
    at_most: [f64; 3],
}

const GOALS: [Goal; 7] = [
    Goal {
        title: "metallic Phong",
        kernels: &[
            "q15_metallic_phong_20_k1",
            "q15_metallic_phong_20_kc",
            "q15_metallic_phong_1_k1",
            "q15_metallic_phong_1_kc",
            "q15_metallic_phong_500_k1",
            "q15_metallic_phong_500_kc",
            "q15_metallic_phong_5000_k1",
        ],
        at_once: 1.0,
        at_most: [95.0, 80.0, 60.0],
    },
    Goal {
        title: "metal, three channels with Fresnel's factor",
        kernels: &[
            "q15_exposed_gold_20_k1",
            "q15_exposed_gold_20_kc",
            "q15_exposed_gold_500_k1",
            "q15_exposed_gold_500_kc",
        ],
        at_once: 1.0,
        at_most: [115.0, 100.0, 75.0],
    },
    Goal {
        title: "basic patch",
        kernels: &["q15_exposed_patch_k1", "q15_exposed_patch_kc"],
        at_once: 1.0,
        at_most: [45.0, 30.0, 30.0],
    },
    Goal {
        title: "exponential patch",
        kernels: &["q15_patch_exponential_k1", "q15_patch_exponential_kc"],
        at_once: 1.0,
        at_most: [120.0, 71.0, 58.0],
    },
    Goal {
        title: "linear to sRGB, one channel, within 0.60 LSB: a third of a pixel's call",
        kernels: &["srgb8_direct_pixel"],
        at_once: 3.0,
        at_most: [16.0, 14.0, 12.0],
    },
    Goal {
        title: "world-space N, L, V in, RGB out: with 20 KiB of tables, for n = 1 and 5000 with 36",
        kernels: &[
            "q15_direct_world_metallic_phong_20_k1",
            "q15_direct_world_metallic_phong_1_k1",
            "q15_direct_world_metallic_phong_20_kc",
            "q15_direct_world_metallic_phong_500_kc",
            "q15_direct_world_metallic_phong_5000_k1",
        ],
        at_once: 1.0,
        at_most: [190.0, 120.0, 70.0],
    },
    Goal {
        title: "whole sphere pixel to RGB565, any n, at most one level off: of a tile's 16 rows of 64",
        kernels: &[
            "q15_sphere_row_1",
            "q15_sphere_row_0",
            "q15_sphere_row_5000",
            "q15_sphere_row_500_kc",
            "q15_sphere_row_500",
            "q15_sphere_row_20",
            "q15_sphere_row_20_kc",
        ],
        at_once: 1.0,
        at_most: [60.0, 40.0, 36.0],
    },
];

/// A kernel's instructions, with what each took in a call within the lobe.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Instruction {
    /// As one would write it.
    pub text: String,
    /// How often it was executed in a call.
    pub executed: f64,
    /// Cycles that it took in a call, by core.
    pub cycles: BTreeMap<String, f64>,
}

impl Instruction {
    /// Of one of so many pixels.
    #[must_use]
    pub fn divided(&self, pixels: f64) -> Self {
        let cycles = self.cycles.iter();
        Self {
            text: self.text.clone(),
            executed: self.executed / pixels,
            cycles: cycles
                .map(|(core, cycles)| (core.clone(), cycles / pixels))
                .collect(),
        }
    }
}

/// The listings of kernels that have goals, by kernel and target.
pub type Listings = BTreeMap<String, Vec<Vec<Instruction>>>;

/// Whether a kernel's listing may be wanted.
#[must_use]
pub fn is_listed(kernel: &str) -> bool {
    GOALS
        .iter()
        .any(|goal| goal.kernels.first() == Some(&kernel))
}

/// The whole document.
#[must_use]
pub fn markdown(rows: &[Row], listings: &Listings) -> String {
    let mut text = String::from(
        "# What kernels were to cost\n\n\
         Made by `cargo xtask measure`; `cargo xtask test` fails when it is out of date. Mean cycles \
         as [trade.md](trade.md) defines them, estimates from Arm's published timings, of the cheapest \
         arithmetic that is exact enough (`q15`): the greatest of the kernels named. A \
         sample whose N·L lies below half a step of a 14-bit cosine is at the horizon and ends early: the \
         listings' first column shows how many.\n\n\
         | | kernels | M0+ | goal | M3 | goal | M4F | goal |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for goal in &GOALS {
        let _ = write!(text, "| {} | `{}` |", goal.title, goal.kernels.join("`, `"));
        for (core, at_most) in AIMED.into_iter().zip(goal.at_most) {
            let most = most(rows, goal, core);
            let mark = if most <= at_most { "" } else { " **missed**" };
            let digits = usize::from(goal.at_once > 1.0);
            let _ = write!(text, " {most:.digits$}{mark} | {at_most:.0} |");
        }
        text.push('\n');
    }
    let of_calls = |kernel| {
        AIMED
            .map(|core| format!("{:.0}", mean(rows, kernel, core)))
            .join("/")
    };
    let _ = write!(
        text,
        "\nA function that gives back what it is given (`{NOTHING}`) takes {} cycles: the call, and a frame \
         that the compiler's Thumb targets ask for in every function that needs a register more. One \
         channel encoded in a call of its own (`srgb8_direct`) takes {}, of these one shift and one load \
         from a table beside that.\n",
        of_calls(NOTHING),
        of_calls("srgb8_direct"),
    );
    text.push_str(&beside_libm::markdown(rows));
    for goal in &GOALS {
        let missed: Vec<_> = AIMED
            .into_iter()
            .zip(goal.at_most)
            .filter(|(core, at_most)| most(rows, goal, core) > *at_most)
            .collect();
        let Some(kernel) = goal.kernels.first() else {
            continue;
        };
        if !missed.is_empty() {
            let _ = write!(text, "\n## {}\n", goal.title);
        }
        for (core, _) in missed {
            let listing = listings
                .get(*kernel)
                .and_then(|of_targets| of_targets.iter().find(|listing| takes(listing, core)));
            let Some(listing) = listing else { continue };
            let _ = write!(
                text,
                "\n### `{kernel}` on {}\n\n{}How often each instruction is executed in a call within \
                 the lobe, of a tile for each pixel, and the cycles it takes; those that are executed less than once in \
                 fifty times are left out:\n\n{}",
                CORES
                    .iter()
                    .find(|(name, _)| *name == core)
                    .map_or("", |(_, title)| title),
                spent(listing, core, mean(rows, kernel, core)),
                lines(listing, core),
            );
        }
    }
    text
}

/// The goals that are missed on the cores that there are figures of.
#[must_use]
pub fn missed(rows: &[Row]) -> Vec<String> {
    let mut faults = beside_libm::missed(rows);
    for goal in &GOALS {
        for (core, at_most) in AIMED.into_iter().zip(goal.at_most) {
            let most = most(rows, goal, core);
            if most > at_most {
                faults.push(format!(
                    "{} on {core}: {most} cycles, the goal is {at_most}",
                    goal.title
                ));
            }
        }
    }
    faults
}

fn mean(rows: &[Row], kernel: &str, core: &str) -> f64 {
    rows.iter()
        .find(|row| row.kernel == kernel && row.core == core)
        .map_or(0.0, |row| row.cycles_mean)
}

fn most(rows: &[Row], goal: &Goal, core: &str) -> f64 {
    let means = goal.kernels.iter().map(|kernel| mean(rows, kernel, core));
    means.fold(0.0, f64::max) / goal.at_once
}

fn takes(listing: &[Instruction], core: &str) -> bool {
    listing.iter().any(|line| line.cycles.contains_key(core))
}

/// Cycles by what they are for.
fn spent(listing: &[Instruction], core: &str, mean: f64) -> String {
    let mut sums = BTreeMap::<&str, f64>::new();
    for line in listing {
        let cycles = line.cycles.get(core).copied().unwrap_or_default();
        *sums.entry(purpose(&line.text)).or_default() += cycles;
    }
    let executed: f64 = sums.values().sum();
    let mut parts = vec![format!("the call {:.0}", (mean - executed).max(0.0))];
    parts.extend(
        sums.iter()
            .map(|(purpose, cycles)| format!("{purpose} {cycles:.0}")),
    );
    format!("Of {mean:.0} cycles: {}.\n\n", parts.join(", "))
}

fn purpose(text: &str) -> &'static str {
    let (name, operands) = text.split_once(' ').unwrap_or((text, ""));
    let stack = operands.contains("sp") || operands.starts_with("r7, #");
    if name.starts_with("push") || name.starts_with("pop") || stack {
        "registers saved and spilled"
    } else if name.starts_with("mul")
        || name.starts_with("ml")
        || name.contains("mul")
        || name.starts_with("smla")
    {
        "products"
    } else if name.starts_with("ldr") {
        "loads"
    } else if name.starts_with("str") {
        "stores"
    } else if name.starts_with('b') && !name.starts_with("bi") && !name.starts_with("bf")
        || name.starts_with("cmp")
        || name.starts_with("it")
    {
        "decisions"
    } else {
        "shifts, sums and constants"
    }
}

/// How often an instruction is executed at least that is listed.
const SELDOM: f64 = 0.02;

fn lines(listing: &[Instruction], core: &str) -> String {
    let mut text = String::from("```text\n");
    for line in listing.iter().filter(|line| line.executed >= SELDOM) {
        let cycles = line.cycles.get(core).copied().unwrap_or_default();
        let _ = writeln!(text, "{:5.2} {cycles:6.2}  {}", line.executed, line.text);
    }
    text.push_str("```\n");
    text
}
