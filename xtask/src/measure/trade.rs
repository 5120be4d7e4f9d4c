//! The program `microbrdf-trade`: errors, calls, tables.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use crate::command;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::toolchain::Cross;

/// Calls within the lobe that each kernel gets.
const COUNT: &str = "64";

/// Its name, and its package's.
const PROGRAM: &str = "microbrdf-trade";

/// The program, in release profile.
pub struct Trade<'a> {
    layout: &'a Layout,
    folder: PathBuf,
}

impl<'a> Trade<'a> {
    /// Builds it.
    pub fn build(layout: &'a Layout, quiet: bool) -> Outcome<Self> {
        command::build(
            command::release(layout, PROGRAM, PROGRAM),
            quiet,
            "the program of the trade tables",
        )?;
        Ok(Self {
            layout,
            folder: super::folder(layout),
        })
    }

    /// Writes what the kernels are to be called with, and their errors.
    pub fn prepare(&self, only: &str) -> Outcome<()> {
        self.calls(only)?;
        self.write("errors.json", &["errors", "--only", only])
    }

    /// Writes what the kernels are to be called with.
    pub fn calls(&self, only: &str) -> Outcome<()> {
        self.write("calls.json", &["calls", "--count", COUNT, "--only", only])
    }

    fn write(&self, file: &str, words: &[&str]) -> Outcome<()> {
        let mut line: Vec<OsString> = words.iter().map(OsString::from).collect();
        line.extend(["-o".into(), self.folder.join(file).into_os_string()]);
        self.run(&line)
    }

    /// Writes the calls that sum up many results, with what this host gives.
    pub fn checksums(&self) -> Outcome<()> {
        let output = self.folder.join("checksums.json");
        self.run(&["checksums".into(), "-o".into(), output])
    }

    /// Joins errors and counts to `trade.json`.
    pub fn join(&self, counts: &[PathBuf], core: Option<&str>, cross: &Cross) -> Outcome<()> {
        let mut line: Vec<OsString> = vec!["join".into(), "--errors".into()];
        line.push(self.folder.join("errors.json").into());
        for count in counts {
            line.extend(["--counts".into(), count.into()]);
        }
        if let Some(core) = core {
            line.extend(["--core".into(), core.into()]);
        }
        let origin = match cross {
            Cross::Active { .. } => "core as it comes with it",
            Cross::Distribution { .. } => "core built from its source",
        };
        let compiler = format!("{}, {origin}", cross.version());
        line.extend(["--compiler".into(), compiler.into(), "-o".into()]);
        line.push(self.data().into());
        self.run(&line)
    }

    /// Writes the documents, plots and data that are kept in the repository.
    pub fn publish(&self, set_budgets: bool) -> Outcome<()> {
        let mut line: Vec<OsString> = vec!["publish".into(), self.data().into()];
        line.push(self.layout.root().into());
        if set_budgets {
            line.push("--set-budgets".into());
        }
        self.run(&line)
    }

    /// Compares fresh figures with those that are kept, and with the budgets.
    pub fn check(&self) -> Outcome<()> {
        self.run(&[
            "check".into(),
            self.data(),
            self.layout.root().to_path_buf(),
        ])
    }

    /// Prints the table.
    pub fn print(&self) -> Outcome<()> {
        self.run(&["print".into(), self.data()])
    }

    /// The file with everything measured.
    fn data(&self) -> PathBuf {
        self.folder.join("trade.json")
    }

    fn run(&self, arguments: &[impl AsRef<OsStr>]) -> Outcome<()> {
        let status = command::built(self.layout, PROGRAM)
            .args(arguments)
            .status()
            .during(|| format!("starting {PROGRAM}"))?;
        if status.success() {
            return Ok(());
        }
        let name = arguments.first().map(|name| Path::new(name.as_ref()));
        Err(Failure::incomplete(format!(
            "`microbrdf-trade {}` ended with {status} (see above)",
            name.unwrap_or(Path::new("")).display()
        )))
    }
}
