//! Pixels of one row, or of a part of it.

use super::Kind;
use super::fields::Fields;
use crate::bounded::Full;
use crate::format::MAX_CHUNK;
use crate::wire::Body;

/// Consecutive pixels of one row.
///
/// A row is sent in as many of these as it takes, so that no side has to hold
/// it whole and a damaged byte costs no more than [`MAX_CHUNK`]
/// bytes of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixels<'a> {
    /// Number of the frame.
    pub frame: u16,
    /// Row, counted from 0 at the top.
    pub row: u16,
    /// Column of the first pixel, counted from 0 at the left.
    pub column: u16,
    /// The pixels in the frame's format; 1 to [`MAX_CHUNK`] bytes, whole pixels.
    pub data: &'a [u8],
}

impl<'a> Pixels<'a> {
    pub(super) fn parse(payload: &'a [u8]) -> Option<Self> {
        let mut fields = Fields(payload);
        let pixels = Self {
            frame: fields.u16()?,
            row: fields.u16()?,
            column: fields.u16()?,
            data: fields.0,
        };
        (1..=MAX_CHUNK)
            .contains(&pixels.data.len())
            .then_some(pixels)
    }

    pub(crate) fn lay_out(&self, body: &mut Body) -> Result<(), Full> {
        body.push(Kind::Pixels.code())?;
        for number in [self.frame, self.row, self.column] {
            body.extend(&number.to_le_bytes())?;
        }
        body.extend(self.data)?;
        Ok(())
    }
}
