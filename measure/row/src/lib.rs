//! Two exported functions for an emulated core that counts cycles: a row of a
//! baked scene, shaded and encoded as firmware does, and the packing of rows.
#![cfg_attr(target_os = "none", no_std)]

#[cfg(target_os = "none")]
mod row;

use core::convert::Infallible;

use embedded_io::{ErrorType, Write};
use microbrdf_link::{FrameWriter, Header, PixelFormat};

/// Pixels of the rows that are packed.
pub const WIDTH: u16 = 96;

/// Bytes of one of them.
pub const ROW_BYTES: usize = 3 * WIDTH as usize;

/// Puts `rows` rows into packets, behind a header, and gives a sum of their
/// bytes: with one row more it takes one row's cycles more.
#[allow(unsafe_code)]
#[unsafe(export_name = "pack")]
pub extern "C" fn pack(rows: u32) -> u32 {
    let mut row = [0; ROW_BYTES];
    for (byte, number) in row.iter_mut().zip(0u32..) {
        *byte = (number.wrapping_mul(0x9E37_79B1) >> 24) as u8;
    }
    let header = Header::new(WIDTH, 16, PixelFormat::Srgb8);
    let mut sum = Sum(0);
    let Ok(mut frame) = FrameWriter::begin(&mut sum, &header) else {
        return 0;
    };
    for y in 0..rows {
        if frame.row(y as u16, &row).is_err() {
            return 0;
        }
    }
    sum.0
}

/// A line that adds up what is sent, a byte of each packet: a queue's own work
/// is its board's.
struct Sum(u32);

impl ErrorType for Sum {
    type Error = Infallible;
}

impl Write for Sum {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let middle = bytes.get(bytes.len() / 2).copied().unwrap_or(0);
        self.0 = self.0.wrapping_mul(31).wrapping_add(u32::from(middle));
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // An emulator that finds no result says so.
    loop {}
}
