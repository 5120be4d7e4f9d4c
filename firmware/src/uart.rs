//! A UART as the interrupt handler sees it, and what the handler does with it.

use core::convert::Infallible;

use embedded_io::{ErrorType, Write};

use crate::serial::Dequeue;

/// A UART's registers: no queue, no waiting.
pub trait Uart {
    /// Whether the transmitter can take a byte now.
    fn is_ready(&mut self) -> bool;

    /// Gives the transmitter a byte, and has it ask for an interrupt when it can
    /// take another. Only called when it is ready.
    fn put(&mut self, byte: u8);

    /// Nothing is left to send: the transmitter must not ask any more.
    fn rest(&mut self);

    /// Whether the last byte has gone out to the line.
    fn is_idle(&mut self) -> bool;

    /// A byte that came in, if one did.
    fn take(&mut self) -> Option<u8>;
}

/// Moves bytes from the queue to the UART, as many as it takes.
///
/// This is the whole transmit interrupt. It may also be called, by setting the
/// interrupt pending, when there is nothing to do.
pub fn drain(uart: &mut impl Uart, queue: &mut impl Dequeue) {
    while uart.is_ready() {
        match queue.dequeue() {
            Some(byte) => uart.put(byte),
            None => return uart.rest(),
        }
    }
}

/// A UART written to directly, waiting for each byte: for when interrupts no longer run.
pub struct Polled<'u, U>(pub &'u mut U);

impl<U> ErrorType for Polled<'_, U> {
    type Error = Infallible;
}

impl<U: Uart> Write for Polled<'_, U> {
    // Once for all that a failing device sends.
    #[inline(never)]
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        for &byte in bytes {
            while !self.0.is_ready() {}
            self.0.put(byte);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while !self.0.is_idle() {}
        Ok(())
    }
}
