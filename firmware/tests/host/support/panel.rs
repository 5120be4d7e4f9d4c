//! An SSD0323 that keeps what it is shown, and refuses what its data sheet does not know.
//!
//! A recorder of bus and pin apart would not do: what counts is the pin's level
//! at the time of each byte.

use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};

/// Bytes of memory in a row, and rows.
const MEMORY: (usize, usize) = (64, 80);

#[derive(Default)]
struct Controller {
    data: bool,
    on: bool,
    waited: u32,
    columns: (usize, usize),
    rows: (usize, usize),
    at: (usize, usize),
    memory: Vec<u8>,
    commands: Vec<Vec<u8>>,
}

/// The controller with its panel; clones share it, as bus, pin and delay do.
#[derive(Clone, Default)]
pub struct FakePanel(Rc<RefCell<Controller>>);

impl FakePanel {
    /// With noise in its memory, as after power-up.
    pub fn new() -> Self {
        let panel = Self::default();
        panel.0.borrow_mut().memory = vec![0xA5; MEMORY.0 * MEMORY.1];
        panel
    }

    pub fn is_on(&self) -> bool {
        self.0.borrow().on
    }

    /// The command bytes so far, with their arguments.
    pub fn commands(&self) -> Vec<Vec<u8>> {
        self.0.borrow().commands.clone()
    }

    /// Milliseconds that the driver has waited.
    pub fn waited_ms(&self) -> u32 {
        self.0.borrow().waited / 1_000_000
    }

    /// Level of a pixel.
    pub fn level(&self, x: usize, y: usize) -> u8 {
        let pair = self.0.borrow().memory[y * MEMORY.0 + x / 2];
        if x % 2 == 0 { pair >> 4 } else { pair & 15 }
    }
}

impl Controller {
    fn take_data(&mut self, byte: u8) {
        let (column, row) = self.at;
        self.memory[row * MEMORY.0 + column] = byte;
        self.at = match (column == self.columns.1, row == self.rows.1) {
            (false, _) => (column + 1, row),
            (true, false) => (self.columns.0, row + 1),
            (true, true) => (self.columns.0, self.rows.0),
        };
    }

    fn take_command(&mut self, bytes: &[u8]) {
        self.commands.push(bytes.to_vec());
        match *bytes {
            [0x15, first, last] => {
                assert!(usize::from(last) < MEMORY.0 && first <= last);
                self.columns = (first.into(), last.into());
                self.at.0 = first.into();
            }
            [0x75, first, last] => {
                assert!(usize::from(last) < MEMORY.1 && first <= last);
                self.rows = (first.into(), last.into());
                self.at.1 = first.into();
            }
            [0xAE] => self.on = false,
            [0xAF] => self.on = true,
            [0xA4 | 0x84..=0x86] => {}
            [
                0x81 | 0xA0..=0xA2 | 0xA8 | 0xAD | 0xB1..=0xB3 | 0xBC | 0xBE | 0xBF,
                _,
            ] => {}
            [0xB8, _, _, _, _, _, _, _, _] => {}
            _ => panic!("no such command: {bytes:02x?}"),
        }
    }
}

impl spi::ErrorType for FakePanel {
    type Error = Infallible;
}

impl SpiDevice for FakePanel {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let controller = &mut *self.0.borrow_mut();
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel's bus leads one way only");
            };
            if controller.data {
                bytes.iter().for_each(|&byte| controller.take_data(byte));
            } else {
                controller.take_command(bytes);
            }
        }
        Ok(())
    }
}

impl digital::ErrorType for FakePanel {
    type Error = Infallible;
}

impl OutputPin for FakePanel {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = true;
        Ok(())
    }
}

impl DelayNs for FakePanel {
    fn delay_ns(&mut self, ns: u32) {
        self.0.borrow_mut().waited += ns;
    }
}
