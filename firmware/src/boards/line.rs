//! The serial line: a queue between the application and the UART's interrupt.

use core::cell::RefCell;
use core::sync::atomic::{AtomicBool, Ordering};

use cortex_m::peripheral::NVIC;
use cortex_m::singleton;
use critical_section::Mutex;
use heapless::spsc::{Consumer, Queue};
use microbrdf_firmware::{Drain, QueuedSerial, Uart as _, drain};

use super::chosen::{INTERRUPT, Uart};
use crate::baked::ROW_WIRE_BYTES;

/// Room for a row on its way out; a queue keeps one place free.
type RowQueue = Queue<u8, { ROW_WIRE_BYTES + 1 }>;

/// What the interrupt handler works with.
struct Line {
    uart: Uart,
    queue: Consumer<'static, u8>,
}

static LINE: Mutex<RefCell<Option<Line>>> = Mutex::new(RefCell::new(None));

/// Whether a byte has come in since the last frame was begun.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// The line, as the application writes to it.
pub type Serial = QueuedSerial<'static, UartInterrupt>;

/// Lets the interrupt run on the UART, which must be set up. Only the first call succeeds.
pub fn open(uart: Uart) -> Serial {
    let Some(queue) = singleton!(: RowQueue = Queue::new()) else {
        panic!("the serial line is already open");
    };
    let (producer, consumer) = queue.split();
    critical_section::with(|cs| {
        LINE.replace(
            cs,
            Some(Line {
                uart,
                queue: consumer,
            }),
        )
    });
    unmask();
    QueuedSerial::new(producer, UartInterrupt)
}

#[allow(unsafe_code)]
fn unmask() {
    // SAFETY: no critical section relies on this interrupt being masked: what
    // its handler touches is behind `LINE` and an atomic.
    unsafe { NVIC::unmask(INTERRUPT) };
}

/// The whole interrupt handler of every board's UART.
pub fn on_interrupt() {
    critical_section::with(|cs| {
        if let Some(Line { uart, queue }) = LINE.borrow_ref_mut(cs).as_mut() {
            while uart.take().is_some() {
                REQUESTED.store(true, Ordering::Relaxed);
            }
            drain(uart, queue);
        }
    });
}

/// The interrupt that empties the queue.
pub struct UartInterrupt;

impl Drain for UartInterrupt {
    fn wake(&mut self) {
        NVIC::pend(INTERRUPT);
    }

    fn is_idle(&mut self) -> bool {
        critical_section::with(|cs| {
            LINE.borrow_ref_mut(cs)
                .as_mut()
                .is_none_or(|line| line.uart.is_idle())
        })
    }
}

/// Sleeps until a byte has come in; several that came during a frame count as one.
pub fn wait_for_request() {
    while !REQUESTED.load(Ordering::Relaxed) {
        // With interrupts off, one that comes between the question and the
        // sleep still ends the sleep, and runs right after.
        critical_section::with(|_| {
            if !REQUESTED.load(Ordering::Relaxed) {
                cortex_m::asm::wfi();
            }
        });
    }
    REQUESTED.store(false, Ordering::Relaxed);
}

/// Hands UART and queue to a failing device's report, unless the interrupt
/// handler was at work on them when it failed.
pub fn with_line(report: impl FnOnce(&mut Uart, &mut Consumer<'static, u8>)) {
    critical_section::with(|cs| {
        if let Ok(mut line) = LINE.borrow(cs).try_borrow_mut() {
            if let Some(Line { uart, queue }) = line.as_mut() {
                report(uart, queue);
            }
        }
    });
}
