//! An emulated board: started halted, let go once someone listens on its serial line, ended with this value.

pub mod qmp;

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

use serde_json::json;

use crate::board::Board;
use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::setup::emulator;
use crate::stack::Stack;
use qmp::Qmp;

/// Name of the serial line in QEMU.
const LINE: &str = "line";

/// A running emulator.
pub struct Emulator {
    // Ended, and waited for, when this value goes.
    child: Child,
    monitor: Qmp<ChildStdout, ChildStdin>,
    stack: Stack,
    /// Where memory is written to.
    dump: PathBuf,
}

impl Emulator {
    /// Loads the image and halts before its first instruction.
    /// What QEMU itself has to say goes into a file beside the image, and is shown where it does not start.
    pub fn halted(layout: &Layout, board: &Board, elf: &Path) -> Outcome<Self> {
        let log = elf.with_extension("qemu.log");
        let stack = Stack::of(elf)?;
        let filled = stack.filled(elf)?;
        let messages = File::create(&log).during(|| format!("creating {}", log.display()))?;
        let mut child = emulator::command(layout)
            .args(["-M", board.name, "-S"])
            .args(["-display", "none", "-monitor", "none", "-parallel", "none"])
            .args(["-qmp", "stdio"])
            // Port 0: the system picks a free one, so that any number of emulators can run.
            .args([
                "-chardev",
                &format!("socket,id={LINE},host=127.0.0.1,port=0,server=on,wait=off"),
            ])
            .args(["-serial", &format!("chardev:{LINE}")])
            .args(filled.iter().flat_map(|device| ["-device", device]))
            .arg("-kernel")
            .arg(elf)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(messages)
            .spawn()
            .map_err(|e| Failure::lacking(format!("qemu-system-arm cannot be started: {e}")))?;
        let pipes = child.stdout.take().zip(child.stdin.take());
        let connected = pipes
            .ok_or_else(|| Failure::incomplete("QEMU has no pipes"))
            .and_then(|(from, to)| Qmp::connect(from, to));
        match connected {
            Ok(monitor) => Ok(Self {
                child,
                monitor,
                stack,
                dump: elf.with_extension("stack"),
            }),
            Err(failure) => {
                end(&mut child);
                let said = fs::read_to_string(&log).unwrap_or_default();
                Err(Failure::lacking(format!(
                    "{failure}; it said: {}",
                    said.trim()
                )))
            }
        }
    }

    /// Where the serial line can be reached: `HOST:PORT`.
    pub fn line(&mut self) -> Outcome<String> {
        let state = self.line_state()?;
        port(&state)
            .map(|port| format!("127.0.0.1:{port}"))
            .ok_or_else(|| Failure::incomplete(format!("QEMU's serial line is at {state:?}")))
    }

    /// Whether someone listens on the line.
    pub fn is_heard(&mut self) -> Outcome<bool> {
        Ok(!self.line_state()?.starts_with("disconnected:"))
    }

    /// Lets the board run.
    pub fn run(&mut self) -> Outcome<()> {
        self.monitor.execute("cont", json!({})).map(drop)
    }

    /// Photographs the board's display into a PPM file.
    pub fn photograph(&mut self, ppm: &Path) -> Outcome<()> {
        let path = ppm.to_str().ok_or_else(|| {
            Failure::mistake(format!(
                "{} is not a name that QEMU can take",
                ppm.display()
            ))
        })?;
        self.monitor
            .execute("screendump", json!({ "filename": path }))
            .map(drop)
    }

    /// Bytes of the stack that have been used so far.
    pub fn stack_used(&mut self) -> Outcome<usize> {
        let path = self.dump.to_str().ok_or_else(|| {
            Failure::mistake(format!(
                "{} is not a name that QEMU can take",
                self.dump.display()
            ))
        })?;
        let arguments = json!({
            "val": self.stack.end, "size": self.stack.size, "filename": path,
        });
        self.monitor.execute("memsave", arguments)?;
        let memory = fs::read(&self.dump).during(|| format!("reading {}", self.dump.display()))?;
        Ok(Stack::used(&memory))
    }

    fn line_state(&mut self) -> Outcome<String> {
        let lines = self.monitor.execute("query-chardev", json!({}))?;
        lines
            .as_array()
            .into_iter()
            .flatten()
            .find(|line| line["label"] == LINE)
            .and_then(|line| line["filename"].as_str().map(str::to_string))
            .ok_or_else(|| Failure::incomplete(format!("QEMU knows no serial line: {lines}")))
    }
}

impl Drop for Emulator {
    fn drop(&mut self) {
        end(&mut self.child);
    }
}

fn end(child: &mut Child) {
    let _ = child.kill();
    let _ = child.wait();
}

/// The port in `disconnected:tcp:127.0.0.1:41234,server=on`.
fn port(state: &str) -> Option<u16> {
    let (_, rest) = state.split_once("tcp:")?;
    let address = rest.split([',', ' ']).next()?;
    address.rsplit_once(':')?.1.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::port;

    #[test]
    fn port_of_a_line() {
        assert_eq!(
            port("disconnected:tcp:127.0.0.1:41234,server=on"),
            Some(41234)
        );
        assert_eq!(
            port("tcp:127.0.0.1:80,server=on <-> 127.0.0.1:5555"),
            Some(80)
        );
        assert_eq!(port("pty:/dev/pts/3"), None);
    }
}
