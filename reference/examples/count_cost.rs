//! Counts the instructions of every model's evaluation with callgrind; prints data/cost.csv.
//!
//! `cargo build --release -p microbrdf-reference --examples`, then
//! `cargo run --release -p microbrdf-reference --example count_cost > reference/data/cost.csv`.
//! Needs valgrind (Debian: `apt-get install valgrind`): exit status 3 without it.

use microbrdf_reference::cost::{OVERHEAD, PAIRS, instructions};
use microbrdf_reference::models::ALL;
use std::path::Path;
use std::process::{Command, ExitCode};

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

fn main() -> ExitCode {
    let here = std::env::current_exe().expect("the path of this program");
    let program = here.with_file_name("cost");
    if !program.exists() {
        eprintln!(
            "{} is missing: cargo build --release -p microbrdf-reference --examples",
            program.display()
        );
        return ExitCode::from(3);
    }
    println!(
        "# Instructions of one evaluation in f64, counted by valgrind's callgrind as the difference of two runs"
    );
    println!(
        "# (x86-64, release profile, 64 pairs inside the lobes, the loop's own {OVERHEAD} taken off)."
    );
    println!("# Made by `cargo run --release -p microbrdf-reference --example count_cost`.");
    println!("model,instructions");
    // Models whose evaluation integrates take 1e5 instructions: few rounds are exact too.
    let (few, many) = (1, 9);
    let each = |name: &str| -> Result<f64, String> {
        let difference = count(&program, name, many)? - count(&program, name, few)?;
        Ok(difference as f64 / f64::from((many - few) * PAIRS))
    };
    let run = || -> Result<(), String> {
        let overhead = each(OVERHEAD)?;
        for model in ALL {
            println!("{},{:.1}", model.name, each(model.name)? - overhead);
        }
        Ok(())
    };
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(3)
        }
    }
}
