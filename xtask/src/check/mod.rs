//! `cargo xtask test`: everything that CI runs, as many steps at a time as there are cores.
//!
//! A step that fails shows its output and the others go on; the last line sums up what all test runners counted, each step without a runner as one.

mod apart;
mod bad_input;
mod binaries;
mod counts;
mod emulated;
mod line;
mod oldest;
mod probes;
mod python;
mod rust;
mod schedule;
mod speed;
mod trade;
mod unused;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::Write as _;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::{self, shown};
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::toolchain::Cross;
use counts::Tally;
use schedule::Terms;

/// What the steps work with.
pub struct Bench<'a> {
    layout: &'a Layout,
    cross: &'a Cross,
    /// How much may run at a time.
    jobs: usize,
}

/// What a step does.
type Check = dyn Fn(&Bench<'_>) -> Outcome<Tally> + Sync;

/// One step.
struct Step {
    name: String,
    terms: Terms,
    run: Box<Check>,
}

impl Step {
    /// Nothing runs beside it.
    fn alone(mut self) -> Self {
        self.terms.alone = true;
        self
    }

    /// It begins before the others.
    fn early(mut self) -> Self {
        self.terms.early = true;
        self
    }

    /// It writes these files, as other steps do.
    fn writes(mut self, files: &'static str) -> Self {
        self.terms.files = Some(files);
        self
    }
}

/// A step from its name and what it does.
fn step(
    name: impl Into<String>,
    run: impl Fn(&Bench<'_>) -> Outcome<Tally> + Sync + 'static,
) -> Step {
    Step {
        name: name.into(),
        terms: Terms::default(),
        run: Box::new(run),
    }
}

/// Every step, in the order of the summary: the quick ones first.
fn steps() -> Vec<Step> {
    let mut steps = rust::style();
    steps.extend(python::steps());
    steps.extend(rust::tests());
    steps.extend(probes::steps());
    steps.extend(trade::steps());
    steps.extend(unused::steps());
    steps.extend(emulated::steps());
    steps.extend(bad_input::steps());
    steps.push(speed::host_rendering());
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

/// Runs the steps with `only` in their names, or all, so many at a time.
pub fn run(layout: &Layout, cross: &Cross, only: Option<&str>, jobs: usize) -> Outcome<()> {
    println!("{}", cross.chosen(layout));
    let bench = Bench {
        layout,
        cross,
        jobs,
    };
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
    let begun = Instant::now();
    let results: Vec<(Tally, Duration)> = if jobs == 1 {
        let shown = |(number, step): (usize, &Step)| {
            println!("{} {}", place(number, &chosen), step.name);
            let started = Instant::now();
            let tally = here(step, &bench);
            let took = started.elapsed();
            println!("{}", closing(number, &chosen, tally, took));
            (tally, took)
        };
        chosen.iter().enumerate().map(shown).collect()
    } else {
        let terms: Vec<Terms> = chosen.iter().map(|step| step.terms).collect();
        schedule::run(&terms, jobs, |number| {
            let started = Instant::now();
            let (said, tally) =
                apart::run(layout, &chosen[number].name, jobs).unwrap_or_else(|failure| {
                    let nothing = Tally::default();
                    (format!("{failure}\n"), Tally::failed_at_least_once(nothing))
                });
            let took = started.elapsed();
            let name = &chosen[number].name;
            // Whole, and nobody else's between.
            let _ = writeln!(
                std::io::stdout().lock(),
                "{} {name}\n{said}{}",
                place(number, &chosen),
                closing(number, &chosen, tally, took)
            );
            (tally, took)
        })
    };
    let mut total = Tally::default();
    let mut summary = String::new();
    for (step, (tally, took)) in chosen.iter().zip(&results) {
        let _ = writeln!(
            summary,
            "  {:<8} {:>8}  {} ({tally})",
            tally.verdict(),
            seconds(*took),
            step.name
        );
        total += *tally;
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

/// Runs the step of this name in this process; the last line is its tally.
pub fn one(layout: &Layout, cross: &Cross, name: &str, jobs: usize) -> Outcome<()> {
    let bench = Bench {
        layout,
        cross,
        jobs,
    };
    let steps = steps();
    let step = steps.iter().find(|step| step.name == name);
    let step = step.ok_or_else(|| Failure::mistake(format!("no step is called {name}")))?;
    println!("{}", here(step, &bench));
    Ok(())
}

/// Runs a step, and shows why it failed.
fn here(step: &Step, bench: &Bench<'_>) -> Tally {
    (step.run)(bench).unwrap_or_else(|failure| {
        println!("{failure}");
        Tally::failed_at_least_once(counts::read(&failure.message))
    })
}

/// `[3/90]`.
fn place(number: usize, steps: &[Step]) -> String {
    format!("[{}/{}]", number + 1, steps.len())
}

/// The line that a step ends with.
fn closing(number: usize, steps: &[Step], tally: Tally, took: Duration) -> String {
    format!(
        "{} {}: {} ({})",
        place(number, steps),
        steps[number].name,
        tally.verdict(),
        seconds(took)
    )
}

/// Cargo of the toolchain that runs this command.
fn cargo(bench: &Bench<'_>, arguments: &[&str]) -> Command {
    let mut cargo = command::host_cargo(bench.layout.root());
    cargo.args(arguments);
    cargo
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
