//! The command that `cargo xtask measure` calls.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use clap::{Parser, Subcommand};
use rayon::prelude::*;

use microbrdf_kernels::kernels;
use microbrdf_trade::goals::{self, Listings};
use microbrdf_trade::row::{self, Row};
use microbrdf_trade::subject::Subject;
use microbrdf_trade::{budget, check, curve, document, errors, join, plot, samples, sphere};

/// What the kernels get wrong, what an emulated core is to call, and the
/// tables of both.
#[derive(Parser)]
#[command(
    version,
    after_help = "Example: microbrdf-trade calls --count 64 -o target/measure/calls.json"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Print a curve that the kernels hold as a constant
    Curve {
        /// Whose
        of: curve::Of,
    },
    /// Write the calls that an emulated core is to make
    Calls {
        /// Calls within the lobe for each kernel
        #[arg(long, default_value_t = 64)]
        count: usize,
        /// Only kernels with this in their names
        #[arg(long, default_value = "")]
        only: String,
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Write the calls that sum up many results, with what this host gives
    Checksums {
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Write the kernels' errors
    Errors {
        /// Only kernels with this in their names
        #[arg(long, default_value = "")]
        only: String,
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Join errors with what was counted on cores
    Join {
        /// What `errors` wrote
        #[arg(long)]
        errors: PathBuf,
        /// What a counter wrote; once for each
        #[arg(long)]
        counts: Vec<PathBuf>,
        /// Only this core
        #[arg(long)]
        core: Option<String>,
        /// What compiled the kernels
        #[arg(long)]
        compiler: String,
        /// File to write
        #[arg(short)]
        output: PathBuf,
    },
    /// Print the table
    Print {
        /// What `join` wrote
        data: PathBuf,
    },
    /// Write the documents, plots and figures that are kept
    Publish {
        /// What `join` wrote
        data: PathBuf,
        /// Top of the repository
        root: PathBuf,
        /// Set the budgets, too
        #[arg(long)]
        set_budgets: bool,
    },
    /// Compare with the figures that are kept, and with the budgets
    Check {
        /// What `join` wrote
        data: PathBuf,
        /// Top of the repository
        root: PathBuf,
    },
}

fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(1)
        }
    }
}

fn run(command: Command) -> Result<()> {
    match command {
        Command::Curve { of } => {
            print!("{}", of.source());
            Ok(())
        }
        Command::Calls {
            count,
            only,
            output,
        } => {
            let calls: Vec<_> = kernels()
                .filter(|kernel| kernel.name.contains(&only))
                .map(|kernel| samples::of(kernel, samples::count(kernel, count)))
                .collect();
            write(&output, &calls)
        }
        Command::Checksums { output } => write(&output, &samples::checksums()),
        Command::Errors { only, output } => {
            let chosen: Vec<_> = kernels()
                .filter(|kernel| kernel.name.contains(&only))
                .collect();
            let found: Vec<_> = chosen
                .par_iter()
                .map(|kernel| {
                    let errors = match Subject::new(kernel) {
                        Some(subject) => errors::measure(&subject),
                        None if kernel.model == "srgb8" => vec![errors::encoding(kernel)],
                        None if kernel.model == "sphere" => vec![sphere::measure(kernel)],
                        None => Vec::new(),
                    };
                    (kernel.name, errors)
                })
                .collect();
            write(&output, &found)
        }
        Command::Join {
            errors,
            counts,
            core,
            compiler,
            output,
        } => {
            let errors: Vec<_> = read(&errors)?;
            let mut counted: Vec<join::Counted> = Vec::new();
            for path in &counts {
                counted.extend(read::<Vec<_>>(path)?);
            }
            let rows = join::rows(&counted, &errors, core.as_deref(), &compiler);
            write(&listings_beside(&output), &join::listings(&counted))?;
            put(&output, &row::json(&rows)?)
        }
        Command::Print { data } => {
            let rows = shown(&data)?;
            print!("{}", document::table(&rows.iter().collect::<Vec<_>>()));
            Ok(())
        }
        Command::Publish {
            data,
            root,
            set_budgets,
        } => publish(&shown(&data)?, &listings(&data)?, &root, set_budgets),
        Command::Check { data, root } => check_all(&shown(&data)?, &listings(&data)?, &root),
    }
}

/// Where the kept figures lie.
const KEPT: &str = "host-sim/data/trade.json";

/// What kernels were to cost, and do.
const GOALS: &str = "docs/goals.md";

/// The file with listings that goes with one with rows.
fn listings_beside(data: &Path) -> PathBuf {
    data.with_file_name("listings.json")
}

fn listings(data: &Path) -> Result<Listings> {
    read(&listings_beside(data))
}

/// The rows that documents show.
fn shown(data: &Path) -> Result<Vec<Row>> {
    let mut rows = row::read(data)?;
    rows.retain(|row| row.samples == row.shown_samples());
    Ok(rows)
}

fn publish(rows: &[Row], listings: &Listings, root: &Path, set_budgets: bool) -> Result<()> {
    fs::create_dir_all(root.join("host-sim/data"))?;
    put(&root.join(KEPT), &row::json(rows)?)?;
    put(&root.join("docs/trade.md"), &document::markdown(rows))?;
    put(&root.join(GOALS), &goals::markdown(rows, listings))?;
    for (core, _) in document::CORES {
        if rows.iter().any(|row| row.core == core) {
            let path = root.join("docs").join(plot::file(core));
            put(&path, &plot::svg(rows, core))?;
        }
    }
    if set_budgets {
        put(&root.join("budgets.toml"), &budget::text(rows))?;
    }
    Ok(())
}

fn check_all(rows: &[Row], listings: &Listings, root: &Path) -> Result<()> {
    let kept = row::read(&root.join(KEPT))?;
    let path = root.join("budgets.toml");
    let text = fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))?;
    let budgets = budget::Budgets::read(&text)?;
    let mut faults = Vec::new();
    for found in [check::kept(rows, &kept), check::within(rows, &budgets)] {
        for warning in found.warnings {
            println!("warning: {warning}");
        }
        faults.extend(found.faults);
    }
    faults.extend(goals::missed(rows));
    // Another compiler's instructions are others.
    let same = |row: &Row| {
        kept.first()
            .is_some_and(|kept| kept.compiler == row.compiler)
    };
    if rows.first().is_some_and(same) {
        let path = root.join(GOALS);
        let text =
            fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))?;
        if text != goals::markdown(rows, listings) {
            faults.push(format!("{GOALS} is not what is measured"));
        }
    }
    if faults.is_empty() {
        println!("{} rows agree with what is kept", rows.len());
        return Ok(());
    }
    bail!(
        "{}\n`cargo xtask measure` makes docs/trade.md anew",
        faults.join("\n")
    )
}

fn read<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T> {
    let text = fs::read(path).with_context(|| format!("reading {}", path.display()))?;
    serde_json::from_slice(&text).with_context(|| format!("reading {}", path.display()))
}

fn put(path: &Path, text: &str) -> Result<()> {
    fs::write(path, text).with_context(|| format!("writing {}", path.display()))
}

fn write(path: &Path, value: &impl serde::Serialize) -> Result<()> {
    put(path, &serde_json::to_string(value)?)
}
