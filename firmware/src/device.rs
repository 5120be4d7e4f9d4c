//! The device's life: a frame at once, and one more whenever a byte comes in.

use cortex_m::singleton;
use heapless::Vec;
#[cfg(feature = "defmt")]
use microbrdf_firmware::LogSource;
use microbrdf_firmware::{Board, send_frame};
#[cfg(feature = "defmt")]
use microbrdf_link::send_log;

use crate::baked::{Baked, PIXEL_FORMAT, ROW_BYTES};
use crate::logger::Logs;
use crate::{boards, last_words};

#[cortex_m_rt::entry]
fn main() -> ! {
    let (serial, panel) = boards::start();
    let mut board = Board {
        name: boards::NAME,
        core: boards::CORE,
        compiler: env!("MICROBRDF_COMPILER"),
        serial,
        panel,
        log: Logs,
    };
    #[cfg(feature = "defmt")]
    defmt::info!("{=str} with a {=str}", board.name, board.core);
    let Some(row) = singleton!(: Vec<u8, ROW_BYTES> = Vec::new()) else {
        unreachable!("main runs once");
    };
    let mut number: u16 = 0;
    loop {
        last_words::frame_begins(number);
        if let Err(error) = send_frame(&Baked, &mut board, PIXEL_FORMAT, row, number) {
            panic!("frame {number}: {error:?}");
        }
        #[cfg(feature = "defmt")]
        log_frame(&mut board.serial, number);
        boards::wait_for_request();
        number = number.wrapping_add(1);
    }
}

/// Logs what the frame took, and sends that at once: no row follows that it could leave with.
#[cfg(feature = "defmt")]
fn log_frame(serial: &mut boards::Serial, number: u16) {
    defmt::info!(
        "frame {} sent; stack: at most {} of {} bytes used",
        number,
        crate::stack::used(),
        crate::stack::size(),
    );
    let Ok(()) = send_log(serial, &Logs.take());
}
