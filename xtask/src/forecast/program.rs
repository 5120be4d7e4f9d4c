//! The program `microbrdf-forecast`: small scenes, calls, costs.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::Stdio;

use serde_json::Value;

use super::Rows;
use crate::command;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Its name, and its package's.
const PROGRAM: &str = "microbrdf-forecast";

/// The program, in release profile.
pub struct Program<'a> {
    layout: &'a Layout,
}

impl<'a> Program<'a> {
    /// Builds it.
    pub fn build(layout: &'a Layout, quiet: bool) -> Outcome<Self> {
        command::build(
            command::release(layout, PROGRAM, PROGRAM),
            quiet,
            "the program of the forecasts",
        )?;
        Ok(Self { layout })
    }

    /// Writes the small scenes; a list of them, each with `name`, `scene` and `stack`.
    pub fn scenes(&self, folder: &Path) -> Outcome<Vec<Value>> {
        let text = self.run(&["scenes".into(), "-o".into(), folder.into()])?;
        serde_json::from_str(&text).during(|| "reading the list of scenes".to_string())
    }

    /// Writes the rows of a scene that are to be counted.
    pub fn calls(&self, rows: &Rows, to: &Path) -> Outcome<()> {
        let mut line: Vec<OsString> = vec![
            "calls".into(),
            rows.scene.as_os_str().into(),
            "--arithmetic".into(),
            rows.arithmetic.as_str().into(),
            "--every".into(),
            rows.every.to_string().into(),
            "-o".into(),
            to.into(),
        ];
        if let Some(picture) = &rows.picture {
            line.extend(["--picture".into(), picture.as_os_str().into()]);
        }
        self.run(&line)?;
        Ok(())
    }

    /// Writes the calls that tell what packing takes.
    pub fn packing(&self, to: &Path) -> Outcome<()> {
        self.run(&["packing".into(), "-o".into(), to.into()])?;
        Ok(())
    }

    /// Computes what single things cost.
    pub fn fit(&self, found: &Path, to: &Path) -> Outcome<()> {
        let said = self.run(&["fit".into(), found.into(), "-o".into(), to.into()])?;
        print!("{said}");
        Ok(())
    }

    fn run(&self, arguments: &[OsString]) -> Outcome<String> {
        let output = command::built(self.layout, PROGRAM)
            .args(arguments)
            .stderr(Stdio::inherit())
            .output()
            .during(|| format!("starting {PROGRAM}"))?;
        if output.status.success() {
            return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
        }
        let name = arguments
            .first()
            .map_or(OsStr::new(""), OsString::as_os_str);
        Err(Failure::incomplete(format!(
            "`microbrdf-forecast {}` ended with {} (see above)",
            name.to_string_lossy(),
            output.status
        )))
    }
}
