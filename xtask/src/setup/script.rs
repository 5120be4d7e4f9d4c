//! A machine for tests: it answers from a script, and remembers what was started on it.

use std::cell::RefCell;
use std::collections::HashMap;
use std::time::Duration;

use crate::command::{Finished, Runner};

/// Answers by command line; whatever has no answer can't be started.
#[derive(Debug, Default)]
pub struct Script {
    answers: HashMap<String, Finished>,
    absent: Vec<String>,
    shown: RefCell<Vec<String>>,
}

impl Script {
    /// This line succeeds and prints this.
    pub fn says(self, line: &str, stdout: &str) -> Self {
        self.answer(line, true, stdout)
    }

    /// This line fails.
    pub fn fails(self, line: &str) -> Self {
        self.answer(line, false, "")
    }

    /// This program is not there.
    pub fn lacks(mut self, program: &str) -> Self {
        self.absent.push(program.to_string());
        self
    }

    /// What was run with the terminal shared.
    pub fn shown(&self) -> Vec<String> {
        self.shown.borrow().clone()
    }

    fn answer(mut self, line: &str, success: bool, stdout: &str) -> Self {
        let finished = Finished {
            success,
            stdout: stdout.to_string(),
            stderr: String::new(),
        };
        self.answers.insert(line.to_string(), finished);
        self
    }
}

impl Runner for Script {
    fn has(&self, program: &str) -> bool {
        !self.absent.iter().any(|absent| absent == program)
    }

    fn capture(&self, line: &[&str]) -> Option<Finished> {
        self.answers.get(&line.join(" ")).cloned()
    }

    fn show(&self, line: &[&str], _: Option<Duration>) -> bool {
        self.shown.borrow_mut().push(line.join(" "));
        true
    }
}
