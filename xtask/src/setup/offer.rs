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
mod tests {
    use super::*;
    use crate::setup::script::Script;

    const AGREED: Asking = Asking {
        agreed: true,
        terminal: false,
    };
    const NOBODY: Asking = Asking {
        agreed: false,
        terminal: false,
    };

    fn plan() -> Plan {
        Plan {
            packages: vec![("qemu-system-arm", "emulator of the boards")],
            ..Plan::default()
        }
    }

    /// A machine whose package lists know the emulator.
    fn machine() -> Script {
        Script::default()
            .says("id -u", "0\n")
            .says("apt-cache policy qemu-system-arm", "q:\n  Installed: (none)\n  Candidate: 1:7.2\n")
            .says(
                "apt-get -s install --no-install-recommends qemu-system-arm",
                "Inst libfdt1 (1.6.1-4 X [amd64])\nInst qemu-system-arm (1:7.2 X [amd64])\n",
            )
            .says(
                "apt-get install -qq --print-uris --no-install-recommends qemu-system-arm",
                "'http://example.org/a.deb' a.deb 2500000 MD5Sum:0\n'http://example.org/b.deb' b.deb 500000 MD5Sum:0\n",
            )
            .says(
                "apt-cache show libfdt1=1.6.1-4 qemu-system-arm=1:7.2",
                "Installed-Size: 1000\n\nInstalled-Size: 9000\n",
            )
    }

    #[test]
    fn says_packages_sizes_and_goes_on_when_agreed() {
        let (plan, machine) = (plan(), machine());
        let offer = Offer::new(&machine, &plan);
        let words = offer.words();
        assert!(
            words.contains("qemu-system-arm (emulator of the boards)"),
            "{words}"
        );
        assert!(
            words.contains("2 packages (3.0 MB to fetch, 10.2 MB on disk)"),
            "{words}"
        );
        assert!(!words.contains("REMOVE"), "{words}");
        assert_eq!(offer.agree(&machine, AGREED), Ok(()));
        assert!(offer.install(&machine));
        let shown = machine.shown();
        assert_eq!(shown.len(), 1);
        assert!(shown[0].starts_with("apt-get install -y") && shown[0].contains("--no-remove"));
    }

    #[test]
    fn without_terminal_or_yes_the_line_is_printed_with_status_3() {
        let (plan, machine) = (plan(), machine());
        let failure = Offer::new(&machine, &plan)
            .agree(&machine, NOBODY)
            .unwrap_err();
        assert_eq!(failure.status, 3);
        let line = "  apt-get install --no-install-recommends qemu-system-arm";
        assert!(
            failure.message.lines().any(|found| found == line),
            "{failure}"
        );
        assert!(machine.shown().is_empty());
    }

    #[test]
    fn a_removal_is_named_and_stops_with_status_3() {
        let plan = plan();
        let machine = machine().says(
            "apt-get -s install --no-install-recommends qemu-system-arm",
            "Remv precious [1.0]\nInst qemu-system-arm (1:7.2 X [amd64])\n",
        );
        let offer = Offer::new(&machine, &plan);
        assert!(offer.words().contains("would REMOVE: precious"));
        let failure = offer.agree(&machine, AGREED).unwrap_err();
        assert_eq!(failure.status, 3);
        assert!(failure.message.contains("apt-get install"), "{failure}");
    }

    #[test]
    fn without_rights_the_line_has_sudo() {
        let plan = plan();
        let machine = machine().says("id -u", "1000\n").fails("sudo -n true");
        let failure = Offer::new(&machine, &plan)
            .agree(&machine, AGREED)
            .unwrap_err();
        assert_eq!(failure.status, 3);
        assert!(
            failure.message.contains("  sudo apt-get install"),
            "{failure}"
        );
    }

    #[test]
    fn sudo_without_a_password_is_used_and_never_asks() {
        let plan = plan();
        let machine = machine().says("id -u", "1000\n").says("sudo -n true", "");
        let offer = Offer::new(&machine, &plan);
        assert_eq!(offer.agree(&machine, AGREED), Ok(()));
        assert!(offer.install(&machine));
        assert!(
            machine.shown()[0].starts_with("sudo -n "),
            "{:?}",
            machine.shown()
        );
    }

    #[test]
    fn unknown_packages_ask_for_lists_first() {
        let plan = plan();
        let machine = machine().says("apt-cache policy qemu-system-arm", "");
        let offer = Offer::new(&machine, &plan);
        assert!(offer.needs_lists());
        assert!(
            offer.line().contains("apt-get update && apt-get install"),
            "{}",
            offer.line()
        );
    }

    #[test]
    fn a_compiler_that_is_too_old_names_the_least_version() {
        let plan = Plan {
            too_old: Some(("rustc-web", "1.63.0".to_string())),
            ..plan()
        };
        let machine = machine();
        let offer = Offer::new(&machine, &plan);
        assert!(offer.needs_lists());
        let words = offer.words();
        assert!(
            words.contains("1.63.0") && words.contains(&toolchain::oldest_words()),
            "{words}"
        );
    }

    #[test]
    fn without_apt_the_stand_in_is_named() {
        let plan = plan();
        let machine = Script::default().lacks("apt-get");
        let failure = Offer::new(&machine, &plan)
            .agree(&machine, AGREED)
            .unwrap_err();
        assert_eq!(failure.status, 3);
        for word in ["qemu-system-arm", "microbrdf-sim", "microbrdf-receive"] {
            assert!(failure.message.contains(word), "{failure}");
        }
    }
}
