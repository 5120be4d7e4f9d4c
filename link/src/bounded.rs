//! A byte buffer of fixed capacity.

use core::fmt;

/// At most `N` bytes, kept in place; what does not fit is refused.
///
/// As a [`fmt::Write`] it behaves otherwise: it keeps what fits and drops the
/// rest, so that a long panic message still yields its beginning.
#[derive(Clone)]
pub struct Bounded<const N: usize> {
    bytes: [u8; N],
    len: usize,
}

impl<const N: usize> Bounded<N> {
    /// An empty buffer.
    pub const fn new() -> Self {
        Self {
            bytes: [0; N],
            len: 0,
        }
    }

    /// The bytes that were put in.
    pub fn as_slice(&self) -> &[u8] {
        self.bytes.get(..self.len).unwrap_or_default()
    }

    /// The bytes that were put in, to be changed in place.
    pub fn as_mut_slice(&mut self) -> &mut [u8] {
        self.bytes.get_mut(..self.len).unwrap_or_default()
    }

    /// Number of bytes that still fit.
    pub fn room(&self) -> usize {
        N.saturating_sub(self.len)
    }

    /// Empties the buffer.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Appends all of `more`.
    ///
    /// # Errors
    /// [`Full`] if it does not fit; the buffer is then unchanged.
    pub fn extend(&mut self, more: &[u8]) -> Result<(), Full> {
        let free = self.bytes.get_mut(self.len..).ok_or(Full)?;
        // Cut to the length of `more` itself, so that the copy cannot panic.
        let place = free.get_mut(..more.len()).ok_or(Full)?;
        place.copy_from_slice(more);
        self.len = self.len.saturating_add(more.len());
        Ok(())
    }

    /// Appends one byte.
    ///
    /// # Errors
    /// [`Full`] if there is no room; the buffer is then unchanged.
    pub fn push(&mut self, byte: u8) -> Result<(), Full> {
        self.extend(&[byte])
    }
}

impl<const N: usize> Default for Bounded<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> fmt::Debug for Bounded<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.as_slice()).finish()
    }
}

impl<const N: usize> fmt::Write for Bounded<N> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for character in text.chars() {
            let mut utf8 = [0; 4];
            if self
                .extend(character.encode_utf8(&mut utf8).as_bytes())
                .is_err()
            {
                return Err(fmt::Error);
            }
        }
        Ok(())
    }
}

/// A fixed buffer had no room for what was to be put in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the buffer is full")]
pub struct Full;
