//! Netduino Plus 2: STM32F405, Cortex-M4F, 128 KiB of SRAM.
//!
//! The serial line is USART1 on PB6 and PB7, the first line of QEMU's machine of
//! this name. The chip runs from its internal oscillator, as it comes out of reset.

mod uart;

use microbrdf_firmware::NoPanel;
use stm32f4::stm32f405::{self as chip, interrupt};

pub use uart::Uart;

/// Name, as `--board` has it.
pub const NAME: &str = "netduinoplus2";
/// Processor core.
pub const CORE: &str = "cortex-m4f";
/// The serial line's interrupt.
pub const INTERRUPT: chip::Interrupt = chip::Interrupt::USART1;
/// The display.
pub type Panel = NoPanel;

/// Frequency of the processor and of USART1: the internal oscillator's, within 1 %.
const HZ: u32 = 16_000_000;

#[interrupt]
fn USART1() {
    super::line::on_interrupt();
}

/// Starts the board; call it once.
pub fn start() -> (Uart, Panel) {
    let Some(chip) = chip::Peripherals::take() else {
        panic!("the board is already started");
    };
    chip.RCC.ahb1enr().modify(|_, on| on.gpioben().enabled());
    chip.RCC.apb2enr().modify(|_, on| on.usart1en().enabled());
    (Uart::start(chip.USART1, &chip.GPIOB), NoPanel)
}
