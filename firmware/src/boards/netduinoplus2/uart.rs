//! USART1: 115200 baud, 8 bits, no parity. Its transmitter holds one byte, and one in its shifter.

use stm32f4::stm32f405::{GPIOB, USART1};

use super::HZ;

const BAUD: u32 = 115_200;

/// Clock cycles per bit, rounded: 139, 0.1 % slow.
const DIVISOR: u32 = (HZ + BAUD / 2) / BAUD;

/// USART1.
pub struct Uart {
    registers: USART1,
}

impl Uart {
    /// Sets it up; its clock and its port's must be on.
    pub fn start(registers: USART1, port: &GPIOB) -> Self {
        // PB6 transmits, PB7 receives: alternate function 7 is the USART.
        port.afrl()
            .modify(|_, pins| pins.afrl6().af7().afrl7().af7());
        port.moder()
            .modify(|_, pins| pins.moder6().alternate().moder7().alternate());
        registers.brr().write(|baud| {
            baud.div_mantissa()
                .set((DIVISOR / 16) as u16)
                .div_fraction()
                .set((DIVISOR % 16) as u8)
        });
        registers.cr1().write(|on| {
            on.ue()
                .enabled()
                .te()
                .enabled()
                .re()
                .enabled()
                .rxneie()
                .enabled()
        });
        Self { registers }
    }

    /// Whether the transmitter asks for an interrupt when it is empty.
    fn ask(&mut self, on: bool) {
        self.registers
            .cr1()
            .modify(|_, control| control.txeie().bit(on));
    }
}

impl microbrdf_firmware::Uart for Uart {
    fn is_ready(&mut self) -> bool {
        self.registers.sr().read().txe().bit_is_set()
    }

    fn put(&mut self, byte: u8) {
        self.registers.dr().write(|data| data.dr().set(byte.into()));
        self.ask(true);
    }

    fn rest(&mut self) {
        self.ask(false);
    }

    fn is_idle(&mut self) -> bool {
        self.registers.sr().read().tc().bit_is_set()
    }

    fn take(&mut self) -> Option<u8> {
        let full = self.registers.sr().read().rxne().bit_is_set();
        full.then(|| self.registers.dr().read().dr().bits() as u8)
    }
}
