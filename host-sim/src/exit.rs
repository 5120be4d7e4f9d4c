//! Exit statuses and what leads to them.

use std::fmt;

/// Why a command did not do what it was asked to.
#[derive(Debug)]
pub enum Failure {
    /// It ran, but the result is incomplete or differs: status 1.
    Incomplete(String),
    /// A mistake of the user's: status 2.
    Usage(String),
    /// The environment lacks something: status 3.
    Environment(String),
}

impl Failure {
    /// The exit status that tells it.
    pub fn status(&self) -> u8 {
        match self {
            Self::Incomplete(_) => 1,
            Self::Usage(_) => 2,
            Self::Environment(_) => 3,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Incomplete(message) | Self::Usage(message) | Self::Environment(message)) = self;
        formatter.write_str(message)
    }
}

impl From<microbrdf_scene::SceneError> for Failure {
    fn from(error: microbrdf_scene::SceneError) -> Self {
        Self::Usage(error.to_string())
    }
}

/// What every command returns.
pub type Outcome<T> = Result<T, Failure>;
