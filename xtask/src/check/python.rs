//! Steps over the Python packages.

use std::process::Command;

use super::counts::{self, Tally};
use super::{Bench, Step, step};
use crate::failure::Failure;

/// Each package's name for people, and its folder.
const PACKAGES: [(&str, &str); 2] = [("receiver", "receiver"), ("counter", "measure/counter")];

/// Style, types, tests.
pub fn steps() -> Vec<Step> {
    let mut steps = Vec::new();
    for (package, folder) in PACKAGES {
        for (what, arguments) in [
            ("format", &["ruff", "format", "--check", "."][..]),
            ("lints", &["ruff", "check", "."]),
            ("types", &["mypy"]),
        ] {
            steps.push(step(format!("python {what}, {package}"), move |bench| {
                let log = format!("python-{what}-{package}");
                bench
                    .finish(&log, &mut module(bench, folder, arguments))
                    .map(|_| Tally::PASSED)
            }));
        }
        steps.push(step(format!("python tests, {package}"), move |bench| {
            let log = format!("python-tests-{package}");
            let output = bench.finish(&log, &mut module(bench, folder, &["pytest", "-q"]))?;
            let tally = counts::read(&output);
            println!("{}", output.lines().last().unwrap_or_default());
            if tally.passed == 0 {
                return Err(Failure::incomplete(format!(
                    "pytest counted no test:\n{output}"
                )));
            }
            Ok(tally)
        }));
    }
    steps
}

/// `python -m ARGUMENTS…` of the virtual environment, in a package's folder.
fn module(bench: &Bench<'_>, folder: &str, arguments: &[&str]) -> Command {
    let mut python = Command::new(bench.layout.venv_program("python"));
    python
        .current_dir(bench.layout.at(folder))
        .arg("-m")
        .args(arguments);
    python
}
