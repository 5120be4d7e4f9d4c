//! The host simulator, `microbrdf`, built through cargo.

use std::ffi::{OsStr, OsString};
use std::process::{Command, Stdio};

use crate::command;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;

/// Its name.
const PROGRAM: &str = "microbrdf";

/// The command `microbrdf`, in release profile.
#[derive(Debug)]
pub struct HostSim<'a> {
    layout: &'a Layout,
}

impl<'a> HostSim<'a> {
    /// Builds it, showing what cargo does unless that is not wanted.
    pub fn build(layout: &'a Layout, quiet: bool) -> Outcome<Self> {
        let cargo = command::release(layout, "microbrdf-sim", PROGRAM);
        command::build(cargo, quiet, "the host simulator")?;
        Ok(Self { layout })
    }

    /// `microbrdf ARGUMENTS…`, not yet started.
    pub fn command<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Command {
        let mut command = command::built(self.layout, PROGRAM);
        command.args(arguments);
        command
    }

    /// Runs it with its messages shown, and returns its standard output. Its own exit status becomes ours.
    pub fn run<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome<String> {
        self.run_to(0, arguments)
    }

    /// The same where a result that differs, status 1, is one, too.
    pub fn run_to_differ<S: AsRef<OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = S>,
    ) -> Outcome<String> {
        self.run_to(1, arguments)
    }

    fn run_to<S: AsRef<OsStr>>(
        &self,
        greatest: i32,
        arguments: impl IntoIterator<Item = S>,
    ) -> Outcome<String> {
        let arguments: Vec<OsString> = arguments
            .into_iter()
            .map(|argument| argument.as_ref().to_os_string())
            .collect();
        let name = arguments
            .first()
            .map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        let output = self
            .command(&arguments)
            .stderr(Stdio::inherit())
            .output()
            .during(|| "starting microbrdf".to_string())?;
        if output
            .status
            .code()
            .is_some_and(|status| status <= greatest)
        {
            return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
        }
        Err(Failure {
            status: match output.status.code() {
                Some(status @ 2..=3) => status as u8,
                _ => 1,
            },
            message: format!(
                "`microbrdf {name}` ended with {} (see above)",
                output.status
            ),
        })
    }
}
