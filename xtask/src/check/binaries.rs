//! The host's tests: every test program that cargo builds, several at a time, then the examples in the documents.

use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;

use super::counts::{self, Tally};
use super::schedule::{self, Terms};
use super::{Bench, cargo};
use crate::failure::{Failure, Outcome};

/// Programs that limit or spend time by the clock: nothing runs beside them.
const TIMED: [&str; 4] = ["hostile", "fuzz", "fuzz_scene", "fuzz_obj"];
/// Programs that take longest.
const LONG: [&str; 6] = [
    "energy",
    "flicker",
    "microbrdf_reference",
    "published",
    "sampling",
    "tables",
];

/// A test program, and where cargo would start it.
#[derive(Debug, PartialEq, Eq)]
struct Program {
    name: String,
    file: PathBuf,
    folder: PathBuf,
}

/// Builds and runs them all; as `cargo test --workspace --no-fail-fast`, but for the order.
pub fn run(bench: &Bench<'_>) -> Outcome<Tally> {
    let mut build = cargo(bench, &["test", "--workspace", "--locked", "--no-run"]);
    build.args(["--message-format", "json-render-diagnostics"]);
    let (status, said) = bench.ended("host-tests-build", &mut build)?;
    if status != Some(0) {
        let for_people = said.lines().filter(|line| !line.starts_with('{'));
        let said: Vec<&str> = for_people.collect();
        return Err(Failure::incomplete(said.join("\n")));
    }
    let programs = programs(&said);
    let terms: Vec<Terms> = programs
        .iter()
        .map(|program| {
            let target = program.name.rsplit(' ').next().unwrap_or_default();
            Terms {
                alone: TIMED.contains(&target),
                early: LONG.contains(&target),
                files: None,
            }
        })
        .collect();
    let tallies = schedule::run(&terms, bench.jobs, |number| {
        let program = &programs[number];
        let mut command = Command::new(&program.file);
        command
            .current_dir(&program.folder)
            .env("CARGO_MANIFEST_DIR", &program.folder);
        let log = format!("host-tests-{}", program.name.replace(' ', "-"));
        let (status, output) = bench.ended(&log, &mut command)?;
        let tally = of_program(status, &output);
        let result = output
            .lines()
            .rfind(|line| line.starts_with("test result:"));
        println!("{}: {}", program.name, result.unwrap_or("no result"));
        if tally.failed > 0 {
            println!("{output}");
        }
        Ok(tally)
    });
    let mut total = Tally::default();
    for tally in tallies {
        total += tally?;
    }
    let mut documents = cargo(bench, &["test", "--workspace", "--locked", "--doc"]);
    documents.arg("--no-fail-fast");
    let (status, output) = bench.ended("host-tests-doc", &mut documents)?;
    let tally = of_program(status, &output);
    println!("documents: {tally}");
    if tally.failed > 0 {
        println!("{output}");
    }
    total += tally;
    if total.passed == 0 {
        return Err(Failure::incomplete("cargo built no test"));
    }
    Ok(total)
}

/// What a program counted. One that ended badly, or without a word of how it ended, has failed.
fn of_program(status: Option<i32>, output: &str) -> Tally {
    let counted = counts::read(output);
    let has_ended = output.lines().any(|line| line.starts_with("test result:"));
    if status == Some(0) && has_ended {
        counted
    } else {
        Tally::failed_at_least_once(counted)
    }
}

/// The test programs among cargo's messages.
fn programs(messages: &str) -> Vec<Program> {
    let lines = messages.lines().filter(|line| line.starts_with('{'));
    lines
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|message| message["profile"]["test"] == true)
        .filter_map(|message| {
            let text = |value: &Value| value.as_str().map(str::to_owned);
            let folder = PathBuf::from(text(&message["manifest_path"])?);
            let folder = folder.parent()?.to_path_buf();
            let target = text(&message["target"]["name"])?;
            let kind = text(&message["target"]["kind"][0])?;
            let package = folder.file_name()?.to_string_lossy().into_owned();
            Some(Program {
                name: format!("{package} {kind} {target}"),
                file: text(&message["executable"])?.into(),
                folder,
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_told_from_other_artefacts() {
        let messages = r#"   Compiling core v0.1.0
{"reason":"compiler-artifact","manifest_path":"/w/core/Cargo.toml","target":{"kind":["lib"],"name":"core"},"profile":{"test":false},"executable":null}
{"reason":"compiler-artifact","manifest_path":"/w/core/Cargo.toml","target":{"kind":["lib"],"name":"core"},"profile":{"test":true},"executable":"/t/core-1"}
{"reason":"compiler-artifact","manifest_path":"/w/core/Cargo.toml","target":{"kind":["example"],"name":"e"},"profile":{"test":false},"executable":"/t/e"}
{"reason":"compiler-artifact","manifest_path":"/w/tests/Cargo.toml","target":{"kind":["test"],"name":"bits"},"profile":{"test":true},"executable":"/t/bits-2"}
{"reason":"build-finished","success":true}
"#;
        let program = |name: &str, file: &str, folder: &str| Program {
            name: name.into(),
            file: file.into(),
            folder: folder.into(),
        };
        assert_eq!(
            programs(messages),
            [
                program("core lib core", "/t/core-1", "/w/core"),
                program("tests test bits", "/t/bits-2", "/w/tests"),
            ]
        );
    }

    #[test]
    fn what_ends_badly_has_failed() {
        let good = "test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured";
        assert_eq!(of_program(Some(0), good).to_string(), "3 passed, 0 failed");
        assert_eq!(of_program(Some(101), good).failed, 1);
        assert_eq!(of_program(None, "").failed, 1);
        assert_eq!(of_program(Some(0), "running 3 tests\n").failed, 1);
    }
}
