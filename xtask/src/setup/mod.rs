//! `cargo xtask setup`: finds what the machine lacks, asks, and installs. The other commands call it first.

pub mod apt;
pub mod consent;
pub mod deny;
pub mod emulator;
pub mod node;
pub mod offer;
pub mod plan;
pub mod python;
#[cfg(test)]
pub mod script;
pub mod unpacked;

use crate::command::Runner;
use crate::failure::{Failure, Outcome};
use crate::layout::Layout;
use crate::measure;
use crate::toolchain::{self, Cross, distribution, sysroot};
use consent::Asking;
use offer::Offer;
use plan::{Local, Plan};

/// What the machine is to be able to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// Build firmware.
    Firmware,
    /// Build it, run it in an emulator, receive its frame.
    Demo,
    /// Count the cycles of kernels.
    Measure,
    /// All of this, and everything that is checked.
    Test,
}

impl Purpose {
    /// Whether boards are emulated, and their frames received.
    pub fn runs(self) -> bool {
        matches!(self, Self::Demo | Self::Test)
    }

    /// Whether kernels are counted.
    pub fn counts(self) -> bool {
        matches!(self, Self::Measure | Self::Test)
    }
}

/// `cargo xtask setup`.
pub fn command(layout: &Layout, purpose: Purpose, dry_run: bool, yes: bool) -> Outcome<()> {
    let runner = crate::command::Machine;
    if dry_run {
        let plan = Plan::survey(layout, &runner, purpose, &measure::with_boards(), false)?;
        if !plan.is_empty() {
            print!("{}", Offer::new(&runner, &plan).words());
            println!("Nothing was changed (--dry-run).");
            return Ok(());
        }
    }
    let cross = ensure(layout, &runner, purpose, &measure::with_boards(), yes)?;
    println!("{}", cross.chosen(layout));
    println!("Nothing is missing.");
    Ok(())
}

/// Sees to it that nothing is missing, and returns the cross compiler.
pub fn ensure(
    layout: &Layout,
    runner: &dyn Runner,
    purpose: Purpose,
    targets: &[&'static str],
    yes: bool,
) -> Outcome<Cross> {
    let asking = Asking::from_environment(yes);
    let mut rustup_failed = false;
    let mut lists_updated = false;
    loop {
        let plan = Plan::survey(layout, runner, purpose, targets, rustup_failed)?;
        if plan.is_empty() {
            break;
        }
        let offer = Offer::new(runner, &plan);
        print!("{}", offer.words());
        match carry_out(
            layout,
            runner,
            purpose,
            &offer,
            &plan,
            asking,
            lists_updated,
        )? {
            Step::Done => {
                let left = Plan::survey(layout, runner, purpose, targets, rustup_failed)?;
                if !left.is_empty() {
                    return Err(Failure::lacking(format!(
                        "after installing, this is still missing:\n{}",
                        Offer::new(runner, &left).words()
                    )));
                }
            }
            Step::RustupFailed => rustup_failed = true,
            Step::ListsUpdated => lists_updated = true,
        }
    }
    toolchain::ready(layout, runner, targets, purpose == Purpose::Test)?
        .ok_or_else(|| Failure::lacking("no cross compiler"))
}

/// How far a plan was carried out.
enum Step {
    Done,
    RustupFailed,
    ListsUpdated,
}

fn carry_out(
    layout: &Layout,
    runner: &dyn Runner,
    purpose: Purpose,
    offer: &Offer<'_>,
    plan: &Plan,
    asking: Asking,
    lists_updated: bool,
) -> Outcome<Step> {
    if offer.by_hand() && plan.local.contains(&Local::Venv) && python::can_make_venv(runner) {
        // The receiver is of use without an emulator too.
        python::install(layout)?;
    }
    offer.agree(runner, asking)?;
    if !plan.targets.is_empty() && !offer.add_targets(runner) {
        if toolchain::asked_for()?.is_some() || !runner.has("apt-get") {
            return Err(Failure::lacking(format!(
                "rustup could not add the targets. Where its servers can be reached, this adds them:\n{}",
                offer.line()
            )));
        }
        println!("rustup could not add the targets; the distribution's compiler is taken instead.");
        return Ok(Step::RustupFailed);
    }
    if !plan.packages.is_empty() {
        if lists_updated && offer.needs_lists() {
            return Err(Failure::lacking(offer.unknown_words()));
        }
        // A failed installation may come from old lists: fetch them once and look again.
        if offer.needs_lists() || !offer.install(runner) {
            if lists_updated {
                return Err(Failure::lacking(format!(
                    "apt-get failed; the line was\n{}",
                    offer.line()
                )));
            }
            offer.update_lists(runner)?;
            return Ok(Step::ListsUpdated);
        }
    }
    for local in &plan.local {
        make(layout, purpose, runner, local)?;
    }
    Ok(Step::Done)
}

fn make(layout: &Layout, purpose: Purpose, runner: &dyn Runner, local: &Local) -> Outcome<()> {
    match local {
        Local::Sysroot(targets) => {
            let compiler =
                distribution::installed(runner, purpose == Purpose::Test).ok_or_else(|| {
                    Failure::lacking(format!(
                        "the distribution's compiler is missing or older than Rust {}",
                        toolchain::oldest_words()
                    ))
                })?;
            sysroot::build(layout, &compiler, targets)
        }
        Local::Emulator => emulator::unpack(layout, runner),
        Local::Venv => python::install(layout),
        Local::Counter => python::install_counter(layout),
        Local::Rp2040js => node::install(layout),
        Local::CargoDeny => deny::install(layout),
    }
}
