//! Which exponents n a stored lobe cosⁿα takes.

use fixed::types::U32F32;

use crate::error::ParameterError;

/// An exponent of single precision: 0 to 1e8.
///
/// # Errors
/// `n` outside its range or not a number.
pub(crate) const fn single(n: f32) -> Result<f32, ParameterError> {
    if n >= 0.0 && n <= 1e8 {
        Ok(n)
    } else {
        Err(ParameterError::new("exponent", "a number from 0 to 1e8"))
    }
}

/// The bits of an exponent of fixed point: 0, or 1 to 1e8. Between 0 and 1 the
/// slope at α = 90° is infinite, which no table of even cells holds.
///
/// # Errors
/// `n` outside its range.
pub(crate) const fn fixed(n: U32F32) -> Result<u64, ParameterError> {
    let bits = n.to_bits();
    if bits == 0 || (bits >= 1 << 32 && bits <= 100_000_000 << 32) {
        Ok(bits)
    } else {
        Err(ParameterError::new(
            "exponent",
            "0 or a number from 1 to 1e8",
        ))
    }
}
