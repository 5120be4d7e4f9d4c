//! Pins.

use core::convert::Infallible;

use embedded_hal::digital::{ErrorType, OutputPin};
use tock_registers::interfaces::{Readable, Writeable};
use tock_registers::registers::ReadWrite;

use super::registers::{Gpio, port_a, port_c, port_d};

/// PA0 and PA1: receive and transmit.
pub const UART0_PINS: u8 = 1 << 0 | 1 << 1;
/// PA2, PA3 and PA5: clock, frame (the panel's chip select) and transmit.
pub const SSI0_PINS: u8 = 1 << 2 | 1 << 3 | 1 << 5;
/// PC7: the panel's commands (low) or pixels (high).
pub const DATA_OR_COMMAND: u8 = 1 << 7;
/// PD0: chip select of the card slot on the panel's bus, active low.
pub const CARD_SELECT: u8 = 1 << 0;

/// A port in use.
#[derive(Clone, Copy)]
pub enum Port {
    /// PA0 to PA7.
    A,
    /// PC0 to PC7.
    C,
    /// PD0 to PD7.
    D,
}

impl Port {
    fn registers(self) -> &'static Gpio {
        match self {
            Self::A => port_a(),
            Self::C => port_c(),
            Self::D => port_d(),
        }
    }
}

/// Gives pins to the peripheral that they belong to.
pub fn hand_to_peripheral(port: Port, pins: u8) {
    let port = port.registers();
    set(&port.alternate_function, pins);
    set(&port.digital_enable, pins);
}

/// A pin that is driven.
pub struct Output {
    port: Port,
    pin: u8,
}

impl Output {
    /// Drives the pin whose bit is set in `pin`.
    pub fn new(port: Port, pin: u8) -> Self {
        let registers = port.registers();
        set(&registers.direction, pin);
        set(&registers.digital_enable, pin);
        Self { port, pin }
    }

    fn drive(&mut self, level: u8) {
        self.port.registers().data[usize::from(self.pin)].set(level.into());
    }
}

impl ErrorType for Output {
    type Error = Infallible;
}

impl OutputPin for Output {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.drive(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.drive(u8::MAX);
        Ok(())
    }
}

fn set(register: &ReadWrite<u32>, bits: u8) {
    register.set(register.get() | u32::from(bits));
}
