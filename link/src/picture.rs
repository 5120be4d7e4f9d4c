//! A picture of which a part may be missing.

use crate::format::PixelFormat;

/// The pixels of a frame as far as they have come, with a note of which have.
///
/// Borrowed from the [`Reassembler`](crate::Reassembler) that fills it.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) format: PixelFormat,
    pub(crate) pixels: &'a [u8],
    pub(crate) present: &'a [u8],
}

impl<'a> Picture<'a> {
    /// Pixels in a row.
    pub fn width(&self) -> u16 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u16 {
        self.height
    }

    /// Layout of a pixel.
    pub fn format(&self) -> PixelFormat {
        self.format
    }

    /// All pixel bytes in raster order; 0 where nothing has come.
    pub fn bytes(&self) -> &'a [u8] {
        self.pixels
    }

    /// Whether this pixel has come; `false` outside the picture.
    pub fn has_pixel(&self, column: u16, row: u16) -> bool {
        column < self.width && row < self.height && bit(self.present, self.number(column, row))
    }

    /// Whether all pixels of this row have come; `false` outside the picture.
    pub fn has_row(&self, row: u16) -> bool {
        row < self.height && (0..self.width).all(|column| self.has_pixel(column, row))
    }

    /// The rows that are not whole, from the top.
    pub fn missing_rows(self) -> impl Iterator<Item = u16> + 'a {
        (0..self.height).filter(move |&row| !self.has_row(row))
    }

    fn number(&self, column: u16, row: u16) -> usize {
        pixel_number(self.width, column, row)
    }
}

/// Number of a pixel in raster order.
pub(crate) fn pixel_number(width: u16, column: u16, row: u16) -> usize {
    usize::from(row)
        .saturating_mul(usize::from(width))
        .saturating_add(usize::from(column))
}

/// Bit `number` of a bit set, `false` past its end.
pub(crate) fn bit(set: &[u8], number: usize) -> bool {
    set.get(number >> 3)
        .is_some_and(|byte| byte >> (number & 7) & 1 == 1)
}

/// Sets bit `number`, and says whether it was clear; `false` past the end.
pub(crate) fn set_bit(set: &mut [u8], number: usize) -> bool {
    set.get_mut(number >> 3).is_some_and(|byte| {
        let mask = 1 << (number & 7);
        let was_clear = *byte & mask == 0;
        *byte |= mask;
        was_clear
    })
}
