//! A panic and a hard fault: both are reported over the serial line, and end the frame.

use core::fmt;
use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU16, Ordering};

use cortex_m_rt::{ExceptionFrame, exception};
use microbrdf_firmware::report;
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
fn end(code: FaultCode, text: fmt::Arguments<'_>) -> ! {
    cortex_m::interrupt::disable();
    let frame = FRAME.load(Ordering::Relaxed);
    boards::with_line(|uart, queue| report(uart, queue, &mut Logs, frame, code, text));
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn on_panic(info: &PanicInfo<'_>) -> ! {
    end(FaultCode::Panic, format_args!("{info}"))
}

// SAFETY: the attribute's handler runs with the processor in an unknown state;
// this one reads the stacked registers, takes over the serial line with
// interrupts off, and never returns.
#[exception]
#[allow(unsafe_code)]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    end(
        FaultCode::HardFault,
        format_args!(
            "hard fault at pc {:#010x}, called from lr {:#010x}, xpsr {:#010x}",
            frame.pc(),
            frame.lr(),
            frame.xpsr(),
        ),
    )
}
