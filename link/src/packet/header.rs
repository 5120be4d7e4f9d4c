//! The frame header: who sends, and what the picture is.

use super::fields::Fields;
use super::{Kind, PacketError};
use crate::bounded::Full;
use crate::format::{MAX_COMPILER, MAX_NAME, PROTOCOL_VERSION, PixelFormat};
use crate::wire::Body;

/// Set in the flags byte when an exposure follows.
const HAS_EXPOSURE: u8 = 1;

/// What a receiver must know before the first pixel.
///
/// All texts are printable ASCII (0x20 to 0x7e) and may be empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Header<'a> {
    /// Protocol version; [`PROTOCOL_VERSION`] unless a test wants to be refused.
    pub version: u8,
    /// Number of the frame. It is repeated in every packet of the frame, and
    /// the next frame carries the next number, after 65535 again 0.
    pub frame: u16,
    /// Pixels in a row, at least 1.
    pub width: u16,
    /// Rows in the frame, at least 1.
    pub height: u16,
    /// Layout of a pixel.
    pub pixel_format: PixelFormat,
    /// Factor that the scene's light was scaled by, if the sender knows it; finite.
    pub exposure: Option<f64>,
    /// Name of the board, at most [`MAX_NAME`] bytes.
    pub board: &'a str,
    /// Name of the processor core, such as `cortex-m3`, at most [`MAX_NAME`] bytes.
    pub core: &'a str,
    /// The compiler's own version line, at most [`MAX_COMPILER`] bytes.
    pub compiler: &'a str,
    /// Name of the arithmetic, such as `q31`, at most [`MAX_NAME`] bytes.
    pub arithmetic: &'a str,
    /// Name of the scene, at most [`MAX_NAME`] bytes.
    pub scene: &'a str,
}

impl<'a> Header<'a> {
    /// A header of this crate's version with number 0 and empty texts, to be
    /// completed by struct update syntax.
    pub const fn new(width: u16, height: u16, pixel_format: PixelFormat) -> Self {
        Self {
            version: PROTOCOL_VERSION,
            frame: 0,
            width,
            height,
            pixel_format,
            exposure: None,
            board: "",
            core: "",
            compiler: "",
            arithmetic: "",
            scene: "",
        }
    }

    /// Bytes of one row of pixels.
    pub fn row_bytes(&self) -> usize {
        usize::from(self.width).saturating_mul(self.pixel_format.bytes_per_pixel())
    }

    /// The five texts with the name and the greatest length of each, in wire order.
    fn texts(&self) -> [(&'static str, &'a str, usize); 5] {
        [
            ("board", self.board, MAX_NAME),
            ("core", self.core, MAX_NAME),
            ("compiler", self.compiler, MAX_COMPILER),
            ("arithmetic", self.arithmetic, MAX_NAME),
            ("scene", self.scene, MAX_NAME),
        ]
    }

    /// Checks every field but the version.
    ///
    /// # Errors
    /// [`HeaderError`] names the field and what it may be.
    pub fn check(&self) -> Result<(), HeaderError> {
        for (field, value) in [("width", self.width), ("height", self.height)] {
            if value == 0 {
                return Err(HeaderError::ZeroSize { field });
            }
        }
        if self.exposure.is_some_and(|exposure| !exposure.is_finite()) {
            return Err(HeaderError::Exposure);
        }
        for (field, text, max) in self.texts() {
            if text.len() > max {
                return Err(HeaderError::TextTooLong {
                    field,
                    length: text.len(),
                    max,
                });
            }
            if !text.bytes().all(|byte| (0x20..=0x7e).contains(&byte)) {
                return Err(HeaderError::TextNotAscii { field });
            }
        }
        Ok(())
    }

    /// Reads a header from what follows its kind. The version is looked at
    /// first, and nothing else if it is another.
    pub(super) fn parse(payload: &'a [u8]) -> Result<Self, PacketError> {
        let malformed = PacketError::Layout {
            kind: Kind::Header.name(),
            length: payload.len(),
        };
        let mut fields = Fields(payload);
        let version = fields.u8().ok_or(malformed)?;
        if version != PROTOCOL_VERSION {
            return Err(PacketError::Version { version });
        }
        let frame = fields.u16().ok_or(malformed)?;
        let width = fields.u16().ok_or(malformed)?;
        let height = fields.u16().ok_or(malformed)?;
        let code = fields.u8().ok_or(malformed)?;
        let pixel_format = PixelFormat::from_code(code).ok_or(PacketError::PixelFormat { code })?;
        let exposure = match fields.u8().ok_or(malformed)? {
            0 => None,
            HAS_EXPOSURE => Some(fields.f64().ok_or(malformed)?),
            flags => return Err(PacketError::Flags { flags }),
        };
        let mut text = || fields.text().ok_or(malformed);
        let header = Self {
            version,
            frame,
            width,
            height,
            pixel_format,
            exposure,
            board: text()?,
            core: text()?,
            compiler: text()?,
            arithmetic: text()?,
            scene: text()?,
        };
        fields.end().ok_or(malformed)?;
        header.check().map_err(PacketError::Header)?;
        Ok(header)
    }

    /// Lays the header out; its texts must have been checked.
    pub(crate) fn lay_out(&self, body: &mut Body) -> Result<(), Full> {
        body.push(Kind::Header.code())?;
        body.push(self.version)?;
        for number in [self.frame, self.width, self.height] {
            body.extend(&number.to_le_bytes())?;
        }
        body.push(self.pixel_format.code())?;
        match self.exposure {
            None => body.push(0)?,
            Some(exposure) => {
                body.push(HAS_EXPOSURE)?;
                body.extend(&exposure.to_le_bytes())?;
            }
        }
        for (_, text, _) in self.texts() {
            body.push(u8::try_from(text.len()).map_err(|_| Full)?)?;
            body.extend(text.as_bytes())?;
        }
        Ok(())
    }
}

/// Why a header cannot be sent, or makes no sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HeaderError {
    /// A picture without pixels.
    #[error("{field} is 0, must be 1 to 65535")]
    ZeroSize {
        /// `width` or `height`.
        field: &'static str,
    },
    /// A text longer than its field.
    #[error("{field} is {length} bytes long, must be at most {max}")]
    TextTooLong {
        /// Which text.
        field: &'static str,
        /// Its length in bytes.
        length: usize,
        /// The greatest length that the field takes.
        max: usize,
    },
    /// A text with a byte outside 0x20 to 0x7e.
    #[error("{field} must be printable ASCII")]
    TextNotAscii {
        /// Which text.
        field: &'static str,
    },
    /// The exposure is NaN or infinite.
    #[error("exposure must be finite")]
    Exposure,
}
