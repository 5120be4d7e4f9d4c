//! What is missing, and what would bring it.

use crate::command::Runner;
use crate::failure::Outcome;
use crate::layout::Layout;
use crate::setup::{Purpose, apt, deny, emulator, node, python};
use crate::toolchain::distribution::{self, FAMILIES, Family};
use crate::toolchain::{self, Way, active, sysroot};

/// What is missing for a purpose, sorted by how it is brought.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Plan {
    /// Targets to be added to the active toolchain by rustup.
    pub targets: Vec<&'static str>,
    /// System packages, each with what it is for.
    pub packages: Vec<(&'static str, &'static str)>,
    /// A compiler package that the package lists hold only in this, too old, version.
    pub too_old: Option<(&'static str, String)>,
    /// Things made under `target/`.
    pub local: Vec<Local>,
}

/// Something made under `target/`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Local {
    /// `core` for some targets, from the distribution's source.
    Sysroot(Vec<&'static str>),
    /// QEMU, from the distribution's packages.
    Emulator,
    /// The virtual environment with the receiver.
    Venv,
    /// The counter of cycles, in the same environment.
    Counter,
    /// The emulator that cycles are compared with, from npm.
    Rp2040js,
    /// cargo-deny, from crates.io.
    CargoDeny,
}

impl Local {
    /// In words.
    pub fn words(&self) -> String {
        match self {
            Self::Sysroot(targets) => {
                format!(
                    "core for {}, built from source (about 30 s each)",
                    targets.join(", ")
                )
            }
            Self::Emulator => "qemu-system-arm, emulator of the boards, unpacked into \
                               target/emulator, since installing it would remove packages"
                .to_string(),
            Self::Venv => "virtual environment with the receiver (target/venv)".to_string(),
            Self::Counter => "counter of cycles, with its emulator (target/venv)".to_string(),
            Self::Rp2040js => {
                "rp2040js, an emulator to compare cycles with (target/node)".to_string()
            }
            Self::CargoDeny => {
                format!(
                    "cargo-deny {}, built from crates.io (about 1 min)",
                    deny::VERSION
                )
            }
        }
    }
}

impl Plan {
    /// Whether nothing is missing.
    pub fn is_empty(&self) -> bool {
        self.targets.is_empty() && self.packages.is_empty() && self.local.is_empty()
    }

