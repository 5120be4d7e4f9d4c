//! The frame at half its size, in greys, on a panel of 128 x 64.

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use microbrdf::shade::{Linear, grey16, grey16_nearest};

use crate::panel::Panel;
use crate::ssd0323::{COLUMNS, ROW_BYTES, Ssd0323, Ssd0323Error};

/// Shows each 2 x 2 box of the frame as one grey pixel of an [`Ssd0323`].
///
/// A panel pixel is the mean of the four luminances (Rec. 709) in linear light,
/// which [`grey16`] turns into one of 16 levels by a gamma and an ordered dither,
/// or [`grey16_nearest`] without one.
/// Of a frame larger than 256 x 128 the top left part is shown; the last row or
/// column of an odd size is not, having no partner.
pub struct Greys<SPI, DC> {
    display: Ssd0323<SPI, DC>,
    dither: bool,
    /// For each panel column, the sum of the luminances that have come: at most
    /// 4 of them, of 25 bits each.
    sums: [u32; COLUMNS],
}

impl<SPI: SpiDevice, DC: OutputPin> Greys<SPI, DC> {
    /// Shows frames on `display`, which must be on, dithered or not.
    pub fn new(display: Ssd0323<SPI, DC>, dither: bool) -> Self {
        Self {
            display,
            dither,
            sums: [0; COLUMNS],
        }
    }
}

impl<SPI: SpiDevice, DC: OutputPin> Panel for Greys<SPI, DC> {
    type Error = Ssd0323Error<SPI::Error, DC::Error>;

    #[inline]
    fn pixel(&mut self, x: usize, light: Linear) {
        if let Some(sum) = self.sums.get_mut(x / 2) {
            *sum += light.luminance();
        }
    }

    fn end_row(&mut self, y: usize) -> Result<(), Self::Error> {
        if y % 2 == 0 {
            return Ok(());
        }
        let row = y / 2;
        let level = |column: usize| match (self.sums[column] / 4, self.dither) {
            (mean, true) => grey16(mean, column, row),
            (mean, false) => grey16_nearest(mean),
        };
        let bytes: [u8; ROW_BYTES] =
            core::array::from_fn(|pair| level(2 * pair) << 4 | level(2 * pair + 1));
        self.sums = [0; COLUMNS];
        self.display.write_row(row, &bytes)
    }
}
