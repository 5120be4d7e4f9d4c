//! Where the picture is taken from.

use super::Tracing;

/// A pinhole camera; pixel (x, y) looks along
/// `forward` + (2x + 1 − width)·`right` + (height − 1 − 2y)·`up`.
///
/// Lengths are [`Tracing::Fine`]; `forward` is a unit vector, `right` and
/// `up` are half a pixel's step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<A: Tracing> {
    /// Columns, at least 1.
    pub width: u16,
    /// Rows, at least 1.
    pub height: u16,
    /// To the centre of the picture.
    pub forward: [A::Fine; 3],
    /// Half a pixel to the right.
    pub right: [A::Fine; 3],
    /// Half a pixel up.
    pub up: [A::Fine; 3],
}

impl<A: Tracing> Camera<A> {
    /// Column `x` and row `y` counted in half pixels from the centre, to the right
    /// and up: two from a pixel to the next.
    #[inline]
    #[must_use]
    pub fn half_steps(&self, x: usize, y: usize) -> (i32, i32) {
        let (x, y) = (x as i32, y as i32);
        (
            2 * x + 1 - i32::from(self.width),
            i32::from(self.height) - 1 - 2 * y,
        )
    }
}
