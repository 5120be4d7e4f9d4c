//! Fresh figures against those that are kept, and against the budgets.

use crate::budget::{self, Budgets};
use crate::row::Row;

/// How far figures of another compiler may be off, relative.
const ANOTHER_COMPILER: f64 = 0.10;
/// How far errors may be off, in codes: they come from the same source, but
/// the reference's functions are the platform's.
const ERROR_ROOM: f64 = 0.01;

/// What a comparison found.
#[derive(Debug, Default)]
pub struct Findings {
    /// What must not be.
    pub faults: Vec<String>,
    /// What may be, but is worth a word.
    pub warnings: Vec<String>,
}

/// Compares fresh rows with the kept ones.
#[must_use]
pub fn kept(fresh: &[Row], kept: &[Row]) -> Findings {
    let mut findings = Findings::default();
    let same = |a: &Row, b: &Row| a.kernel == b.kernel && a.core == b.core;
    for row in fresh {
        match kept.iter().find(|other| same(row, other)) {
            None => findings.faults.push(format!("{} is not kept", place(row))),
            Some(other) => compare(row, other, &mut findings),
        }
    }
    for row in kept {
        if !fresh.iter().any(|other| same(row, other)) {
            findings
                .faults
                .push(format!("{} is kept, but gone", place(row)));
        }
    }
    findings
}

fn place(row: &Row) -> String {
    format!("{} on {}", row.kernel, row.core)
}

fn compare(fresh: &Row, kept: &Row, findings: &mut Findings) {
    let exact = fresh.compiler == kept.compiler;
    let figures = budget::cost(fresh).into_iter().zip(budget::cost(kept));
    for (name, (now, then)) in budget::NAMES.into_iter().zip(figures) {
        if now == then {
            continue;
        }
        let words = format!("{}: {name} {now}, kept is {then}", place(fresh));
        let room = if exact { 0.0 } else { ANOTHER_COMPILER * then };
        if (now - then).abs() > room {
            findings.faults.push(words);
        } else {
            findings.warnings.push(words);
        }
    }
    let errors = [
        (fresh.lsb_error_max, kept.lsb_error_max),
        (fresh.lsb_error_anywhere, kept.lsb_error_anywhere),
    ];
    for (now, then) in errors {
        let off = now.unwrap_or(-1.0) - then.unwrap_or(-1.0);
        if off.abs() > ERROR_ROOM {
            findings
                .faults
                .push(format!("{}: error {now:?}, kept is {then:?}", place(fresh)));
        }
    }
}

/// Holds fresh rows to the budgets.
#[must_use]
pub fn within(fresh: &[Row], budgets: &Budgets) -> Findings {
    let mut findings = Findings::default();
    for row in fresh {
        let budget = budgets
            .core
            .get(&row.core)
            .and_then(|kernels| kernels.get(&row.kernel));
        let Some(budget) = budget else {
            findings
                .faults
                .push(format!("{} has no budget", place(row)));
            continue;
        };
        for (name, (now, most)) in budget::NAMES
            .into_iter()
            .zip(budget::cost(row).into_iter().zip(*budget))
        {
            if now <= most {
                continue;
            }
            let words = format!("{}: {name} {now}, the budget is {most}", place(row));
            if row.compiler != budgets.compiler && now <= most * (1.0 + ANOTHER_COMPILER) {
                findings.warnings.push(words);
            } else {
                findings.faults.push(words);
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{budget, row};

    fn rows() -> Vec<Row> {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../host-sim/data/trade.json"
        );
        row::read(path.as_ref()).expect("the kept figures")
    }

    fn with(change: impl Fn(&mut Row)) -> Vec<Row> {
        let mut rows = rows();
        change(&mut rows[0]);
        rows
    }

    #[test]
    fn the_same_figures_pass() {
        let rows = rows();
        let budgets = Budgets::read(&budget::text(&rows)).expect("budgets");
        for findings in [kept(&rows, &rows), within(&rows, &budgets)] {
            assert!(findings.faults.is_empty() && findings.warnings.is_empty());
        }
    }

    #[test]
    fn one_cycle_more_fails() {
        let fresh = with(|row| row.cycles_worst += 1);
        assert_eq!(kept(&fresh, &rows()).faults.len(), 1);
        let budgets = Budgets::read(&budget::text(&rows())).expect("budgets");
        assert_eq!(within(&fresh, &budgets).faults.len(), 1);
    }

    #[test]
    fn another_compiler_may_be_a_tenth_off() {
        let budgets = Budgets::read(&budget::text(&rows())).expect("budgets");
        for (factor, faults) in [(1.09, 0), (1.11, 1)] {
            let fresh = with(|row| {
                row.compiler = "another".into();
                row.cycles_mean *= factor;
            });
            for findings in [kept(&fresh, &rows()), within(&fresh, &budgets)] {
                assert_eq!(findings.faults.len(), faults, "{factor}");
                assert_eq!(findings.warnings.len(), 1 - faults, "{factor}");
            }
        }
    }

    #[test]
    fn a_greater_error_a_new_and_a_lost_kernel_fail() {
        let fresh = with(|row| row.lsb_error_max = row.lsb_error_max.map(|error| error + 0.02));
        assert_eq!(kept(&fresh, &rows()).faults.len(), 1);
        let fresh = with(|row| row.kernel = "another".into());
        assert_eq!(kept(&fresh, &rows()).faults.len(), 2);
    }
}
