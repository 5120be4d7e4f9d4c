//! The receiver, started beside an emulator.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::qemu::Emulator;

/// How long the receiver may take to open its port.
const OPENS_WITHIN: Duration = Duration::from_secs(30);

/// What came of receiving.
#[derive(Debug)]
pub struct Received {
    /// How the receiver ended: 0 only where the frame is whole.
    pub status: ExitStatus,
    /// What it reported; null where it wrote no report.
    pub report: Value,
}

/// Receives one frame of an emulator that was started halted, and lets it run once the receiver listens.
/// The picture goes to `picture`, the receiver's report to `report`; both are taken away first.
pub fn receive(
    layout: &Layout,
    emulator: &mut Emulator,
    picture: &Path,
    report: &Path,
    quiet: bool,
) -> Outcome<Received> {
    for old in [picture, report] {
        if old.exists() {
            fs::remove_file(old).during(|| format!("removing {}", old.display()))?;
        }
    }
    let program = layout.venv_program("microbrdf-receive");
    let mut command = Command::new(&program);
    command
        .arg(emulator.line()?)
        .arg("-o")
        .arg(picture)
        .arg("--report")
        .arg(report);
    if quiet {
        command.stdout(Stdio::null()).stderr(Stdio::null());
    }
    let mut child = command
        .stdin(Stdio::null())
        .spawn()
        .map_err(|e| Failure::lacking(format!("{} cannot be started: {e}", program.display())))?;
    if let Err(failure) = open(&mut child, emulator).and_then(|()| emulator.run()) {
        let _ = child.kill();
        let _ = child.wait();
        return Err(failure);
    }
    // It ends by itself: on the frame's end, on silence, and when the line is cut.
    let status = child
        .wait()
        .during(|| "waiting for the receiver".to_string())?;
    let report = fs::read_to_string(report)
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok())
        .unwrap_or(Value::Null);
    Ok(Received { status, report })
}

/// Waits until the receiver listens: what a board sends before that is lost.
fn open(child: &mut Child, emulator: &mut Emulator) -> Outcome<()> {
    let started = Instant::now();
    while !emulator.is_heard()? {
        if let Some(status) = child
            .try_wait()
            .during(|| "watching the receiver".to_string())?
        {
            return Err(Failure::incomplete(format!(
                "the receiver ended before it opened the line ({status})"
            )));
        }
        if started.elapsed() > OPENS_WITHIN {
            return Err(Failure::incomplete(format!(
                "the receiver did not open the line within {} s",
                OPENS_WITHIN.as_secs()
            )));
        }
        thread::sleep(Duration::from_millis(10));
    }
    Ok(())
}
