//! A serial line on which every byte takes its time, with a clock that only
//! moves when a test says so: nothing here depends on the machine's speed.

use std::cell::RefCell;

use heapless::spsc::Consumer;
use microbrdf_firmware::{Drain, Uart, drain};

/// A UART that takes a byte every so many ticks.
pub struct SlowUart {
    ticks_per_byte: u64,
    now: u64,
    free_at: u64,
    sent: Vec<u8>,
}

impl SlowUart {
    pub fn new(ticks_per_byte: u64) -> Self {
        Self {
            ticks_per_byte,
            now: 0,
            free_at: 0,
            sent: Vec::new(),
        }
    }

    /// All bytes that it was given.
    pub fn sent(&self) -> &[u8] {
        &self.sent
    }
}

impl Uart for SlowUart {
    /// Asking takes a tick: so whoever asks until it is ready gets there.
    fn is_ready(&mut self) -> bool {
        self.now += 1;
        self.now >= self.free_at
    }

    fn put(&mut self, byte: u8) {
        assert!(self.now >= self.free_at, "the UART was not ready");
        self.free_at = self.now + self.ticks_per_byte;
        self.sent.push(byte);
    }

    fn rest(&mut self) {}

    fn is_idle(&mut self) -> bool {
        self.is_ready()
    }

    fn take(&mut self) -> Option<u8> {
        None
    }
}

/// The UART with its interrupt, which runs at every tick.
pub struct SlowLine<'q>(RefCell<(SlowUart, Consumer<'q, u8>)>);

impl<'q> SlowLine<'q> {
    pub fn new(ticks_per_byte: u64, queue: Consumer<'q, u8>) -> Self {
        Self(RefCell::new((SlowUart::new(ticks_per_byte), queue)))
    }

    /// Lets time pass, as computing does.
    pub fn pass(&self, ticks: u64) {
        let (uart, queue) = &mut *self.0.borrow_mut();
        let end = uart.now + ticks;
        while uart.now < end {
            drain(uart, queue);
        }
    }

    pub fn now(&self) -> u64 {
        self.0.borrow().0.now
    }

    pub fn bytes_sent(&self) -> usize {
        self.0.borrow().0.sent.len()
    }

    pub fn into_sent(self) -> Vec<u8> {
        self.0.into_inner().0.sent
    }
}

/// Waking the interrupt, and waiting for it, takes a tick.
impl Drain for &SlowLine<'_> {
    fn wake(&mut self) {
        self.pass(1);
    }

    fn is_idle(&mut self) -> bool {
        self.0.borrow_mut().0.is_idle()
    }
}
