//! The end of a frame.

use super::Kind;
use super::fields::Fields;
use crate::bounded::Full;
use crate::wire::Body;

/// The frame is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EndOfFrame {
    /// Number of the frame.
    pub frame: u16,
    /// Number of whole rows that were sent.
    pub rows: u16,
    /// CRC-32/ISO-HDLC of all pixel bytes in raster order.
    pub checksum: u32,
}

impl EndOfFrame {
    pub(super) fn parse(payload: &[u8]) -> Option<Self> {
        let mut fields = Fields(payload);
        let end = Self {
            frame: fields.u16()?,
            rows: fields.u16()?,
            checksum: fields.u32()?,
        };
        fields.end().map(|()| end)
    }

    pub(crate) fn lay_out(&self, body: &mut Body) -> Result<(), Full> {
        body.push(Kind::End.code())?;
        body.extend(&self.frame.to_le_bytes())?;
        body.extend(&self.rows.to_le_bytes())?;
        body.extend(&self.checksum.to_le_bytes())?;
        Ok(())
    }
}
