//! A profile over the square of a distance.

use crate::arithmetic::short::scale;
use crate::error::ParameterError;

/// Number of knots of a [`SquareCurve`].
pub const SQUARE_KNOTS: usize = CELLS + 1;
const CELLS: usize = 1 << CELL_BITS;
const CELL_BITS: u32 = 7;

/// A profile tabulated over m² from 0 to a reach of 1 to 4, 262 bytes. Beyond
/// its reach it keeps the last knot's value, so that a clip lies on a knot.
///
/// A profile that is smooth in m² needs no root, and no narrow cells at m = 0.
/// The host computes the knots; between them the curve is linear. `q15` takes
/// the position within a cell to 1/256, and 1/reach to 16 bits;
/// `table::square_curve::tests`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SquareCurve {
    /// 15 fraction bits.
    knots: [u16; SQUARE_KNOTS],
    /// 1/reach with 32 fraction bits, of which the upper 16 count.
    inverse: u32,
}

impl SquareCurve {
    /// The curve through `knots` with 15 fraction bits, evenly spaced in m²
    /// from 0 to 65536/`inverse`.
    ///
    /// # Errors
    /// A knot above 1, or an `inverse` below 1/4.
    pub const fn new(knots: [u16; SQUARE_KNOTS], inverse: u16) -> Result<Self, ParameterError> {
        if inverse < 1 << 14 {
            return Err(ParameterError::new("inverse", "a number from 16384"));
        }
        let mut i = 0;
        while i < SQUARE_KNOTS {
            if knots[i] > 1 << 15 {
                return Err(ParameterError::new("knots", "numbers from 0 to 1"));
            }
            i += 1;
        }
        Ok(Self {
            knots,
            inverse: (inverse as u32) << 16,
        })
    }

    /// The knots to either side of a cell, or twice the last one.
    #[inline]
    fn ends(&self, cell: usize) -> (i32, i32) {
        let cell = cell.min(CELLS);
        let left = self.knots[cell];
        let right = *self.knots.get(cell + 1).unwrap_or(&left);
        (i32::from(left), i32::from(right))
    }

    /// The value with 31 fraction bits at a square with 60.
    #[inline]
    pub(crate) fn at(&self, square: u64) -> u32 {
        const FRACTION_BITS: u32 = 16;
        // 28 bits and 32, from which the cells' 7 and the position's 16 are taken.
        let share = (square >> 32) * u64::from(self.inverse);
        let position = share >> (60 - CELL_BITS - FRACTION_BITS);
        let (left, right) = self.ends((position >> FRACTION_BITS) as usize);
        let within = (position & ((1 << FRACTION_BITS) - 1)) as i64;
        let rise = i64::from(right - left) * within;
        ((i64::from(left) << FRACTION_BITS) + rise) as u32
    }

    /// As [`Self::at`], in 32-bit steps, at a square with 28 fraction bits.
    #[inline]
    pub(crate) fn at_short(&self, square: u32) -> u32 {
        const FRACTION_BITS: u32 = 8;
        let position = scale(square, self.inverse) >> (28 - CELL_BITS - FRACTION_BITS);
        let (left, right) = self.ends((position >> FRACTION_BITS) as usize);
        let within = (position % (1 << FRACTION_BITS)) as i32;
        (((left << FRACTION_BITS) + (right - left) * within) as u32) << (31 - 15 - FRACTION_BITS)
    }

    /// As [`Self::at`], in single precision; 0 for what is not a number.
    #[inline]
    pub(crate) fn at_f32(&self, square: f32) -> f32 {
        if square.is_nan() {
            return 0.0;
        }
        let share = square * (self.inverse as f32 / 4_294_967_296.0);
        let position = share * CELLS as f32;
        let cell = position as u32 as usize;
        let (left, right) = self.ends(cell);
        // Past the last knot both are the same: any finite position will do.
        let within = position.min(CELLS as f32) - cell.min(CELLS) as f32;
        (left as f32 + (right - left) as f32 * within) / 32_768.0
    }
}

#[cfg(test)]
mod tests {
    use super::{SQUARE_KNOTS, SquareCurve};

    /// A sawtooth: every cell rises or falls by the whole range.
    fn steep(inverse: u16) -> SquareCurve {
        let mut knots = [0; SQUARE_KNOTS];
        for (i, knot) in knots.iter_mut().enumerate() {
            *knot = if i % 2 == 0 { 1 << 15 } else { 0 };
        }
        SquareCurve::new(knots, inverse).expect("knots from 0 to 1")
    }

    fn single(square: u32) -> f32 {
        square as f32 / 2f32.powi(28)
    }

    #[test]
    fn three_readings_agree() {
        for inverse in [1 << 14, 17_243, 40_000, 0xFFFF] {
            let curve = steep(inverse);
            for i in 0..1u32 << 14 {
                // To 4, past the reach.
                let square = i << 16;
                let exact = f64::from(curve.at(u64::from(square) << 32)) / 2f64.powi(31);
                let short = f64::from(curve.at_short(square)) / 2f64.powi(31);
                let float = f64::from(curve.at_f32(single(square)));
                assert!(
                    (short - exact).abs() <= 1.0 / 256.0 + 1e-6,
                    "{inverse}, {i}"
                );
                assert!(
                    (float - exact).abs() <= 5e-5,
                    "{inverse}, {i}: {float}, {exact}"
                );
            }
        }
    }

    /// A clip lies on the last knot: there the slope ends.
    #[test]
    fn beyond_the_reach_it_keeps_its_last_value() {
        let mut knots = [0; SQUARE_KNOTS];
        for (i, knot) in knots.iter_mut().enumerate() {
            *knot = 256 * i as u16;
        }
        // A reach of 2.
        let curve = SquareCurve::new(knots, 1 << 15).expect("a curve");
        for (square, expected) in [(0u32, 0.0), (1 << 28, 0.5), (3 << 27, 0.75), (2 << 28, 1.0)] {
            let found = [
                f64::from(curve.at(u64::from(square) << 32)) / 2f64.powi(31),
                f64::from(curve.at_short(square)) / 2f64.powi(31),
                f64::from(curve.at_f32(single(square))),
            ];
            assert_eq!(found, [expected; 3], "{square}");
        }
        for square in [2 << 28, 3 << 28, u32::MAX] {
            assert_eq!(curve.at(u64::from(square) << 32), 1 << 31);
            assert_eq!(curve.at_short(square), 1 << 31);
            assert_eq!(curve.at_f32(single(square)), 1.0);
        }
        assert_eq!(curve.at(u64::MAX), 1 << 31);
        assert_eq!(curve.at_f32(f32::INFINITY), 1.0);
        assert_eq!(curve.at_f32(f32::NAN), 0.0);
    }

    #[test]
    fn what_no_curve_has_is_refused() {
        let knots = [0; SQUARE_KNOTS];
        assert!(SquareCurve::new(knots, (1 << 14) - 1).is_err());
        let mut knots = knots;
        knots[128] = (1 << 15) + 1;
        assert!(SquareCurve::new(knots, 1 << 15).is_err());
    }
}
