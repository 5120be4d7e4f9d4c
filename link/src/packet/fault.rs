//! A device's last words.

use super::Kind;
use crate::bounded::Full;
use crate::wire::Body;

/// The device failed; nothing more of this frame will come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault<'a> {
    /// Number of the frame that was being sent, as far as the sender knows it.
    pub frame: u16,
    /// What kind of failure.
    pub code: FaultCode,
    /// Message, place or registers; UTF-8, at most
    /// [`MAX_FAULT_TEXT`](crate::MAX_FAULT_TEXT) bytes.
    pub text: &'a str,
}

/// What kind of failure a [`Fault`] reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FaultCode {
    /// Code 1: a Rust panic; the text is its message and place.
    Panic,
    /// Code 2: a hard fault of the processor; the text holds registers.
    HardFault,
    /// Any other code, which the receiver shows as a number.
    Other(u8),
}

impl FaultCode {
    /// The meaning of a code on the wire.
    pub const fn from_code(code: u8) -> Self {
        match code {
            1 => Self::Panic,
            2 => Self::HardFault,
            other => Self::Other(other),
        }
    }

    /// The code on the wire.
    pub const fn code(self) -> u8 {
        match self {
            Self::Panic => 1,
            Self::HardFault => 2,
            Self::Other(code) => code,
        }
    }
}

impl Fault<'_> {
    pub(crate) fn body(&self) -> Result<Body, Full> {
        let mut body = Body::new();
        body.push(Kind::Fault.code())?;
        body.extend(&self.frame.to_le_bytes())?;
        body.push(self.code.code())?;
        body.extend(self.text.as_bytes())?;
        Ok(body)
    }
}
