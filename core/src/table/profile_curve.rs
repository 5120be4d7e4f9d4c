//! A free profile ξ(m) of a patch mixture.

use crate::error::ParameterError;

/// Number of knots of a [`ProfileCurve`].
pub const PROFILE_KNOTS: usize = CELLS + 1;
const CELLS: usize = 1 << CELL_BITS;
const CELL_BITS: u32 = 7;

/// A profile ξ(m), tabulated over a distance m from 0 to a reach of 2, 1, 1/2,
/// … 2⁻¹⁰, 520 bytes. Beyond its reach it keeps the last knot's value.
///
/// The host computes the knots; between them the curve is linear. What that
/// costs is the host's to know. `q15` takes the position within a cell to
/// 1/256, and a share is within 1e-5 of the line in `f32`, for any knots;
/// `table::profile_curve::tests`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProfileCurve {
    /// 31 fraction bits.
    knots: [u32; PROFILE_KNOTS],
    /// The reach is 2 · 2^−`halvings`.
    halvings: u32,
}

impl ProfileCurve {
    /// The greatest number of halvings.
    pub const MOST_HALVINGS: u32 = 11;

    /// The curve through `knots` with 31 fraction bits, evenly spaced from
    /// m = 0 to m = 2 · 2^−`halvings`.
    ///
    /// # Errors
    /// A knot above 1, or more than 11 halvings.
    pub const fn new(knots: [u32; PROFILE_KNOTS], halvings: u32) -> Result<Self, ParameterError> {
        if halvings > Self::MOST_HALVINGS {
            return Err(ParameterError::new("halvings", "a number from 0 to 11"));
        }
        let mut i = 0;
        while i < PROFILE_KNOTS {
            if knots[i] > 1 << 31 {
                return Err(ParameterError::new("knots", "numbers from 0 to 1"));
            }
            i += 1;
        }
        Ok(Self { knots, halvings })
    }

    /// The distance m of knot `index`, in units of 2⁻¹⁷.
    #[must_use]
    pub const fn distance(halvings: u32, index: usize) -> u32 {
        (index as u32) << (18 - CELL_BITS - halvings)
    }

    /// The knots to either side of a cell, or twice the last one.
    #[inline]
    fn ends(&self, cell: usize) -> (u32, u32) {
        let cell = cell.min(CELLS);
        let left = self.knots[cell];
        (left, *self.knots.get(cell + 1).unwrap_or(&left))
    }

    /// ξ with 31 fraction bits at a distance with 31, of which 2.0 is the end
    /// of the whole domain.
    #[inline]
    pub(crate) fn at(&self, distance: u64) -> u32 {
        const FRACTION_BITS: u32 = 16;
        let position = (distance << self.halvings) >> (32 - CELL_BITS - FRACTION_BITS);
        let (left, right) = self.ends((position >> FRACTION_BITS) as usize);
        let within = (position & ((1 << FRACTION_BITS) - 1)) as i64;
        let rise = (i64::from(right) - i64::from(left)) * within;
        (i64::from(left) + (rise >> FRACTION_BITS)) as u32
    }

    /// As [`Self::at`], in 32-bit steps, at a distance with 29 fraction bits.
    #[inline]
    pub(crate) fn at_short(&self, distance: u32) -> u32 {
        /// What a difference of knots leaves room for in 32 bits.
        const FRACTION_BITS: u32 = 8;
        // Distances are below 4: 31 bits. Beyond the reach the cell only has
        // to stay beyond it.
        let scaled = distance.saturating_mul(1 << (self.halvings % 32));
        let position = scaled >> (30 - CELL_BITS - FRACTION_BITS);
        let (left, right) = self.ends((position >> FRACTION_BITS) as usize);
        let (left, right) = ((left >> 8) as i32, (right >> 8) as i32);
        let within = (position % (1 << FRACTION_BITS)) as i32;
        let rise = (right - left) * within;
        ((left + (rise >> FRACTION_BITS)) as u32) << 8
    }

    /// As [`Self::at`], in single precision; 0 for what is not a number.
    #[inline]
    pub(crate) fn at_f32(&self, distance: f32) -> f32 {
        if distance.is_nan() {
            return 0.0;
        }
        let position = distance * ((CELLS / 2) << self.halvings) as f32;
        let cell = position as u32 as usize;
        let (left, right) = self.ends(cell);
        let (left, right) = (left as f32, right as f32);
        // Past the last knot both are the same: any finite position will do.
        let within = position.min(CELLS as f32) - cell.min(CELLS) as f32;
        (left + (right - left) * within) / 2_147_483_648.0
    }
}

#[cfg(test)]
mod tests {
    use super::{PROFILE_KNOTS, ProfileCurve};

    /// A sawtooth: every cell rises or falls by the whole range.
    fn steep(halvings: u32) -> ProfileCurve {
        let mut knots = [0; PROFILE_KNOTS];
        for (i, knot) in knots.iter_mut().enumerate() {
            *knot = if i % 2 == 0 { 1 << 31 } else { 0 };
        }
        ProfileCurve::new(knots, halvings).expect("knots from 0 to 1")
    }

    #[test]
    fn three_readings_agree() {
        for halvings in 0..=ProfileCurve::MOST_HALVINGS {
            let curve = steep(halvings);
            for i in 0..1u32 << 12 {
                // Up to 1/8 past the reach.
                let distance = i * (9 << (15 - halvings));
                let exact = f64::from(curve.at(u64::from(distance) << 2)) / 2f64.powi(31);
                let short = f64::from(curve.at_short(distance)) / 2f64.powi(31);
                let single = f64::from(curve.at_f32(distance as f32 / 2f32.powi(29)));
                // A position within a cell has 8 bits in the short reading.
                assert!(
                    (short - exact).abs() <= 1.0 / 256.0 + 1e-6,
                    "{halvings}, {i}"
                );
                assert!(
                    (single - exact).abs() <= 1e-5,
                    "{halvings}, {i}: {single}, {exact}"
                );
            }
        }
    }

    #[test]
    fn beyond_the_reach_it_keeps_its_last_value() {
        let curve = steep(3);
        for distance in [1u32 << 27, 1 << 30, u32::MAX] {
            assert_eq!(curve.at(u64::from(distance) << 2), 1 << 31);
            assert_eq!(curve.at_short(distance), 1 << 31);
            assert_eq!(curve.at_f32(distance as f32 / 2f32.powi(29)), 1.0);
        }
        assert_eq!(curve.at_f32(f32::INFINITY), 1.0);
        assert_eq!(curve.at_f32(f32::NAN), 0.0);
    }

    #[test]
    fn what_no_curve_has_is_refused() {
        let knots = [0; PROFILE_KNOTS];
        assert!(ProfileCurve::new(knots, 12).is_err());
        let mut knots = knots;
        knots[128] = (1 << 31) + 1;
        assert!(ProfileCurve::new(knots, 0).is_err());
    }

    #[test]
    fn knots_are_evenly_spaced() {
        assert_eq!(ProfileCurve::distance(0, 128), 2 << 17);
        assert_eq!(ProfileCurve::distance(11, 64), 1 << (17 - 11));
    }
}
