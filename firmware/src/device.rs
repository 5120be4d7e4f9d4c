//! The device's life: a frame at once, and one more whenever a byte comes in.

use cortex_m::singleton;
use heapless::Vec;
use microbrdf_firmware::{Board, send_frame};

use crate::baked::{Baked, PIXEL_FORMAT, ROW_BYTES};
use crate::{boards, last_words};

#[cfg(feature = "defmt")]
use crate::logger::Logs;
#[cfg(not(feature = "defmt"))]
use microbrdf_firmware::NoLog as Logs;

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
        defmt::info!(
            "frame {} sent; stack: at most {} of {} bytes used",
            number,
            crate::stack::used(),
            crate::stack::size(),
        );
        boards::wait_for_request();
        number = number.wrapping_add(1);
    }
}
