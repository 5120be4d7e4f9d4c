//! defmt's logger: log lines gather here until the application sends them.
//!
//! They leave as log packets between the rows (`docs/wire-format.md`), so a log
//! needs no probe and no second line. What does not fit until then is dropped,
//! a whole line at a time.
#![allow(unsafe_code)]

use core::cell::RefCell;
use core::mem;

use critical_section::{Mutex, RestoreState};
use defmt::Encoder;
use heapless::Vec;
use microbrdf_firmware::LogSource;
use microbrdf_link::MAX_LOG;

use crate::boards::Board;
use crate::stack;

struct Gathered {
    bytes: Vec<u8, MAX_LOG>,
    /// Where the line under way begins.
    line: usize,
    /// Whether that line has outgrown the room.
    cut: bool,
    encoder: Encoder,
    /// What the critical section of the line under way has to restore.
    restore: RestoreState,
}

static GATHERED: Mutex<RefCell<Gathered>> = Mutex::new(RefCell::new(Gathered {
    bytes: Vec::new(),
    line: 0,
    cut: false,
    encoder: Encoder::new(),
    restore: RestoreState::invalid(),
}));

/// The application's side of the logger.
pub struct Logs;

impl LogSource for Logs {
    fn take(&mut self) -> Vec<u8, MAX_LOG> {
        critical_section::with(|cs| match GATHERED.borrow(cs).try_borrow_mut() {
            Ok(mut gathered) => mem::take(&mut gathered.bytes),
            // The device has failed in the middle of a line.
            Err(_) => Vec::new(),
        })
    }

    fn frame_ends(&mut self, number: u16) {
        defmt::info!(
            "frame {}: at most {} of {} bytes of stack were used",
            number,
            stack::used(),
            stack::size(),
        );
    }
}

/// The board is up.
pub fn started(board: &Board) {
    defmt::info!("{=str} with a {=str}", board.name, board.core);
}

#[defmt::global_logger]
struct Logger;

// SAFETY: between `acquire` and `release` a critical section keeps every other
// context out, as the trait asks for; both only pass it on.
unsafe impl defmt::Logger for Logger {
    fn acquire() {
        // SAFETY: `release` ends the section, with the state that is kept for it.
        let restore = unsafe { critical_section::acquire() };
        critical_section::with(|cs| {
            let mut gathered = GATHERED.borrow_ref_mut(cs);
            gathered.restore = restore;
            gathered.line = gathered.bytes.len();
            gathered.cut = false;
            gathered.encode(|encoder, put| encoder.start_frame(put));
        });
    }

    unsafe fn flush() {}

    unsafe fn release() {
        let restore = critical_section::with(|cs| {
            let mut gathered = GATHERED.borrow_ref_mut(cs);
            gathered.encode(|encoder, put| encoder.end_frame(put));
            if gathered.cut {
                let line = gathered.line;
                gathered.bytes.truncate(line);
            }
            gathered.restore
        });
        // SAFETY: ends the section that `acquire` began, in the same context.
        unsafe { critical_section::release(restore) };
    }

    unsafe fn write(bytes: &[u8]) {
        critical_section::with(|cs| {
            GATHERED
                .borrow_ref_mut(cs)
                .encode(|encoder, put| encoder.write(bytes, put));
        });
    }
}

impl Gathered {
    /// Has the encoder write to the bytes that have gathered.
    fn encode(&mut self, step: impl FnOnce(&mut Encoder, &mut dyn FnMut(&[u8]))) {
        let Self {
            bytes,
            cut,
            encoder,
            ..
        } = self;
        step(encoder, &mut |part| {
            *cut |= bytes.extend_from_slice(part).is_err()
        });
    }
}
