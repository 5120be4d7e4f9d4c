//! The last thing that a failing device does.

use core::fmt;

use embedded_io::Write;
use microbrdf_link::{FaultCode, send_fault, send_fault_text, send_log};

use crate::log::LogSource;
use crate::serial::Dequeue;
use crate::uart::{Polled, Uart};

/// Sends what is still queued, the log, and then the report of a failure, all
/// without interrupts.
///
/// `frame` is the number of the frame that ends here. The queue may end in half
/// a packet, if the failure struck while one was being queued: what comes after
/// starts with a delimiter of its own, so the receiver drops only that one.
pub fn report(
    uart: &mut impl Uart,
    queue: &mut impl Dequeue,
    log: &mut impl LogSource,
    frame: u16,
    code: FaultCode,
    text: fmt::Arguments<'_>,
) {
    let mut line = finish(uart, queue, log);
    let Ok(()) = send_fault(&mut line, frame, code, text);
}

/// As [`report`], without a text: a board that has no room for the code that
/// formats one.
pub fn report_code(
    uart: &mut impl Uart,
    queue: &mut impl Dequeue,
    log: &mut impl LogSource,
    frame: u16,
    code: FaultCode,
) {
    let mut line = finish(uart, queue, log);
    let Ok(()) = send_fault_text(&mut line, frame, code, "");
}

/// Sends what is still queued, and the log.
fn finish<'u, U: Uart, L: LogSource>(
    uart: &'u mut U,
    queue: &mut impl Dequeue,
    log: &mut L,
) -> Polled<'u, U> {
    let mut line = Polled(uart);
    while let Some(byte) = queue.dequeue() {
        let Ok(()) = line.write_all(&[byte]);
    }
    if L::KEEPS {
        let Ok(()) = send_log(&mut line, &log.take());
    }
    line
}
