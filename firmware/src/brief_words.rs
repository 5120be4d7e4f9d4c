//! As `last_words.rs`, without text: that there was a panic or a hard fault,
//! and in which frame, is all that is reported.

use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU16, Ordering};

use cortex_m_rt::{ExceptionFrame, exception};
use microbrdf_firmware::report_code;
use microbrdf_link::FaultCode;

use crate::boards;
use crate::logger::Logs;

/// Number of the frame under way.
static FRAME: AtomicU16 = AtomicU16::new(0);

/// Notes the number that a report has to name from now on.
pub fn frame_begins(number: u16) {
    FRAME.store(number, Ordering::Relaxed);
}

/// Sends the report and halts. If the line was never opened, or the failure
/// struck inside its interrupt handler, it just halts.
#[inline(never)]
fn end(code: FaultCode) -> ! {
    cortex_m::interrupt::disable();
    let frame = FRAME.load(Ordering::Relaxed);
    boards::with_line(|uart, queue| report_code(uart, queue, &mut Logs, frame, code));
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn on_panic(_: &PanicInfo<'_>) -> ! {
    end(FaultCode::Panic)
}

// SAFETY: the attribute's handler runs with the processor in an unknown state;
// this one takes over the serial line with interrupts off, and never returns.
#[exception]
#[allow(unsafe_code)]
unsafe fn HardFault(_: &ExceptionFrame) -> ! {
    end(FaultCode::HardFault)
}
