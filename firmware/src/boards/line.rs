//! The serial line: a queue between the application and the UART's interrupt.

use core::cell::RefCell;
use core::sync::atomic::{AtomicBool, Ordering};

use cortex_m::peripheral::NVIC;
use critical_section::{CriticalSection, Mutex};
use heapless::spsc::Queue;
use microbrdf_firmware::{Drain, Enqueue, QueuedSerial, Uart as _, drain};

use super::chosen::{INTERRUPT, Uart};
use crate::baked::ROW_WIRE_BYTES;

/// Room for a row on its way out; a queue keeps one place free, and a power of
/// two spares each byte that comes and goes a division.
type RowQueue = Queue<u8, { (ROW_WIRE_BYTES + 1).next_power_of_two() }>;

/// Bytes that are queued with interrupts off: less time than one takes to leave.
const AT_ONCE: usize = 16;

static QUEUE: Mutex<RefCell<RowQueue>> = Mutex::new(RefCell::new(Queue::new()));

static LINE: Mutex<RefCell<Option<Uart>>> = Mutex::new(RefCell::new(None));

/// Whether a byte has come in since the last frame was begun.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// The line, as the application writes to it.
pub type Serial = QueuedSerial<Shared, UartInterrupt>;

/// Lets the interrupt run on the UART, which must be set up.
pub fn open(uart: Uart) -> Serial {
    critical_section::with(|cs| LINE.replace(cs, Some(uart)));
    unmask();
    QueuedSerial::new(Shared, UartInterrupt)
}

/// The queue's writing end, of which [`open`] makes the only one.
pub struct Shared;

impl Enqueue for Shared {
    fn enqueue(&mut self, bytes: &[u8]) -> usize {
        let part = bytes.get(..AT_ONCE).unwrap_or(bytes);
        critical_section::with(|cs| {
            let mut queue = QUEUE.borrow_ref_mut(cs);
            let fits = |byte: &&u8| queue.enqueue(**byte).is_ok();
            part.iter().take_while(fits).count()
        })
    }

    fn is_empty(&self) -> bool {
        critical_section::with(|cs| QUEUE.borrow_ref(cs).is_empty())
    }
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
        if let Some(uart) = LINE.borrow_ref_mut(cs).as_mut() {
            while uart.take().is_some() {
                REQUESTED.store(true, Ordering::Relaxed);
            }
            drain(uart, &mut *QUEUE.borrow_ref_mut(cs));
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
                .is_none_or(|uart| uart.is_idle())
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
/// handler was at work on them when it failed, or a write on the queue.
pub fn with_line(report: impl FnOnce(&mut Uart, &mut RowQueue)) {
    critical_section::with(|cs: CriticalSection<'_>| {
        let (line, queue) = (
            LINE.borrow(cs).try_borrow_mut(),
            QUEUE.borrow(cs).try_borrow_mut(),
        );
        if let (Ok(mut line), Ok(mut queue)) = (line, queue) {
            if let Some(uart) = line.as_mut() {
                report(uart, &mut queue);
            }
        }
    });
}