    /// Looks at the machine. `rustup_failed`: rustup was tried and could not bring the targets.
    pub fn survey(
        layout: &Layout,
        runner: &dyn Runner,
        purpose: Purpose,
        targets: &[&'static str],
        rustup_failed: bool,
    ) -> Outcome<Self> {
        let mut plan = Self::default();
        plan.compiler(layout, runner, purpose, targets, rustup_failed)?;
        if purpose.runs() && !emulator::is_there(layout, runner) {
            if emulator::is_in_the_way(runner) {
                plan.local.push(Local::Emulator);
            } else {
                plan.packages
                    .push((emulator::PROGRAM, "emulator of the boards"));
            }
        }
        if purpose.counts() {
            for (program, package) in [("verilator", "verilator"), ("g++", "g++"), ("make", "make")]
            {
                if !runner.has(program) {
                    plan.packages
                        .push((package, "simulator of a RISC-V core from its source"));
                }
            }
        }
        let python = purpose.runs() || purpose.counts();
        if python && !python::current(layout) {
            if !python::can_make_venv(runner) {
                plan.packages
                    .push(("python3-venv", "virtual environment for the receiver"));
            }
            plan.local.push(Local::Venv);
        }
        if purpose.counts() && !python::counter_current(layout) {
            plan.local.push(Local::Counter);
        }
        if purpose == Purpose::Test && !node::current(layout) {
            for (program, package) in node::PROGRAMS {
                if !runner.has(program) {
                    plan.packages
                        .push((package, "second source for cycles on Cortex-M0+"));
                }
            }
            plan.local.push(Local::Rp2040js);
        }
        if purpose == Purpose::Test && deny::program(layout, runner).is_none() {
            plan.local.push(Local::CargoDeny);
        }
        Ok(plan)
    }

    fn compiler(
        &mut self,
        layout: &Layout,
        runner: &dyn Runner,
        purpose: Purpose,
        targets: &[&'static str],
        rustup_failed: bool,
    ) -> Outcome<()> {
        let clippy = purpose == Purpose::Test;
        if toolchain::ready(layout, runner, targets, clippy)?.is_some() {
            return Ok(());
        }
        let asked = toolchain::asked_for()?;
        let compiler = match asked {
            Some(Way::Active) => None,
            _ => distribution::installed(runner, clippy),
        };
        if let Some(compiler) = compiler {
            let folder = sysroot::folder(layout, &compiler);
            let missing = targets
                .iter()
                .copied()
                .filter(|target| !sysroot::holds(&folder, target));
            self.local.push(Local::Sysroot(missing.collect()));
        } else if asked == Some(Way::Active)
            || (asked.is_none() && !rustup_failed && active::from_rustup(runner))
        {
            self.targets.extend(targets);
        } else {
            let family = self.choose_family(runner);
            for package in family.packages {
                self.packages
                    .push((package, "compiler for the boards, with its source"));
            }
            self.packages.push((distribution::LINKER, "linker"));
            if clippy {
                self.packages.push((family.clippy, "lints of the firmware"));
            }
            self.local.push(Local::Sysroot(targets.to_vec()));
        }
        Ok(())
    }

    /// The family that is installed, else the first one that can be, each if new enough; else the first of all, with a word on why it won't do.
    fn choose_family(&mut self, runner: &dyn Runner) -> &'static Family {
        let new_enough = |version: Option<String>| {
            version
                .and_then(|version| distribution::release(&version))
                .is_some_and(|release| release >= toolchain::oldest())
        };
        let rustc = |family: &Family| family.packages[0];
        // Families exclude each other: another one than what is there would remove it.
        let there = |family: &&Family| new_enough(apt::installed(runner, rustc(family)));
        let offered = |family: &&Family| new_enough(apt::candidate(runner, rustc(family)));
        let families = || FAMILIES.iter();
        if let Some(family) = families().find(there).or_else(|| families().find(offered)) {
            return family;
        }
        let first = &FAMILIES[0];
        self.too_old = apt::candidate(runner, rustc(first)).map(|version| (rustc(first), version));
        first
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::script::Script;

    #[test]
    fn the_first_family_that_is_new_enough() {
        let mut plan = Plan::default();
        let script = Script::default().says(
            "apt-cache policy rustc-web",
            "rustc-web:\n  Candidate: 1.96.0+dfsg1-1\n",
        );
        assert_eq!(plan.choose_family(&script).packages[0], "rustc-web");
        assert_eq!(plan.too_old, None);
    }

    #[test]
    fn an_old_family_gives_way_to_a_new_one() {
        let mut plan = Plan::default();
        let script = Script::default()
            .says(
                "apt-cache policy rustc-web",
                "rustc-web:\n  Candidate: 1.78.0+dfsg1-1\n",
            )
            .says(
                "apt-cache policy rustc",
                "rustc:\n  Candidate: 1.100.0+dfsg1-1\n",
            );
        assert_eq!(plan.choose_family(&script).packages[0], "rustc");
        assert_eq!(plan.too_old, None);
    }

    #[test]
    fn an_installed_family_is_kept() {
        let mut plan = Plan::default();
        let script = Script::default()
            .says(
                "apt-cache policy rustc-web",
                "r:\n  Installed: (none)\n  Candidate: 1.100.0\n",
            )
            .says(
                "apt-cache policy rustc",
                "r:\n  Installed: 1.99.0\n  Candidate: 1.99.0\n",
            );
        assert_eq!(plan.choose_family(&script).packages[0], "rustc");
    }

    #[test]
    fn where_all_are_too_old_it_is_said() {
        let mut plan = Plan::default();
        let script = Script::default()
            .says(
                "apt-cache policy rustc-web",
                "rustc-web:\n  Candidate: 1.78.0+dfsg1-1\n",
            )
            .says("apt-cache policy rustc", "rustc:\n  Candidate: (none)\n");
        assert_eq!(plan.choose_family(&script).packages[0], "rustc-web");
        assert_eq!(
            plan.too_old,
            Some(("rustc-web", "1.78.0+dfsg1-1".to_string()))
        );
    }
}
