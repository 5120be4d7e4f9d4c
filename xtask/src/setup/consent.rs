//! May the machine be changed? Decided apart from doing it, so that every case can be tested.

use std::env;
use std::io::{self, BufRead, IsTerminal, Write};

use crate::command::Runner;

/// How packages can be installed here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rights {
    /// As root.
    Root,
    /// Through sudo, without being asked for a password.
    Sudo,
    /// Not at all.
    None,
}

impl Rights {
    /// Finds out, without asking for anything.
    pub fn of(runner: &dyn Runner) -> Self {
        let is_root = runner
            .capture(&["id", "-u"])
            .is_some_and(|id| id.stdout.trim() == "0");
        if is_root {
            Self::Root
        } else if runner
            .capture(&["sudo", "-n", "true"])
            .is_some_and(|sudo| sudo.success)
        {
            Self::Sudo
        } else {
            Self::None
        }
    }
}

/// Who can be asked, and whether one has to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Asking {
    /// `--yes`, or `CI=true`.
    pub agreed: bool,
    /// Someone sits at a terminal.
    pub terminal: bool,
}

impl Asking {
    /// From the command line and the environment.
    pub fn from_environment(yes: bool) -> Self {
        Self {
            agreed: yes || env::var("CI").as_deref() == Ok("true"),
            terminal: io::stdin().is_terminal() && io::stdout().is_terminal(),
        }
    }
}

/// What a plan would change outside `target/`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Change {
    /// Packages of the system, for which rights are needed.
    pub packages: bool,
    /// Targets of the user's own toolchain.
    pub targets: bool,
    /// Whether the package manager would remove something.
    pub removes: bool,
}

/// What to do with a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Carry it out.
    GoOn,
    /// Ask first.
    Ask,
    /// Print the line to run, and stop; the reason.
    Stop(&'static str),
}

/// Decides. Agreement in advance covers additions only: nothing is ever removed.
pub fn decide(change: Change, rights: Rights, asking: Asking) -> Verdict {
    if change.removes {
        Verdict::Stop("the package manager would remove packages, which is yours to decide")
    } else if change.packages && rights == Rights::None {
        Verdict::Stop("installing packages needs root, or sudo without a password")
    } else if asking.agreed || !(change.packages || change.targets) {
        Verdict::GoOn
    } else if asking.terminal {
        Verdict::Ask
    } else {
        Verdict::Stop("there is no terminal to ask on, and neither --yes nor CI=true was given")
    }
}

/// Asks on the terminal. Anything but yes is no.
pub fn ask() -> bool {
    print!("Install this now? [y/N] ");
    let _ = io::stdout().flush();
    let mut answer = String::new();
    io::stdin()
        .lock()
        .read_line(&mut answer)
        .is_ok_and(|_| agrees(&answer))
}

fn agrees(answer: &str) -> bool {
    ["y", "yes"].contains(&answer.trim().to_ascii_lowercase().as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PACKAGES: Change = Change {
        packages: true,
        targets: false,
        removes: false,
    };
    const TARGETS: Change = Change {
        packages: false,
        targets: true,
        removes: false,
    };
    const LOCAL: Change = Change {
        packages: false,
        targets: false,
        removes: false,
    };
    const AGREED: Asking = Asking {
        agreed: true,
        terminal: false,
    };
    const TERMINAL: Asking = Asking {
        agreed: false,
        terminal: true,
    };
    const NOBODY: Asking = Asking {
        agreed: false,
        terminal: false,
    };

    #[test]
    fn a_removal_stops_even_root_with_yes() {
        let change = Change {
            removes: true,
            ..PACKAGES
        };
        for rights in [Rights::Root, Rights::Sudo, Rights::None] {
            for asking in [AGREED, TERMINAL, NOBODY] {
                assert!(matches!(decide(change, rights, asking), Verdict::Stop(_)));
            }
        }
    }

    #[test]
    fn packages_need_rights_even_with_yes() {
        assert!(matches!(
            decide(PACKAGES, Rights::None, AGREED),
            Verdict::Stop(_)
        ));
        assert!(matches!(
            decide(PACKAGES, Rights::None, TERMINAL),
            Verdict::Stop(_)
        ));
        assert_eq!(decide(PACKAGES, Rights::Sudo, AGREED), Verdict::GoOn);
        assert_eq!(decide(PACKAGES, Rights::Root, AGREED), Verdict::GoOn);
    }

    #[test]
    fn a_terminal_is_asked_and_its_absence_stops() {
        for change in [PACKAGES, TARGETS] {
            assert_eq!(decide(change, Rights::Root, TERMINAL), Verdict::Ask);
            assert!(matches!(
                decide(change, Rights::Root, NOBODY),
                Verdict::Stop(_)
            ));
        }
    }

    #[test]
    fn targets_need_consent_but_no_rights() {
        assert_eq!(decide(TARGETS, Rights::None, AGREED), Verdict::GoOn);
        assert_eq!(decide(TARGETS, Rights::None, TERMINAL), Verdict::Ask);
    }

    #[test]
    fn what_stays_in_target_needs_no_consent() {
        assert_eq!(decide(LOCAL, Rights::None, NOBODY), Verdict::GoOn);
    }

    #[test]
    fn only_yes_is_yes() {
        assert!(agrees("y\n") && agrees("Yes\n") && agrees(" YES "));
        for answer in ["", "\n", "n\n", "no\n", "yup\n", "yes please\n"] {
            assert!(!agrees(answer), "{answer:?}");
        }
    }
}
