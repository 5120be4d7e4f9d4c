//! Counts of named things, and to which material and light they belong.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

/// Something that is done while shading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Step {
    /// What, such as `metal` or `sphere`.
    pub what: &'static str,
    /// Which way it goes, such as `outside`; empty where there is one.
    pub way: &'static str,
    /// Index of the material for which.
    pub material: Option<usize>,
    /// Index of the light for which.
    pub light: Option<usize>,
}

impl Step {
    /// The name under which its cost is kept.
    #[must_use]
    pub fn name(&self) -> String {
        if self.way.is_empty() {
            self.what.to_owned()
        } else {
            format!("{}, {}", self.what, self.way)
        }
    }
}

/// How often each step is done.
pub type Steps = BTreeMap<Step, u64>;

/// Counts steps, each for the material and the light that are at work.
#[derive(Debug, Default)]
pub(super) struct Tally {
    steps: RefCell<Steps>,
    pub(super) material: Cell<Option<usize>>,
    pub(super) light: Cell<Option<usize>>,
}

impl Tally {
    pub(super) fn add(&self, what: &'static str, way: &'static str, times: u64) {
        let step = Step {
            what,
            way,
            material: self.material.get(),
            light: self.light.get(),
        };
        *self.steps.borrow_mut().entry(step).or_default() += times;
    }

    /// What was counted since the last time.
    pub(super) fn take(&self) -> Steps {
        self.material.set(None);
        self.light.set(None);
        self.steps.take()
    }
}
