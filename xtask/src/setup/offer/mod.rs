//! A plan with its price, put to the user: what would be installed, how big it is, what would go.

use std::fmt::Write as _;
use std::time::Duration;

use crate::command::{Runner, typed};
use crate::failure::{Failure, Outcome};
use crate::setup::apt::{self, Quote};
use crate::setup::consent::{self, Asking, Change, Rights, Verdict};
use crate::setup::plan::Plan;
use crate::toolchain::{self, active};

/// How long rustup may take before the distribution's compiler is tried in its place.
const RUSTUP_LIMIT: Duration = Duration::from_secs(180);

/// A plan, and what the package manager says to it.
#[derive(Debug)]
pub struct Offer<'a> {
    plan: &'a Plan,
    rights: Rights,
    /// Whether packages can be installed with apt-get here.
    apt: bool,
    /// Packages that the package lists don't know.
    unknown: Vec<&'static str>,
    quote: Quote,
}

impl<'a> Offer<'a> {
    /// Asks the package manager what the plan would mean. Changes nothing.
    pub fn new(runner: &dyn Runner, plan: &'a Plan) -> Self {
        let apt = runner.has("apt-get");
        let names: Vec<&'static str> = plan.packages.iter().map(|(name, _)| *name).collect();
        let mut unknown = Vec::new();
        let mut quote = Quote::default();
        let mut rights = Rights::None;
        if apt && !names.is_empty() {
            rights = Rights::of(runner);
            unknown = names
                .iter()
                .copied()
                .filter(|name| apt::candidate(runner, name).is_none())
                .collect();
            if unknown.is_empty() && plan.too_old.is_none() {
                quote = apt::quote(runner, &names);
            }
        }
        Self {
            plan,
            rights,
            apt,
            unknown,
            quote,
        }
    }

    /// Whether the lists have to be fetched before anything can be said.
    pub fn needs_lists(&self) -> bool {
        !self.unknown.is_empty() || self.plan.too_old.is_some()
    }

    /// Whether packages are missing where apt-get is not: the user has to bring them.
    pub fn by_hand(&self) -> bool {
        !self.apt && !self.plan.packages.is_empty()
    }

    /// What is missing, what would be done, what it costs.
    pub fn words(&self) -> String {
        let mut text = String::from("Missing:\n");
        if !self.plan.targets.is_empty() {
            let _ = writeln!(
                text,
                "  {} (targets of the active toolchain, by rustup; where its servers can't be reached, the distribution's compiler is offered next)",
                self.plan.targets.join(", ")
            );
        }
        for (name, reason) in &self.plan.packages {
            let _ = writeln!(text, "  {name} ({reason})");
        }
        for local in &self.plan.local {
            let _ = writeln!(text, "  {}", local.words());
        }
        if self.apt && !self.plan.packages.is_empty() {
            self.price(&mut text);
        }
        text
    }

    fn price(&self, text: &mut String) {
        if self.needs_lists() {
            let _ = writeln!(text, "{}", self.unknown_words());
        } else if let Some(refused) = &self.quote.refused {
            let _ = writeln!(text, "apt-get says that it cannot install them:\n{refused}");
        } else {
            let named: Vec<&str> = self.quote.install.iter().map(|(n, _)| n.as_str()).collect();
            let _ = writeln!(
                text,
                "apt-get would install {} packages ({} to fetch, {} on disk): {}",
                named.len(),
                size(self.quote.download),
                size(self.quote.disk),
                named.join(" ")
            );
        }
        if !self.quote.remove.is_empty() {
            let _ = writeln!(
                text,
                "apt-get would REMOVE: {}",
                self.quote.remove.join(" ")
            );
        }
    }

    /// Says what the package lists lack.
    pub fn unknown_words(&self) -> String {
        if let Some((name, version)) = &self.plan.too_old {
            return format!(
                "The package lists hold {name} only in version {version}; at least Rust {} is needed \
                 (`apt-get update` fetches newer lists; or `rustup` brings a newer Rust).",
                toolchain::oldest_words()
            );
        }
        format!(
            "The package lists don't know {} (or are empty: `apt-get update` fetches them).",
            self.unknown.join(", ")
        )
    }

