//! The receiver, started beside an emulator.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::failure::{During, Failure, Outcome};
use crate::layout::Layout;
use crate::qemu::Emulator;

/// How long the receiver may take to open its port.
const OPENS_WITHIN: Duration = Duration::from_secs(30);

/// One start of the receiver.
#[derive(Debug, Clone)]
pub struct Reception {
    /// What it opens, where that is not the board's own line.
    pub port: Option<String>,
    /// Seconds of silence after which it gives up, where the default does not suit.
    pub silence: Option<u32>,
    /// The picture that it writes.
    pub picture: PathBuf,
    /// The report that it writes.
    pub report: PathBuf,
    /// A file for what it says, where the terminal is not the place.
    pub messages: Option<PathBuf>,
    /// A file for the bytes of the device's log.
    pub log: Option<PathBuf>,
}

/// What came of receiving.
#[derive(Debug)]
pub struct Received {
    /// How the receiver ended: 0 only where the frame is whole.
    pub status: ExitStatus,
    /// What it reported; null where it wrote no report.
    pub report: Value,
}

impl Reception {
    /// A reception of the board's own line into a folder.
    pub fn into(folder: &Path) -> Self {
        Self {
            port: None,
            silence: None,
            picture: folder.join("device.png"),
            report: folder.join("receiver.json"),
            messages: None,
            log: None,
        }
    }

    /// Receives one frame of an emulator that was started halted, and lets it run once the receiver listens.
    /// Picture and report of an earlier reception are taken away first.
    pub fn run(&self, layout: &Layout, emulator: &mut Emulator) -> Outcome<Received> {
        for old in [&self.picture, &self.report].into_iter().chain(&self.log) {
            if old.exists() {
                fs::remove_file(old).during(|| format!("removing {}", old.display()))?;
            }
        }
        let mut child = self.start(layout, emulator)?;
        if let Err(failure) = open(&mut child, emulator).and_then(|()| emulator.run()) {
            let _ = child.kill();
            let _ = child.wait();
            return Err(failure);
        }
        // It ends by itself: on the frame's end, on silence, and when the line is cut.
        let status = child
            .wait()
            .during(|| "waiting for the receiver".to_string())?;
        let report = fs::read_to_string(&self.report)
            .ok()
            .and_then(|text| serde_json::from_str(&text).ok())
            .unwrap_or(Value::Null);
        Ok(Received { status, report })
    }

    fn start(&self, layout: &Layout, emulator: &mut Emulator) -> Outcome<Child> {
        let program = layout.venv_program("microbrdf-receive");
        let mut command = Command::new(&program);
        match &self.port {
            Some(port) => command.arg(port),
            None => command.arg(format!("socket://{}", emulator.line()?)),
        };
        command
            .arg("-o")
            .arg(&self.picture)
            .arg("--report")
            .arg(&self.report);
        if let Some(seconds) = self.silence {
            command.arg("--timeout").arg(seconds.to_string());
        }
        if let Some(log) = &self.log {
            command.arg("--log").arg(log);
        }
        if let Some(path) = &self.messages {
            let name = || format!("writing {}", path.display());
            let log = fs::File::create(path).during(name)?;
            command.stdout(log.try_clone().during(name)?).stderr(log);
        }
        command
            .stdin(Stdio::null())
            .spawn()
            .map_err(|e| Failure::lacking(format!("{} cannot be started: {e}", program.display())))
    }
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
