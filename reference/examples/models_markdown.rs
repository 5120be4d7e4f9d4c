//! Writes docs/models.md anew: `models_markdown docs/models.md`, or prints it.

use std::process::ExitCode;

fn main() -> ExitCode {
    let text = microbrdf_reference::documentation::models_markdown();
    match std::env::args().nth(1) {
        None => print!("{text}"),
        Some(path) => {
            if let Err(e) = std::fs::write(&path, text) {
                eprintln!("{path}: {e}");
                return ExitCode::from(3);
            }
        }
    }
    ExitCode::SUCCESS
}
