//! The board that the firmware is built for, and what all boards have in common.
//!
//! A board is a folder that offers `NAME`, `CORE`, `INTERRUPT`, `Uart`, `Panel`
//! and `start`; `docs/adding-a-board.md` tells how to write one.

use crate::logger::Logs;

mod line;

#[cfg(feature = "board-lm3s6965evb")]
mod lm3s6965evb;
#[cfg(feature = "board-lm3s6965evb")]
use lm3s6965evb as chosen;

#[cfg(feature = "board-microbit")]
mod microbit;
#[cfg(feature = "board-microbit")]
use microbit as chosen;

#[cfg(feature = "board-netduinoplus2")]
mod netduinoplus2;
#[cfg(feature = "board-netduinoplus2")]
use netduinoplus2 as chosen;

pub use line::{wait_for_request, with_line};

/// The board, as the application knows it.
pub type Board = microbrdf_firmware::Board<line::Serial, chosen::Panel, Logs>;

/// Starts clocks, pins, serial line and display. Only the first call succeeds; others panic.
pub fn start() -> Board {
    let (uart, panel) = chosen::start();
    Board {
        name: chosen::NAME,
        core: chosen::CORE,
        compiler: env!("MICROBRDF_COMPILER"),
        serial: line::open(uart),
        panel,
        log: Logs,
    }
}