    /// Returns where the plan may be carried out; asks if it must.
    pub fn agree(&self, runner: &dyn Runner, asking: Asking) -> Outcome<()> {
        if self.by_hand() {
            return Err(Failure::lacking(self.by_hand_words(runner)));
        }
        if let Some(refused) = &self.quote.refused {
            return Err(Failure::lacking(format!(
                "apt-get cannot install the packages: {refused}\nThe line was\n{}",
                self.line()
            )));
        }
        let change = Change {
            packages: !self.plan.packages.is_empty(),
            targets: !self.plan.targets.is_empty(),
            removes: !self.quote.remove.is_empty(),
        };
        let reason = match consent::decide(change, self.rights, asking) {
            Verdict::GoOn => return Ok(()),
            Verdict::Ask if consent::ask() => return Ok(()),
            Verdict::Ask => "not agreed to",
            Verdict::Stop(reason) => reason,
        };
        Err(Failure::lacking(format!(
            "nothing was installed: {reason}. To run:\n{}",
            self.line()
        )))
    }

    /// The exact lines to run by hand.
    pub fn line(&self) -> String {
        let mut lines = Vec::new();
        if !self.plan.targets.is_empty() {
            lines.push(format!(
                "  {}",
                typed(&active::add_line(&self.plan.targets))
            ));
        }
        if !self.plan.packages.is_empty() {
            let sudo = if self.rights == Rights::Root {
                ""
            } else {
                "sudo "
            };
            let update = if self.needs_lists() {
                format!("{sudo}apt-get update && ")
            } else {
                String::new()
            };
            let names: Vec<&str> = self.plan.packages.iter().map(|(name, _)| *name).collect();
            lines.push(format!(
                "  {update}{sudo}apt-get install {} {}",
                apt::LEAN,
                names.join(" ")
            ));
        }
        lines.join("\n")
    }

    /// For systems without apt-get: what to bring, and what works without.
    fn by_hand_words(&self, runner: &dyn Runner) -> String {
        let mut text =
            String::from("this system has no apt-get, so these have to be brought by hand:\n");
        for (name, reason) in &self.plan.packages {
            let _ = writeln!(text, "  {name} ({reason})");
        }
        if runner.has("rustup") {
            text.push_str("For the compiler, `rustup target add` is enough where its servers can be reached.\n");
        }
        text.push_str(
            "Without the emulator, `microbrdf device` stands in for the board: in one terminal\n  \
             cargo run --release -p microbrdf-sim -- device scenes/demo.toml --tcp 127.0.0.1:4000\n\
             and in another\n  \
             target/venv/bin/microbrdf-receive socket://127.0.0.1:4000 -o device.png",
        );
        text
    }

    /// Adds the targets; false where rustup could not.
    pub fn add_targets(&self, runner: &dyn Runner) -> bool {
        runner.show(&active::add_line(&self.plan.targets), Some(RUSTUP_LIMIT))
    }

    /// Fetches the package lists.
    pub fn update_lists(&self, runner: &dyn Runner) -> Outcome<()> {
        if runner.show(&self.with_rights(&["apt-get", "update", "-q"]), None) {
            return Ok(());
        }
        Err(Failure::lacking(
            "`apt-get update` failed, so packages cannot be found",
        ))
    }

    /// Installs the packages; false where apt-get failed, which an update of its lists may cure.
    pub fn install(&self, runner: &dyn Runner) -> bool {
        let mut line = vec![
            "apt-get",
            "install",
            "-y",
            "-q",
            "-o",
            "DPkg::Lock::Timeout=120",
            apt::LEAN,
        ];
        // The simulation removed nothing; this holds apt to it.
        line.push("--no-remove");
        line.extend(self.plan.packages.iter().map(|(name, _)| *name));
        runner.show(&self.with_rights(&line), None)
    }

    fn with_rights<'l>(&self, line: &[&'l str]) -> Vec<&'l str> {
        let mut full = Vec::new();
        if self.rights == Rights::Sudo {
            full.extend(["sudo", "-n", "DEBIAN_FRONTEND=noninteractive"]);
        }
        full.extend(line);
        full
    }
}

/// A size in words.
fn size(bytes: Option<u64>) -> String {
    match bytes {
        Some(bytes) => format!("{:.1} MB", bytes as f64 / 1e6),
        None => "size unknown".to_string(),
    }
}

#[cfg(test)]
mod tests;
