//! `cargo xtask test`: everything that CI runs, one step after the other.
//!
//! A step that fails shows its output and the next one follows; the last line sums up what all test runners counted, each step without a runner as one.

mod bad_input;
mod counts;
mod emulated;
mod line;
mod oldest;
mod probes;
mod python;
mod rust;
mod trade;
mod unused;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::shown;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::toolchain::Cross;
use counts::Tally;

/// What the steps work with.
pub struct Bench<'a> {
    layout: &'a Layout,
    cross: &'a Cross,
}

/// What a step does.
type Check = dyn Fn(&Bench<'_>) -> Outcome<Tally>;

/// One step.
struct Step {
    name: String,
    run: Box<Check>,
}

/// A step from its name and what it does.
fn step(name: impl Into<String>, run: impl Fn(&Bench<'_>) -> Outcome<Tally> + 'static) -> Step {
    Step {
        name: name.into(),
        run: Box::new(run),
    }
}

/// Every step, the quick ones first.
fn steps() -> Vec<Step> {
    let mut steps = rust::style();
    steps.extend(python::steps());
    steps.extend(rust::tests());
    steps.extend(probes::steps());
    steps.extend(trade::steps());
    steps.extend(unused::steps());
    steps.extend(emulated::steps());
    steps.extend(bad_input::steps());
    steps.extend(rust::release());
    steps.push(oldest::step());
    steps
}

/// Prints the names of the steps.
pub fn list() {
    for step in steps() {
        println!("{}", step.name);
    }
}

/// Runs the steps with `only` in their names, or all.
pub fn run(layout: &Layout, cross: &Cross, only: Option<&str>) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let bench = Bench { layout, cross };
    let chosen: Vec<Step> = steps()
        .into_iter()
        .filter(|step| only.is_none_or(|text| step.name.contains(text)))
        .collect();
    if chosen.is_empty() {
        return Err(Failure::mistake(format!(
            "--only {}: no step has that in its name; --list prints them",
            only.unwrap_or_default()
        )));
    }
    let mut total = Tally::default();
    let mut summary = String::new();
    let begun = Instant::now();
    for (number, step) in chosen.iter().enumerate() {
        println!("[{}/{}] {}", number + 1, chosen.len(), step.name);
        let started = Instant::now();
        let tally = match (step.run)(&bench) {
            Ok(tally) => tally,
            Err(failure) => {
                println!("{failure}");
                Tally::failed_at_least_once(counts::read(&failure.message))
            }
        };
        let took = started.elapsed();
        let verdict = tally.verdict();
        println!(
            "[{}/{}] {}: {verdict} ({})",
            number + 1,
            chosen.len(),
            step.name,
            seconds(took)
        );
        let _ = writeln!(
            summary,
            "  {verdict:<8} {:>8}  {} ({tally})",
            seconds(took),
            step.name
        );
        total += tally;
    }
    println!("\n{summary}  total    {:>8}\n", seconds(begun.elapsed()));
    // Standard output is read by machines too: its last line says how it ended.
    println!("{total}");
    if total.failed == 0 {
        return Ok(());
    }
    Err(Failure::incomplete(
        "not everything passed (the output of what failed is above)",
    ))
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

impl Bench<'_> {
    /// Runs a program with its output kept in `target/test/NAME.log`, and returns that output.
    /// A failure carries it whole.
    fn finish(&self, name: &str, command: &mut Command) -> Outcome<String> {
        let (status, output) = self.ended(name, command)?;
        if status == Some(0) {
            Ok(output)
        } else {
            Err(Failure::incomplete(output))
        }
    }

    /// Runs a program as `finish` does, and returns its exit status and output.
    fn ended(&self, name: &str, command: &mut Command) -> Outcome<(Option<i32>, String)> {
        let folder = self.layout.target().join("test");
        fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
        let path = folder.join(format!("{name}.log"));
        let log = File::create(&path).during(|| format!("creating {}", path.display()))?;
        let both = log
            .try_clone()
            .during(|| format!("sharing {}", path.display()))?;
        let status = command
            .stdin(Stdio::null())
            .stdout(log)
            .stderr(both)
            .status()
            .map_err(|e| Failure::lacking(format!("{} cannot be started: {e}", shown(command))))?;
        let output = fs::read(&path).during(|| format!("reading {}", path.display()))?;
        Ok((status.code(), String::from_utf8_lossy(&output).into_owned()))
    }
}
