//! The boards that firmware is built for, each with the emulated machine that stands in for it.

use crate::failure::{Failure, Outcome};

/// One board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Board {
    /// Name for `--board`; also QEMU's name of the machine.
    pub name: &'static str,
    /// Core, as `report.json` names it.
    pub core: &'static str,
    /// Compiler target made for that core.
    pub target: &'static str,
    /// Whether it has a display of its own, which the emulator can photograph.
    pub panel: bool,
}

/// Every board, the default one first.
pub const BOARDS: [Board; 3] = [
    Board {
        name: "lm3s6965evb",
        core: "cortex-m3",
        target: "thumbv7m-none-eabi",
        panel: true,
    },
    Board {
        name: "microbit",
        core: "cortex-m0",
        target: "thumbv6m-none-eabi",
        panel: false,
    },
    Board {
        name: "netduinoplus2",
        core: "cortex-m4f",
        target: "thumbv7em-none-eabihf",
        panel: false,
    },
];

/// Arithmetics that firmware can be built with.
pub const ARITHMETICS: [&str; 4] = ["f32", "micromath", "q31", "q15"];

impl Board {
    /// The board of that name.
    pub fn named(name: &str) -> Outcome<Self> {
        BOARDS
            .into_iter()
            .find(|board| board.name == name)
            .ok_or_else(|| {
                let names = BOARDS.map(|board| board.name).join(", ");
                Failure::mistake(format!("--board {name}: no such board; known are {names}"))
            })
    }

    /// The firmware's cargo feature for this board.
    pub fn feature(&self) -> String {
        format!("board-{}", self.name)
    }

    /// Compiler targets of all boards, each once.
    pub fn targets() -> Vec<&'static str> {
        let mut targets = Vec::new();
        for board in BOARDS {
            if !targets.contains(&board.target) {
                targets.push(board.target);
            }
        }
        targets
    }
}
