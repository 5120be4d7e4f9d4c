//! Why a command ends early, and with which exit status.

use std::fmt;

/// Result of anything that can end a command.
pub type Outcome<T> = Result<T, Failure>;

/// A reason to stop, with the exit status that all the project's commands share.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// 1 ran, but incomplete or different; 2 the user's mistake; 3 the environment lacks something.
    pub status: u8,
    /// What is said on standard error.
    pub message: String,
}

impl Failure {
    /// It ran, but the result is incomplete, differs, or a step failed.
    pub fn incomplete(message: impl Into<String>) -> Self {
        Self {
            status: 1,
            message: message.into(),
        }
    }

    /// The user asked for something that does not exist or makes no sense.
    pub fn mistake(message: impl Into<String>) -> Self {
        Self {
            status: 2,
            message: message.into(),
        }
    }

    /// The machine lacks something; the message says what, and how to get it.
    pub fn lacking(message: impl Into<String>) -> Self {
        Self {
            status: 3,
            message: message.into(),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// Says what was being done when an error came up.
pub trait During<T> {
    /// Turns the error into a failure of status 1 that begins with `what`.
    fn during(self, what: impl FnOnce() -> String) -> Outcome<T>;
}

impl<T, E: fmt::Display> During<T> for Result<T, E> {
    fn during(self, what: impl FnOnce() -> String) -> Outcome<T> {
        self.map_err(|error| Failure::incomplete(format!("{}: {error}", what())))
    }
}
