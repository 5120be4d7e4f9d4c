//! What `apt-get` would do: its own simulation, read.

use crate::command::Runner;

/// What installing some packages would mean.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Quote {
    /// Packages that would be installed or upgraded, with versions.
    pub install: Vec<(String, String)>,
    /// Packages that would be removed: then nothing is done without the user.
    pub remove: Vec<String>,
    /// Bytes to fetch; `None` where apt does not say.
    pub download: Option<u64>,
    /// Bytes on disk afterwards; `None` where apt does not say.
    pub disk: Option<u64>,
    /// apt's own words where it cannot install them at all.
    pub refused: Option<String>,
}

/// Option that every installation is simulated and run with.
pub const LEAN: &str = "--no-install-recommends";

/// The candidate version of a package; `None` where the package lists don't know it.
pub fn candidate(runner: &dyn Runner, package: &str) -> Option<String> {
    policy(runner, package, "Candidate:")
}

/// The installed version of a package; `None` where it is not installed.
pub fn installed(runner: &dyn Runner, package: &str) -> Option<String> {
    policy(runner, package, "Installed:")
}

fn policy(runner: &dyn Runner, package: &str, line: &str) -> Option<String> {
    let policy = runner.capture(&["apt-cache", "policy", package])?;
    let version = policy
        .stdout
        .lines()
        .find_map(|text| text.trim().strip_prefix(line))?;
    let version = version.trim();
    (version != "(none)").then(|| version.to_string())
}

/// Simulates the installation.
pub fn quote(runner: &dyn Runner, packages: &[&str]) -> Quote {
    // Without `--no-remove`, so that what would be removed can be named.
    let mut line = vec!["apt-get", "-s", "install", LEAN];
    line.extend(packages);
    let Some(simulated) = runner.capture(&line) else {
        return Quote {
            refused: Some("apt-get cannot be started".into()),
            ..Quote::default()
        };
    };
    let mut quote = read_simulation(&simulated.stdout);
    if !simulated.success {
        let words = if simulated.stderr.trim().is_empty() {
            simulated.stdout.trim()
        } else {
            simulated.stderr.trim()
        };
        quote.refused = Some(words.to_string());
        return quote;
    }
    let mut line = vec!["apt-get", "install", "-qq", "--print-uris", LEAN];
    line.extend(packages);
    quote.download = runner
        .capture(&line)
        .filter(|run| run.success)
        .and_then(|run| read_downloads(&run.stdout));
    let named: Vec<String> = quote
        .install
        .iter()
        .map(|(name, version)| format!("{name}={version}"))
        .collect();
    let mut line = vec!["apt-cache", "show"];
    line.extend(named.iter().map(String::as_str));
    quote.disk = runner
        .capture(&line)
        .filter(|run| run.success)
        .and_then(|run| read_sizes(&run.stdout));
    quote
}

/// Reads `Inst` and `Remv` lines.
fn read_simulation(text: &str) -> Quote {
    let mut quote = Quote::default();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match (words.next(), words.next()) {
            (Some("Inst"), Some(name)) => {
                let version = line
                    .split_once('(')
                    .and_then(|(_, rest)| rest.split_whitespace().next())
                    .unwrap_or_default();
                quote.install.push((name.to_string(), version.to_string()));
            }
            (Some("Remv" | "Purg"), Some(name)) => quote.remove.push(name.to_string()),
            _ => {}
        }
    }
    quote
}

/// Adds up the lines `'address' file bytes checksum`.
fn read_downloads(text: &str) -> Option<u64> {
    text.lines()
        .filter(|line| line.starts_with('\''))
        .map(|line| line.split_whitespace().nth(2)?.parse::<u64>().ok())
        .sum()
}

/// Adds up `Installed-Size`, which is in KiB.
fn read_sizes(text: &str) -> Option<u64> {
    text.lines()
        .filter_map(|line| line.strip_prefix("Installed-Size:"))
        .map(|size| size.trim().parse::<u64>().ok().map(|kib| kib * 1024))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simulation_with_a_removal() {
        let quote = read_simulation(
            "Reading package lists...\nThe following packages will be REMOVED:\n  cargo-web rustc-web\n\
             Remv cargo-web [1.96.0+dfsg1-1~deb12u2]\nRemv rustc-web [1.96.0+dfsg1-1~deb12u2]\n\
             Inst libstd-rust-dev (1.63.0+dfsg1-2 Debian:12.15/oldstable [amd64])\n\
             Inst rustc [1.60.0] (1.63.0+dfsg1-2 Debian:12.15/oldstable [amd64])\n\
             Conf rustc (1.63.0+dfsg1-2 Debian:12.15/oldstable [amd64])\n",
        );
        assert_eq!(quote.remove, ["cargo-web", "rustc-web"]);
        assert_eq!(
            quote.install,
            [
                ("libstd-rust-dev".to_string(), "1.63.0+dfsg1-2".to_string()),
                ("rustc".to_string(), "1.63.0+dfsg1-2".to_string())
            ]
        );
    }

    #[test]
    fn download_is_the_sum_of_all_files() {
        let text = "'http://example.org/a.deb' a_1%3a7.2_amd64.deb 62603724 MD5Sum:d6d8\n\
                    'http://example.org/b.deb' b_1_all.deb 1000 SHA256:00\n";
        assert_eq!(read_downloads(text), Some(62_604_724));
        assert_eq!(read_downloads(""), Some(0));
        assert_eq!(
            read_downloads("'http://example.org/a.deb' a.deb many MD5Sum:d\n"),
            None
        );
    }

    #[test]
    fn disk_is_in_kib() {
        assert_eq!(
            read_sizes("Package: a\nInstalled-Size: 10\n\nPackage: b\nInstalled-Size: 2\n"),
            Some(12 * 1024)
        );
    }
}
