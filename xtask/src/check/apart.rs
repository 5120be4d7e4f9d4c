//! A step in a process of its own, so that what it prints, and all that it starts, can be told from what others do meanwhile.

use std::env;
use std::fs::{self, File};
use std::path::PathBuf;
use std::process::{Command, Stdio};

use super::counts::Tally;
use crate::failure::{During, Outcome};
use crate::layout::Layout;

/// Runs a step by this program, `test --step NAME`; what it printed, and what it counted. What ends without saying how it ended has failed.
pub fn run(layout: &Layout, name: &str, jobs: usize) -> Outcome<(String, Tally)> {
    let folder = layout.target().join("test").join("steps");
    fs::create_dir_all(&folder).during(|| format!("creating {}", folder.display()))?;
    let path = folder.join(file(name));
    let log = File::create(&path).during(|| format!("creating {}", path.display()))?;
    let both = log
        .try_clone()
        .during(|| format!("sharing {}", path.display()))?;
    let program = env::current_exe().during(|| "asking for this program".to_string())?;
    let status = Command::new(program)
        .args(["test", "--step", name, "--jobs", &jobs.to_string()])
        .stdin(Stdio::null())
        .stdout(log)
        .stderr(both)
        .status()
        .during(|| "starting this program".to_string())?;
    let output = fs::read(&path).during(|| format!("reading {}", path.display()))?;
    let (said, tally) = read(&String::from_utf8_lossy(&output));
    Ok(match tally {
        Some(tally) if status.success() => (said, tally),
        _ => (
            format!("{said}the step ended with {status}\n"),
            Tally::failed_at_least_once(Tally::default()),
        ),
    })
}

/// What was said, and the tally in its last line.
fn read(output: &str) -> (String, Option<Tally>) {
    let body = output.trim_end_matches('\n');
    let (said, last) = body.rsplit_once('\n').unwrap_or(("", body));
    match Tally::of_line(last) {
        Some(tally) if said.is_empty() => (String::new(), Some(tally)),
        Some(tally) => (format!("{said}\n"), Some(tally)),
        None if body.is_empty() => (String::new(), None),
        None => (format!("{body}\n"), None),
    }
}

/// A file name from a step's.
fn file(name: &str) -> PathBuf {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
    PathBuf::from(format!(
        "{}.log",
        name.chars().map(plain).collect::<String>()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_is_the_tally() {
        let counted = Tally {
            passed: 3,
            failed: 1,
            skipped: 0,
        };
        let (said, tally) = read("one\ntwo\n3 passed, 1 failed\n");
        assert_eq!((said.as_str(), tally), ("one\ntwo\n", Some(counted)));
        assert_eq!(read("3 passed, 1 failed\n"), (String::new(), Some(counted)));
    }

    #[test]
    fn what_breaks_off_has_no_tally() {
        for output in [
            "",
            "one\n3 passed, 1 fai",
            "3 passed, 0 failed\nthread panicked\n",
        ] {
            assert_eq!(read(output).1, None, "{output}");
        }
    }
}
