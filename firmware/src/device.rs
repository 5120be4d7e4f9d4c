//! The device's life: a frame at once, and one more whenever a byte comes in.

use cortex_m::singleton;
use heapless::Vec;
use microbrdf_firmware::send_frame;

use crate::baked::{Baked, PIXEL_FORMAT, ROW_BYTES};
use crate::{boards, last_words, logger};

#[cortex_m_rt::entry]
fn main() -> ! {
    let mut board = boards::start();
    logger::started(&board);
    let Some(row) = singleton!(: Vec<u8, ROW_BYTES> = Vec::new()) else {
        unreachable!("main runs once");
    };
    let mut number: u16 = 0;
    loop {
        last_words::frame_begins(number);
        if let Err(error) = send_frame(&Baked, &mut board, PIXEL_FORMAT, row, number) {
            panic!("frame {number}: {error:?}");
        }
        boards::wait_for_request();
        number = number.wrapping_add(1);
    }
}
