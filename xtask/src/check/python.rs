//! Steps over the receiver.

use std::process::Command;

use super::counts::{self, Tally};
use super::{Bench, Step, step};
use crate::failure::Failure;

/// Style, types, tests.
pub fn steps() -> Vec<Step> {
    let mut steps = Vec::new();
    for (name, arguments) in [
        ("python format", &["ruff", "format", "--check", "."][..]),
        ("python lints", &["ruff", "check", "."]),
        ("python types", &["mypy"]),
    ] {
        steps.push(step(name, move |bench| {
            let log = name.replace(' ', "-");
            bench
                .finish(&log, &mut module(bench, arguments))
                .map(|_| Tally::PASSED)
        }));
    }
    steps.push(step("python tests", |bench| {
        let output = bench.finish("python-tests", &mut module(bench, &["pytest", "-q"]))?;
        let tally = counts::read(&output);
        println!("{}", output.lines().last().unwrap_or_default());
        if tally.passed == 0 {
            return Err(Failure::incomplete(format!(
                "pytest counted no test:\n{output}"
            )));
        }
        Ok(tally)
    }));
    steps
}

/// `python -m ARGUMENTS…` of the virtual environment, in the receiver's folder.
fn module(bench: &Bench<'_>, arguments: &[&str]) -> Command {
    let mut python = Command::new(bench.layout.venv_program("python"));
    python
        .current_dir(bench.layout.at("receiver"))
        .arg("-m")
        .args(arguments);
    python
}
