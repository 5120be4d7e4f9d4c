//! QEMU: installed; or, where that would remove other packages (newer ones of its own family, say), unpacked under `target/`.

use std::path::PathBuf;
use std::process::Command;

use super::{apt, unpacked};
use crate::command::Runner;
use crate::failure::Outcome;
use crate::layout::Layout;

/// The program, and its package.
pub const PROGRAM: &str = "qemu-system-arm";

/// Whether there is one.
pub fn is_there(layout: &Layout, runner: &dyn Runner) -> bool {
    runner.has(PROGRAM) || root(layout).join("usr/bin").join(PROGRAM).is_file()
}

/// Whether installing it would remove something.
pub fn is_in_the_way(runner: &dyn Runner) -> bool {
    let quote = apt::quote(runner, &[PROGRAM]);
    quote.refused.is_none() && !quote.remove.is_empty() && runner.has("dpkg-deb")
}

/// Unpacks it.
pub fn unpack(layout: &Layout, runner: &dyn Runner) -> Outcome<()> {
    unpacked::fetch(runner, &[PROGRAM], &root(layout))
}

/// The program: what is unpacked, if it is, for it was so on purpose.
pub fn command(layout: &Layout) -> Command {
    let root = root(layout);
    if !root.join("usr/bin").join(PROGRAM).is_file() {
        return Command::new(PROGRAM);
    }
    let mut command = unpacked::program(&root, PROGRAM);
    command.arg("-L").arg(root.join("usr/share/qemu"));
    command
}

fn root(layout: &Layout) -> PathBuf {
    layout.target().join("emulator")
}

#[cfg(test)]
mod tests {
    use super::is_in_the_way;
    use crate::setup::script::Script;

    const SIMULATION: &str = "apt-get -s install --no-install-recommends qemu-system-arm";

    #[test]
    fn it_is_in_the_way_of_what_would_be_removed() {
        let machine = |words| Script::default().says(SIMULATION, words);
        let new = "Inst qemu-system-arm (1:7.2 X [amd64])\n";
        assert!(!is_in_the_way(&machine(new)));
        let removed = "Remv qemu-utils [1:10.0]\nInst qemu-system-arm (1:7.2 X [amd64])\n";
        assert!(is_in_the_way(&machine(removed)));
        assert!(!is_in_the_way(&machine(removed).lacks("dpkg-deb")));
        // Nothing is known of it.
        assert!(!is_in_the_way(&Script::default()));
    }
}
