//! UART0: 115200 baud, 8 bits, no parity, FIFOs of 16 bytes.

use tock_registers::interfaces::{Readable, Writeable};

use super::clock;
use super::registers::{UartControl, UartFlags, UartInterrupts, UartLine, uart0};

const BAUD: u32 = 115_200;

/// Clock cycles per 1/16 bit, in 64ths, rounded: 4 + 22/64 at 8 MHz, 0.1 % fast.
const DIVISOR: u32 = (clock::HZ * 4 + BAUD / 2) / BAUD;

/// UART0; its pins and clock must be on.
pub struct Uart(());

impl Uart {
    /// Sets it up.
    pub fn start() -> Self {
        let uart = uart0();
        uart.control.set(0);
        uart.divisor.set(DIVISOR / 64);
        uart.divisor_64ths.set(DIVISOR % 64);
        uart.line
            .write(UartLine::WORD::Bits8 + UartLine::FIFOS::SET);
        uart.interrupt_mask.write(
            UartInterrupts::TRANSMIT::SET
                + UartInterrupts::RECEIVE::SET
                + UartInterrupts::RECEIVE_TIMEOUT::SET,
        );
        uart.control.write(
            UartControl::ENABLE::SET + UartControl::TRANSMIT::SET + UartControl::RECEIVE::SET,
        );
        Self(())
    }
}

impl microbrdf_firmware::Uart for Uart {
    fn is_ready(&mut self) -> bool {
        !uart0().flags.is_set(UartFlags::TRANSMITTER_FULL)
    }

    fn put(&mut self, byte: u8) {
        // The interrupt comes when the FIFO has emptied to its half.
        uart0().data.set(byte.into());
    }

    fn rest(&mut self) {
        uart0().interrupt_clear.write(UartInterrupts::TRANSMIT::SET);
    }

    fn is_idle(&mut self) -> bool {
        !uart0().flags.is_set(UartFlags::BUSY)
    }

    fn take(&mut self) -> Option<u8> {
        let uart = uart0();
        if uart.flags.is_set(UartFlags::RECEIVER_EMPTY) {
            uart.interrupt_clear
                .write(UartInterrupts::RECEIVE::SET + UartInterrupts::RECEIVE_TIMEOUT::SET);
            return None;
        }
        Some(uart.data.get() as u8)
    }
}
