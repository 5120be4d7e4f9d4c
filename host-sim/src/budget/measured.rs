//! What was measured of boards: the file that `cargo xtask forecast` makes.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::fit::Costs;
use crate::exit::{Failure, Outcome};

/// Everything.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// What compiled the scenes.
    pub compiler: String,
    /// The boards.
    pub boards: Vec<Board>,
}

/// A board.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Board {
    /// Its name.
    pub name: String,
    /// Its core.
    pub core: String,
    /// Bytes of flash.
    pub flash: u64,
    /// Bytes of RAM.
    pub ram: u64,
    /// Cycles a second.
    pub hz: u64,
    /// Bits a second on its line; ten make a byte.
    pub baud: u64,
    /// Cycles for each byte that is put into packets.
    pub packing: f64,
    /// What was measured in each arithmetic.
    pub arithmetics: BTreeMap<String, InArithmetic>,
}

/// A board's costs in an arithmetic.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct InArithmetic {
    /// Bytes of code that each piece takes, that of the application included.
    pub code: Costs,
    /// Bytes of RAM beside a row of pixels and its packets.
    pub ram: u64,
    /// Bytes of stack.
    pub stack: Costs,
    /// Cycles of each step.
    pub steps: Costs,
}

impl Measured {
    /// The project's own.
    ///
    /// # Errors
    /// A file that can't be read, or is of another form.
    pub fn read() -> Outcome<Self> {
        let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "data", "forecast.json"]
            .iter()
            .collect();
        let wrong = |error: &dyn std::fmt::Display| {
            Failure::Environment(format!(
                "{}: {error}; `cargo xtask forecast` makes it",
                path.display()
            ))
        };
        let text = std::fs::read_to_string(&path).map_err(|error| wrong(&error))?;
        serde_json::from_str(&text).map_err(|error| wrong(&error))
    }

    /// The board of a name.
    ///
    /// # Errors
    /// A name that none has.
    pub fn board(&self, name: &str) -> Outcome<&Board> {
        let found = self.boards.iter().find(|board| board.name == name);
        found.ok_or_else(|| {
            let names: Vec<_> = self.boards.iter().map(|b| b.name.as_str()).collect();
            Failure::Usage(format!(
                "--board {name}: must be one of {}",
                names.join(", ")
            ))
        })
    }
}

impl Board {
    /// Its costs in an arithmetic.
    ///
    /// # Errors
    /// One that was not measured.
    pub fn costs(&self, arithmetic: &str) -> Outcome<&InArithmetic> {
        self.arithmetics.get(arithmetic).ok_or_else(|| {
            let names: Vec<_> = self.arithmetics.keys().map(String::as_str).collect();
            Failure::Usage(format!(
                "--arithmetic {arithmetic}: was not measured on {}; known are {}",
                self.name,
                names.join(", ")
            ))
        })
    }
}
