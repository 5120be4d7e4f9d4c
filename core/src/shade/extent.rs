//! Where in the picture a shape may be seen.

/// Columns and rows of the camera outside which a shape is not looked for: a
/// ray there costs it four comparisons.
///
/// Whoever makes a scene computes them, at least as wide as the shape is seen;
/// [`Extent::EVERYWHERE`] is always right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The first column, and the one after the last.
    pub columns: [u16; 2],
    /// The first row, and the one after the last.
    pub rows: [u16; 2],
}

impl Extent {
    /// The whole of any picture.
    pub const EVERYWHERE: Self = Self {
        columns: [0, u16::MAX],
        rows: [0, u16::MAX],
    };

    /// Whether the pixel in column `x` of row `y` is within.
    #[inline]
    #[must_use]
    pub fn holds(&self, x: usize, y: usize) -> bool {
        let within =
            |[first, end]: [u16; 2], i: usize| usize::from(first) <= i && i < usize::from(end);
        within(self.columns, x) && within(self.rows, y)
    }
}

#[cfg(test)]
mod tests {
    use super::Extent;

    #[test]
    fn the_first_is_within_and_the_end_is_not() {
        let extent = Extent {
            columns: [3, 5],
            rows: [0, 1],
        };
        for (x, y, within) in [
            (2, 0, false),
            (3, 0, true),
            (4, 0, true),
            (5, 0, false),
            (4, 1, false),
        ] {
            assert_eq!(extent.holds(x, y), within, "{x}, {y}");
        }
        assert!(Extent::EVERYWHERE.holds(4095, 4095));
    }
}
