//! Cost and error of every kernel, as they are kept, and within the budgets.

use super::counts::Tally;
use super::{Bench, Step, step};
use crate::failure::Outcome;
use crate::measure::{self, Order};

/// Calls and images of the kernels.
const KERNELS: &str = "kernels";

/// The bits of many results on every core; what every kernel costs.
pub fn steps() -> Vec<Step> {
    vec![
        step("the same bits on every core", |bench| {
            let passed = measure::compare_bits(bench.layout, bench.cross)?;
            Ok(Tally {
                passed,
                ..Tally::default()
            })
        })
        .early(),
        step("trade and budgets", check).early().writes(KERNELS),
        step("cycles on Cortex-M0+, second source", |bench| {
            measure::compare_cycles(bench.layout, bench.cross)?;
            Ok(Tally::PASSED)
        })
        .writes(KERNELS),
    ]
}

fn check(bench: &Bench<'_>) -> Outcome<Tally> {
    measure::run(bench.layout, bench.cross, &Order::default(), true)?;
    measure::check(bench.layout)?;
    Ok(Tally::PASSED)
}
