//! What test runners say that they counted.

use std::fmt;
use std::ops::AddAssign;

/// Tests or checks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// That passed.
    pub passed: u32,
    /// That failed.
    pub failed: u32,
    /// That were not run, and say so.
    pub skipped: u32,
}

impl Tally {
    /// One check that passed.
    pub const PASSED: Self = Self {
        passed: 1,
        failed: 0,
        skipped: 0,
    };
    /// One check that could not be made here.
    pub const SKIPPED: Self = Self {
        passed: 0,
        failed: 0,
        skipped: 1,
    };

    /// What a failed step counts: a runner may have ended before it counted a failure.
    pub fn failed_at_least_once(counted: Self) -> Self {
        Self {
            failed: counted.failed.max(1),
            ..counted
        }
    }

    /// From the line that it is shown as, and from no other.
    pub fn of_line(line: &str) -> Option<Self> {
        let tally = Self {
            passed: before(line, "passed"),
            failed: before(line, "failed"),
            skipped: before(line, "skipped"),
        };
        (tally.to_string() == line).then_some(tally)
    }

    /// In a word.
    pub fn verdict(self) -> &'static str {
        match self {
            Self { failed: 1.., .. } => "FAILED",
            Self { passed: 0, .. } => "skipped",
            _ => "ok",
        }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.skipped += other.skipped;
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} passed, {} failed", self.passed, self.failed)?;
        if self.skipped > 0 {
            write!(f, ", {} skipped", self.skipped)?;
        }
        Ok(())
    }
}

/// Sums the closing lines of cargo's and pytest's runners.
pub fn read(output: &str) -> Tally {
    let mut tally = Tally::default();
    for line in output.lines().map(str::trim) {
        if line.starts_with("test result:") || is_pytest_closing(line) {
            tally.passed += before(line, "passed");
            tally.failed += before(line, "failed") + before(line, "error");
            tally.skipped += before(line, "ignored") + before(line, "skipped");
        }
    }
    tally
}

/// `12 passed, 1 skipped in 0.31s`, with or without a frame of `=`.
fn is_pytest_closing(line: &str) -> bool {
    let line = line.trim_matches(['=', ' ']);
    line.starts_with(|c: char| c.is_ascii_digit())
        && line.contains(" in ")
        && line.ends_with(['s', ')'])
        && ["passed", "failed", "error"]
            .iter()
            .any(|word| line.contains(word))
}

/// The number that stands before a word.
fn before(line: &str, word: &str) -> u32 {
    let words: Vec<&str> = line
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|w| !w.is_empty())
        .collect();
    words
        .windows(2)
        .filter(|pair| pair[1].strip_suffix('s').unwrap_or(pair[1]) == word)
        .filter_map(|pair| pair[0].parse::<u32>().ok())
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_runs_of_cargo_test() {
        let output = "running 2 tests\n\
            test a ... ok\n\
            test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.01s\n\
            test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 4 filtered out; finished in 0.01s\n";
        assert_eq!(
            read(output),
            Tally {
                passed: 15,
                failed: 2,
                skipped: 1
            }
        );
    }

    #[test]
    fn closing_lines_of_pytest() {
        assert_eq!(
            read("12 passed in 0.31s"),
            Tally {
                passed: 12,
                failed: 0,
                skipped: 0
            }
        );
        assert_eq!(
            read("== 1 failed, 10 passed, 2 skipped, 1 error in 61.00s (0:01:01) =="),
            Tally {
                passed: 10,
                failed: 2,
                skipped: 2
            }
        );
        assert_eq!(
            read("3 passed, 2 errors in 1.0s"),
            Tally {
                passed: 3,
                failed: 2,
                skipped: 0
            }
        );
    }

    #[test]
    fn what_only_looks_like_a_count_is_none() {
        assert_eq!(
            read("the check passed in 3 places\n7 errors were passed\n"),
            Tally::default()
        );
    }

    #[test]
    fn a_failed_step_counts_even_without_a_count() {
        assert_eq!(Tally::failed_at_least_once(Tally::default()).failed, 1);
        let two = Tally {
            passed: 1,
            failed: 2,
            skipped: 0,
        };
        assert_eq!(Tally::failed_at_least_once(two), two);
    }

    #[test]
    fn the_last_line() {
        assert_eq!(
            Tally {
                passed: 3,
                failed: 0,
                skipped: 0
            }
            .to_string(),
            "3 passed, 0 failed"
        );
        assert_eq!(
            Tally {
                passed: 3,
                failed: 1,
                skipped: 2
            }
            .to_string(),
            "3 passed, 1 failed, 2 skipped"
        );
        for line in ["3 passed, 0 failed", "3 passed, 1 failed, 2 skipped"] {
            assert_eq!(Tally::of_line(line).unwrap().to_string(), line);
        }
        for line in ["", "3 passed", "3 passed, 0 fail", "so 3 passed, 0 failed"] {
            assert_eq!(Tally::of_line(line), None, "{line}");
        }
    }
}
