//! SSI0 as an SPI bus of one device, whose chip select the block drives itself.

use core::convert::Infallible;

use embedded_hal::spi::{ErrorType, Operation, SpiDevice};
use tock_registers::interfaces::{ReadWriteable, Readable, Writeable};

use super::clock;
use super::registers::{SsiControl0, SsiControl1, SsiStatus, ssi0};

/// The clock is divided by this: 4 MHz, the fastest that the panel takes.
const PRESCALER: u32 = 2;

/// What is sent when only the answer counts.
const FILLER: u8 = 0;

/// SSI0; its pins and clock must be on.
pub struct Ssi(());

impl Ssi {
    /// Sets it up: SPI mode 3, words of 8 bits.
    pub fn start() -> Self {
        let ssi = ssi0();
        ssi.control_1.modify(SsiControl1::ENABLE::CLEAR);
        ssi.prescaler.set(PRESCALER);
        ssi.control_0.write(
            SsiControl0::WORD::Bits8
                + SsiControl0::FORMAT::Freescale
                + SsiControl0::IDLE_HIGH::SET
                + SsiControl0::SECOND_EDGE::SET,
        );
        ssi.control_1.modify(SsiControl1::ENABLE::SET);
        Self(())
    }

    /// Sends a byte and waits for the one that comes back: then it is through.
    fn exchange(&mut self, byte: u8) -> u8 {
        let ssi = ssi0();
        while !ssi.status.is_set(SsiStatus::TRANSMITTER_NOT_FULL) {}
        ssi.data.set(byte.into());
        while !ssi.status.is_set(SsiStatus::RECEIVER_NOT_EMPTY) {}
        ssi.data.get() as u8
    }
}

impl ErrorType for Ssi {
    type Error = Infallible;
}

impl SpiDevice for Ssi {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            match operation {
                Operation::Read(answer) => {
                    answer
                        .iter_mut()
                        .for_each(|byte| *byte = self.exchange(FILLER));
                }
                Operation::Write(bytes) => bytes.iter().for_each(|&byte| {
                    self.exchange(byte);
                }),
                Operation::Transfer(answer, bytes) => {
                    for index in 0..answer.len().max(bytes.len()) {
                        let back = self.exchange(bytes.get(index).copied().unwrap_or(FILLER));
                        if let Some(byte) = answer.get_mut(index) {
                            *byte = back;
                        }
                    }
                }
                Operation::TransferInPlace(bytes) => {
                    bytes
                        .iter_mut()
                        .for_each(|byte| *byte = self.exchange(*byte));
                }
                Operation::DelayNs(ns) => {
                    // At 8 MHz a cycle is 125 ns.
                    cortex_m::asm::delay(ns.div_ceil(1_000_000_000 / clock::HZ));
                }
            }
        }
        Ok(())
    }
}
