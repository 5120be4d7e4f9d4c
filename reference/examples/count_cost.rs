//! Counts the instructions of every model's evaluation with callgrind; prints data/cost.csv,
//! or compares it with what is counted.
//!
//! `cargo build --release -p microbrdf-reference --examples`, then
//! `cargo run --release -p microbrdf-reference --example count_cost > reference/data/cost.csv`,
//! or the same with `-- --check`. Needs valgrind (Debian: `apt-get install valgrind`).
//!
//! Exit status: 0 done; 1 the kept counts are out of date; 2 a mistake in the call;
//! 3 valgrind or the example `cost` is missing.

use microbrdf_reference::cost::{OVERHEAD, PAIRS, instructions, kept};
use microbrdf_reference::models::ALL;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// Another compiler's minor version moves counts by less; another formula by more.
const TOLERANCE: f64 = 0.05;

fn count(program: &Path, name: &str, rounds: u32) -> Result<u64, String> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args([name, &rounds.to_string()])
        .output()
        .map_err(|e| format!("valgrind can't be run ({e}): apt-get install valgrind"))?;
    let report = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("{name}: {report}"));
    }
    instructions(&report).ok_or_else(|| format!("{name}: no count in {report}"))
}

fn count_all() -> Result<Vec<(&'static str, f64)>, String> {
    let here = std::env::current_exe().map_err(|e| e.to_string())?;
    let program: PathBuf = here.with_file_name("cost");
    if !program.exists() {
        return Err(format!(
            "{} is missing: cargo build --release -p microbrdf-reference --examples",
            program.display()
        ));
    }
    // Models whose evaluation integrates take 1e5 instructions: few rounds are exact too.
    let (few, many) = (1, 9);
    let each = |name: &str| -> Result<f64, String> {
        let difference = count(&program, name, many)? - count(&program, name, few)?;
        Ok(difference as f64 / f64::from((many - few) * PAIRS))
    };
    let overhead = each(OVERHEAD)?;
    ALL.iter()
        .map(|model| Ok((model.name, each(model.name)? - overhead)))
        .collect()
}

fn print(counts: &[(&str, f64)]) {
    println!(
        "# Instructions of one evaluation in f64, counted by valgrind's callgrind as the difference of two runs"
    );
    println!(
        "# (x86-64, release profile, {PAIRS} pairs inside the lobes, the loop's own {OVERHEAD} taken off)."
    );
    println!("# Made by `cargo run --release -p microbrdf-reference --example count_cost`.");
    println!("model,instructions");
    for (name, count) in counts {
        println!("{name},{count:.1}");
    }
}

/// Whether the kept counts are these, within the tolerance and an instruction.
fn check(counts: &[(&str, f64)]) -> bool {
    let kept = kept();
    let mut same = true;
    for (name, count) in counts {
        let old = kept.iter().find(|(n, _)| n == name).map(|(_, c)| *c);
        if !old.is_some_and(|old| (count - old).abs() <= TOLERANCE * old.abs() + 1.0) {
            let old = old.map_or("none".into(), |old| format!("{old:.1}"));
            eprintln!("{name}: {count:.1} instructions, data/cost.csv says {old}");
            same = false;
        }
    }
    same
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let checks = match arguments.as_slice() {
        [] => false,
        [one] if one == "--check" => true,
        _ => {
            eprintln!("usage: count_cost [--check]");
            return ExitCode::from(2);
        }
    };
    match count_all() {
        Ok(counts) if checks => ExitCode::from(u8::from(!check(&counts))),
        Ok(counts) => {
            print(&counts);
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(3)
        }
    }
}
