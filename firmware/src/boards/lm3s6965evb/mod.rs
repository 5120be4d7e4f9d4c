//! Luminary (TI) LM3S6965 evaluation board: Cortex-M3, 64 KiB of SRAM, and a
//! grey OLED panel of 128 x 64.
//!
//! UART0 (PA0, PA1) is the serial line. The panel's SSD0323 is on SSI0 (PA2, PA3,
//! PA5), with PC7 telling commands from pixels. It shares the bus with a card
//! slot, whose chip select is PD0: it is held high, which keeps the card out of
//! the way (and is what selects the panel in QEMU's machine of this name).

mod clock;
mod gpio;
mod registers;
mod ssi;
mod uart;

use embedded_hal::digital::OutputPin;
use lm3s6965::interrupt;
use microbrdf_firmware::{Greys, Ssd0323};

pub use uart::Uart;

use crate::baked::DITHER;
use gpio::{Output, Port};
use ssi::Ssi;

/// Name, as `--board` has it.
pub const NAME: &str = "lm3s6965evb";
/// Processor core.
pub const CORE: &str = "cortex-m3";
/// The serial line's interrupt.
pub const INTERRUPT: lm3s6965::Interrupt = lm3s6965::Interrupt::UART0;
/// The display.
pub type Panel = Greys<Ssi, Output>;

#[interrupt]
fn UART0() {
    super::line::on_interrupt();
}

/// Starts the board; call it once.
pub fn start() -> (Uart, Panel) {
    let Some(core) = cortex_m::Peripherals::take() else {
        panic!("the board is already started");
    };
    let mut delay = clock::start(core.SYST);

    gpio::hand_to_peripheral(Port::A, gpio::UART0_PINS | gpio::SSI0_PINS);
    let Ok(()) = Output::new(Port::D, gpio::CARD_SELECT).set_high();
    let data_or_command = Output::new(Port::C, gpio::DATA_OR_COMMAND);

    let Ok(display) = Ssd0323::start(Ssi::start(), data_or_command, &mut delay);
    (Uart::start(), Greys::new(display, DITHER))
}
