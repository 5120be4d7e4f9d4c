//! BBC micro:bit, version 1: nRF51822, Cortex-M0, 16 KiB of RAM.
//!
//! The serial line is the UART on P0.24 and P0.25, which the board's interface
//! chip brings to its USB plug. The light matrix is not used.
#![allow(unsafe_code)]

mod uart;

use microbrdf_firmware::NoPanel;
use nrf51_pac::{CLOCK, Peripherals, interrupt};

pub use uart::Uart;

/// Name, as `--board` has it.
pub const NAME: &str = "microbit";
/// Processor core.
pub const CORE: &str = "cortex-m0";
/// The serial line's interrupt.
pub const INTERRUPT: nrf51_pac::Interrupt = nrf51_pac::Interrupt::UART0;
/// The display.
pub type Panel = NoPanel;

#[interrupt]
fn UART0() {
    super::line::on_interrupt();
}

/// Starts the board; call it once.
pub fn start() -> (Uart, Panel) {
    let Some(chip) = Peripherals::take() else {
        panic!("the board is already started");
    };
    start_crystal(&chip.CLOCK);
    (Uart::start(chip.UART0, &chip.GPIO), NoPanel)
}

/// Changes over from the internal oscillator, too coarse for a UART, to the crystal of 16 MHz.
fn start_crystal(clock: &CLOCK) {
    // SAFETY: any write of 1 triggers the task.
    clock.tasks_hfclkstart.write(|task| unsafe { task.bits(1) });
    while clock.events_hfclkstarted.read().bits() == 0 {}
}
