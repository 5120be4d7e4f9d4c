//! A device's last words.

use core::str;

use super::Kind;
use super::fields::Fields;
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

impl<'a> Fault<'a> {
    /// Reads a fault; its text ends where it ceases to be UTF-8.
    pub(super) fn parse(payload: &'a [u8]) -> Option<Self> {
        let mut fields = Fields(payload);
        Some(Self {
            frame: fields.u16()?,
            code: FaultCode::from_code(fields.u8()?),
            text: valid_start(fields.0),
        })
    }

    pub(crate) fn lay_out(&self, body: &mut Body) -> Result<(), Full> {
        body.push(Kind::Fault.code())?;
        body.extend(&self.frame.to_le_bytes())?;
        body.push(self.code.code())?;
        body.extend(self.text.as_bytes())?;
        Ok(())
    }
}

fn valid_start(bytes: &[u8]) -> &str {
    let valid = match str::from_utf8(bytes) {
        Ok(_) => bytes.len(),
        Err(error) => error.valid_up_to(),
    };
    let start = bytes.get(..valid).unwrap_or_default();
    str::from_utf8(start).unwrap_or_default()
}
