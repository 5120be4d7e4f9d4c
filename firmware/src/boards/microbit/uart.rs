//! The nRF51's UART: 115200 baud, 8 bits, no parity. Its transmitter holds one byte.

use nrf51_pac::{GPIO, UART0};

/// P0.24 leads to the interface chip.
const TRANSMIT_PIN: u32 = 24;
/// P0.25 comes from it.
const RECEIVE_PIN: u32 = 25;

/// The UART.
pub struct Uart {
    registers: UART0,
    /// Whether a byte was given whose sending has not been seen to end.
    sending: bool,
}

impl Uart {
    /// Sets it up; the crystal must run.
    pub fn start(registers: UART0, pins: &GPIO) -> Self {
        // SAFETY: every bit stands for the pin of its number. High is the idle line.
        pins.outset
            .write(|pin| unsafe { pin.bits(1 << TRANSMIT_PIN) });
        // SAFETY: as above.
        pins.dirset
            .write(|pin| unsafe { pin.bits(1 << TRANSMIT_PIN) });
        // SAFETY: both are numbers of pins, which no other peripheral has.
        registers
            .pseltxd
            .write(|pin| unsafe { pin.bits(TRANSMIT_PIN) });
        // SAFETY: as above.
        registers
            .pselrxd
            .write(|pin| unsafe { pin.bits(RECEIVE_PIN) });
        registers
            .baudrate
            .write(|rate| rate.baudrate().baud115200());
        registers.enable.write(|enable| enable.enable().enabled());
        registers
            .intenset
            .write(|on| on.txdrdy().set().rxdrdy().set());
        // SAFETY: any write of 1 triggers the task.
        registers
            .tasks_starttx
            .write(|task| unsafe { task.bits(1) });
        // SAFETY: as above.
        registers
            .tasks_startrx
            .write(|task| unsafe { task.bits(1) });
        Self {
            registers,
            sending: false,
        }
    }
}

impl microbrdf_firmware::Uart for Uart {
    fn is_ready(&mut self) -> bool {
        if self.registers.events_txdrdy.read().bits() != 0 {
            self.registers.events_txdrdy.reset();
            self.sending = false;
        }
        !self.sending
    }

    fn put(&mut self, byte: u8) {
        self.sending = true;
        // SAFETY: the register takes any byte.
        self.registers
            .txd
            .write(|data| unsafe { data.txd().bits(byte) });
    }

    fn rest(&mut self) {} // `is_ready` has cleared the event that asked

    fn is_idle(&mut self) -> bool {
        self.is_ready()
    }

    fn take(&mut self) -> Option<u8> {
        if self.registers.events_rxdrdy.read().bits() == 0 {
            return None;
        }
        // Cleared first: reading may bring the next byte, and its event.
        self.registers.events_rxdrdy.reset();
        Some(self.registers.rxd.read().rxd().bits())
    }
}
