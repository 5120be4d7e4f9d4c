//! `docs/goals.md`: what kernels were to cost, what they do cost, and where
//! the cycles go of those that cost more.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::{Deserialize, Serialize};

use crate::document::CORES;
use crate::row::Row;

/// Cores that have goals.
const AIMED: [&str; 3] = ["cortex-m0plus", "cortex-m3", "cortex-m4f"];

/// What some kernels were to cost.
struct Goal {
    title: &'static str,
    /// The kernels; the first is listed.
    kernels: &'static [&'static str],
    /// The most cycles on each of the aimed cores.
    at_most: [f64; 3],
    /// Why it is not reached, where it isn't.
    why: &'static str,
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
        at_most: [95.0, 80.0, 60.0],
        why: "",
    },
    Goal {
        title: "metal, three channels with Fresnel's factor",
        kernels: &[
            "q15_exposed_gold_20_k1",
            "q15_exposed_gold_20_kc",
            "q15_exposed_gold_500_k1",
            "q15_exposed_gold_500_kc",
        ],
        at_most: [115.0, 100.0, 75.0],
        why: "Beyond the lobe and the ratio, which alone take most of the goal, three channels each \
              read two knots, interpolate, multiply, clamp and store. The knots are kept apart from \
              their differences: a word of slope and value for each would double the curve's bytes.",
    },
    Goal {
        title: "basic patch",
        kernels: &["q15_exposed_patch_k1", "q15_exposed_patch_kc"],
        at_most: [45.0, 30.0, 30.0],
        why: "What is left is the geometry: unpacking four components, two squares, a comparison, \
              and one clamp. The function saves registers and sets up a frame pointer although it \
              calls nothing: the compiler's Thumb targets ask for that in every function. Inlined in a row's loop those cycles are gone.",
    },
    Goal {
        title: "exponential patch",
        kernels: &["q15_patch_exponential_k1", "q15_patch_exponential_kc"],
        at_most: [120.0, 71.0, 58.0],
        why: "",
    },
    Goal {
        title: "linear to sRGB, one channel, within 0.60 LSB",
        kernels: &["srgb8_direct"],
        at_most: [16.0, 14.0, 12.0],
        why: "The call and the frame pointer, which the compiler's Thumb targets ask for in every \
              function, take most of the goal by themselves. In a row's loop, where it is inlined, \
              the comparison, two shifts and the load remain.",
    },
    Goal {
        title: "world-space N, L, V in, RGB out",
        kernels: &[
            "q15_exposed_world_metallic_phong_20_k1",
            "q15_exposed_world_metallic_phong_20_kc",
        ],
        at_most: [190.0, 120.0, 70.0],
        why: "Nine components are unpacked for two dot products and three coordinates of L + V \
              without its part along N, each of them with a product and a square of its own: a \
              formula in the cosines alone would be shorter, and lose the highlight's digits where \
              14-bit directions cancel. So many values need every register, whose saving and \
              spilling is counted, too.",
    },
    Goal {
        title: "whole sphere pixel to RGB565, any n, at most one level off",
        kernels: &["q15_sphere_20", "q15_sphere_500", "q15_sphere_5000"],
        at_most: [60.0, 40.0, 36.0],
        why: "It is the world-space evaluation with a root for the normal before it and a palette \
              after it. 1 + L·V − 2(N·L)(N·V) would be quicker than its versine, but 14-bit \
              directions cancel there. Where L and V are the same for all pixels, \
              2(N·T)² + 2cos²θ(N·B)², T along L − V, B along L × V and θ half the angle between \
              L and V, cancels nowhere and takes fewer products; root, ratio, table and \
              palette remain.",
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
            let _ = write!(text, " {most:.0}{mark} | {at_most:.0} |");
        }
        text.push('\n');
    }
    for goal in &GOALS {
        let missed: Vec<_> = AIMED
            .into_iter()
            .zip(goal.at_most)
            .filter(|(core, at_most)| most(rows, goal, core) > *at_most)
            .map(|(core, _)| core)
            .collect();
        let (Some(core), Some(kernel)) = (missed.last(), goal.kernels.first()) else {
            continue;
        };
        let _ = write!(
            text,
            "\n## {}\n\n{}\n\n`{kernel}` on {}: how often each instruction is executed in a call within \
             the lobe, and the cycles it takes.\n\n",
            goal.title,
            goal.why,
            CORES
                .iter()
                .find(|(name, _)| name == core)
                .map_or("", |(_, title)| title),
        );
        let listing = listings
            .get(*kernel)
            .and_then(|of_targets| of_targets.iter().find(|listing| takes(listing, core)));
        if let Some(listing) = listing {
            text.push_str(&spent(listing, core, mean(rows, kernel, core)));
            text.push_str(&lines(listing, core));
        }
    }
    text
}

fn mean(rows: &[Row], kernel: &str, core: &str) -> f64 {
    rows.iter()
        .find(|row| row.kernel == kernel && row.core == core)
        .map_or(0.0, |row| row.cycles_mean)
}

fn most(rows: &[Row], goal: &Goal, core: &str) -> f64 {
    let means = goal.kernels.iter().map(|kernel| mean(rows, kernel, core));
    means.fold(0.0, f64::max)
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
    let mut parts = vec![format!("the call {:.0}", mean - executed)];
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

fn lines(listing: &[Instruction], core: &str) -> String {
    let mut text = String::from("```text\n");
    for line in listing {
        let cycles = line.cycles.get(core).copied().unwrap_or_default();
        let _ = writeln!(text, "{:5.2} {cycles:6.2}  {}", line.executed, line.text);
    }
    text.push_str("```\n");
    text
}
