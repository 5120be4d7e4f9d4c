//! The numbers that both ends agree on. `docs/wire-format.md` explains them.

/// Version of the protocol that this crate speaks, sent as the first field of
/// the frame header. A receiver refuses every other version.
pub const PROTOCOL_VERSION: u8 = 1;

/// Greatest length of a packet in bytes, checksum included, before framing.
///
/// 254 is the longest message for which COBS adds exactly one byte.
pub const MAX_PACKET: usize = 254;

/// Greatest number of bytes that one packet takes on the wire: a delimiter
/// before it (sent ahead of headers, faults and logs), the COBS code byte, the packet,
/// and the delimiter that ends it.
pub const MAX_WIRE: usize = 257;

/// Greatest number of pixel bytes in one packet: 80 pixels of
/// [`PixelFormat::Srgb8`] or 120 of [`PixelFormat::Rgb565`].
pub const MAX_CHUNK: usize = 240;

/// Greatest length in bytes of a board, core, arithmetic or scene name.
pub const MAX_NAME: usize = 32;

/// Greatest length in bytes of the compiler string.
pub const MAX_COMPILER: usize = 96;

/// Greatest length in bytes of the text of a fault; longer ones are cut.
pub const MAX_FAULT_TEXT: usize = 240;

/// Greatest number of log bytes in one packet; longer ones are split.
pub const MAX_LOG: usize = 240;

/// How a pixel is laid out on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum PixelFormat {
    /// Three bytes: red, green, blue, each 8-bit sRGB.
    Srgb8 = 1,
    /// Two bytes, little-endian: red in bits 15 to 11, green in 10 to 5, blue in 4 to 0.
    Rgb565 = 2,
}

impl PixelFormat {
    /// Bytes of one pixel: 3 or 2.
    pub const fn bytes_per_pixel(self) -> usize {
        match self {
            Self::Srgb8 => 3,
            Self::Rgb565 => 2,
        }
    }

    /// The format with this code in the header; `None` if there is no such.
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            1 => Some(Self::Srgb8),
            2 => Some(Self::Rgb565),
            _ => None,
        }
    }

    /// The code that stands for this format in the header.
    pub const fn code(self) -> u8 {
        self as u8
    }

    /// The name that reports use: `srgb8` or `rgb565`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Srgb8 => "srgb8",
            Self::Rgb565 => "rgb565",
        }
    }
}
