//! Offers put to a scripted machine.

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
