//! A curve in cells of equal width, read with one multiplication of 32 bits
//! for the cell and one for the interpolation.

use super::integer::{ONE, exp_neg, power_of_one_minus, round_to, times};

/// Fraction bits of the coordinate.
const COORDINATE_BITS: u32 = 29;
/// Fraction bits of an entry. With 32 cells or more a curve falls by less than
/// 0.44 over one, so that the product with a position has 32 bits.
pub(crate) const ENTRY_BITS: u32 = 25;
/// Bits of the position within a cell.
const POSITION_BITS: u32 = 8;
/// −ln 2⁻²⁶: the curve ends where half an entry's step is left.
const DEPTH: u128 = 26 * super::integer::LN_2;

/// A falling curve over a coordinate from 0, held at `KNOTS` knots: a power of
/// two of cells, and one more.
///
/// The coordinate times a `step` fills 32 bits at the end of the last cell, so
/// that cell and position are its upper bits, for cells of any width. Knots
/// lie half of the chord's error below the curve, so that the error of a
/// convex curve is centred on 0.
///
/// `KNOTS` trades bytes against error: four bytes a knot, and the error falls
/// almost with its square. With 129 knots the greatest error of (1 − x)ⁿ is 2.3e-3
/// of its value + 2⁻²³ for n from 10 to 1e8, and 6.5e-4 for n from 1 to 10;
/// that of e^(−s·m) is 3.1e-3 of its value + 2⁻²³. `table::scaled::tests` reads 2¹⁶ coordinates of each of 100 tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScaledTable<const KNOTS: usize> {
    /// Cells per unit of the coordinate, scaled so that the last one ends at
    /// 2³².
    step: u32,
    /// Greatest coordinate within the last cell.
    limit: u32,
    knots: [u32; KNOTS],
}

impl<const KNOTS: usize> ScaledTable<KNOTS> {
    /// Binary logarithm of the number of cells.
    const CELL_BITS: u32 = {
        assert!(
            KNOTS >= 33 && KNOTS <= 4097 && (KNOTS - 1).is_power_of_two(),
            "the number of knots must be one more than a power of two from 32 to 4096"
        );
        (KNOTS - 1).ilog2()
    };

    /// (1 − x)ⁿ over x with 29 fraction bits; `n` has 32. Beyond x = 1 it is
    /// 0.
    pub(crate) const fn power(n: u64) -> Self {
        // 1 − x = e^(−depth/n) there.
        let end = if n <= 1 << 32 {
            ONE
        } else {
            ONE - exp_neg((DEPTH << 32) / n as u128)
        };
        Self::build(Curve::Power(n), end)
    }

    /// e^(−s·m) over m with 29 fraction bits; `s` has 32. Beyond m = 2 it is
    /// 0.
    pub(crate) const fn exponential(s: u64) -> Self {
        // Lengths within 2⁻¹⁴ of 1 take m a little past 2: cover it.
        let domain = 2 * ONE + (ONE >> 9);
        let end = if s == 0 {
            domain
        } else {
            (DEPTH << 32) / s as u128
        };
        Self::build(
            Curve::Exponential(s),
            if end < domain { end } else { domain },
        )
    }

    /// `end` is the coordinate, with 64 fraction bits, that the cells reach.
    const fn build(curve: Curve, end: u128) -> Self {
        let end = end >> (64 - COORDINATE_BITS);
        let step = (1u128 << 32) / if end > 1 { end } else { 1 };
        // Coordinate of knot i: i · 2³² / (cells · step), 64 fraction bits.
        let width = (1u128 << (32 - Self::CELL_BITS + 64 - COORDINATE_BITS - 1)) / step;
        let mut knots = [0; KNOTS];
        let mut sag_before = 0;
        let mut value = curve.at(0);
        let mut i = 0;
        while i < KNOTS {
            let left = 2 * i as u128 * width;
            let next = curve.at(left + 2 * width);
            let sag = if i + 1 < KNOTS {
                let middle = curve.at(left + width);
                ((value + next) / 2).saturating_sub(middle)
            } else {
                0
            };
            // The peak stays exact, which the next knot makes good.
            let lowered = match i {
                0 => value,
                1 => value.saturating_sub(2 * sag_before / 3),
                // The end stays exact: a lobe between n = 1 and 2 bends there
                // without bound.
                _ if i + 2 == KNOTS && sag > sag_before => value.saturating_sub(3 * sag / 4),
                _ => value.saturating_sub((sag_before + sag) / 4),
            };
            let knot = round_to(lowered, ENTRY_BITS);
            // Rounding must not make it rise: reading relies on it.
            knots[i] = if i > 0 && knots[i - 1] < knot {
                knots[i - 1]
            } else {
                knot
            };
            sag_before = sag;
            value = next;
            i += 1;
        }
        Self {
            step: step as u32,
            limit: (u32::MAX as u128 / step) as u32,
            knots,
        }
    }

    /// The curve's value at `coordinate`, with 31 fraction bits; 0 beyond the
    /// last cell.
    #[inline]
    pub(crate) fn at(&self, coordinate: u32) -> u32 {
        self.entry_at(coordinate).unwrap_or(0) << (31 - ENTRY_BITS)
    }

    /// As [`Self::at`], with an entry's fraction bits; `None` beyond the last
    /// cell.
    #[inline]
    pub(crate) const fn entry_at(&self, coordinate: u32) -> Option<u32> {
        if coordinate > self.limit {
            return None;
        }
        let position = coordinate.wrapping_mul(self.step);
        let cell = (position >> (32 - Self::CELL_BITS)) as usize;
        // There is one more knot than cells.
        let (left, right) = (self.knots[cell], self.knots[cell + 1]);
        let within = (position >> (32 - Self::CELL_BITS - POSITION_BITS)) % (1 << POSITION_BITS);
        // Curves fall: the difference is not negative.
        let fall = left.wrapping_sub(right).wrapping_mul(within) >> POSITION_BITS;
        Some(left.wrapping_sub(fall))
    }
}

/// A curve from which a table is built.
#[derive(Clone, Copy)]
enum Curve {
    Power(u64),
    Exponential(u64),
}

impl Curve {
    /// Value at a coordinate, both with 64 fraction bits.
    const fn at(self, coordinate: u128) -> u128 {
        match self {
            Self::Power(0) => ONE,
            Self::Power(_) if coordinate >= ONE => 0,
            Self::Power(n) => power_of_one_minus(coordinate as u64, n),
            Self::Exponential(s) => exp_neg(times(s, coordinate)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{COORDINATE_BITS, ScaledTable};

    const KNOTS: usize = 129;
    const STEP: f64 = 1.0 / (1u64 << 23) as f64;

    /// The greatest error: absolute, and relative to the value beyond a step.
    fn errors(table: &ScaledTable<KNOTS>, exact: impl Fn(f64) -> f64) -> [f64; 2] {
        let mut worst = [0.0f64; 2];
        let reach = u64::from(table.limit) + u64::from(table.limit >> 6) + 2;
        for i in 0..1u64 << 16 {
            let coordinate = ((i * reach) >> 16) as u32;
            let value = exact(f64::from(coordinate) / f64::from(1 << COORDINATE_BITS));
            if value == 0.0 {
                continue;
            }
            let error = (f64::from(table.at(coordinate)) / f64::from(1u32 << 31) - value).abs();
            worst[0] = worst[0].max(error);
            worst[1] = worst[1].max((error - STEP) / value.max(1e-30));
        }
        worst
    }

    fn power(n: f64) -> [f64; 2] {
        let table = ScaledTable::power((n * 4_294_967_296.0) as u64);
        errors(&table, |x| {
            if x < 1.0 {
                (n * (-x).ln_1p()).exp()
            } else {
                0.0
            }
        })
    }

    #[test]
    fn lobes_keep_a_relative_error() {
        let mut worst = 0.0f64;
        for i in 0..=64 {
            let n = 10.0 * 1e7f64.powf(f64::from(i) / 64.0);
            let [_, relative] = power(n);
            assert!(relative <= 2.3e-3, "n = {n}: {relative:e}");
            worst = worst.max(relative);
        }
        assert!(worst >= 2.2e-3, "{worst:e}");
    }

    #[test]
    fn broad_lobes_keep_an_absolute_error() {
        let mut worst = 0.0f64;
        for i in 0..=40 {
            let n = 1.0 + f64::from(i) * 0.225;
            let [absolute, _] = power(n);
            assert!(absolute <= 6.5e-4, "n = {n}: {absolute:e}");
            worst = worst.max(absolute);
        }
        assert!(worst >= 6e-4, "{worst:e}");
        assert_eq!(power(0.0)[0], 0.0);
        // What is left is the step of a position, 2⁻¹⁵ of the domain.
        assert!(power(1.0)[0] <= 1.0 / 32_768.0 + STEP);
    }

    /// Between n = 1 and 2 the slope there is 0, and the bend has no bound.
    #[test]
    fn where_a_broad_lobe_ends_its_error_is_balanced() {
        let (mut above, mut below) = (0.0f64, 0.0f64);
        for i in 0..=40 {
            let n = 1.0 + f64::from(i) / 40.0;
            let table = ScaledTable::<KNOTS>::power((n * 4_294_967_296.0) as u64);
            let last = table.limit - (table.limit >> 6);
            for coordinate in (last..=table.limit).step_by(1009) {
                let x = f64::from(coordinate) / f64::from(1 << COORDINATE_BITS);
                let exact = (1.0 - x).max(0.0).powf(n);
                let off = f64::from(table.at(coordinate)) / f64::from(1u32 << 31) - exact;
                above = above.max(off);
                below = below.max(-off);
            }
        }
        assert!((1.2e-4..=1.6e-4).contains(&above), "{above:e}");
        assert!((1.2e-4..=1.6e-4).contains(&below), "{below:e}");
    }

    #[test]
    fn profiles_keep_a_relative_error() {
        let mut worst = 0.0f64;
        for i in 0..=16 {
            let s = 4096f64.powf(f64::from(i) / 16.0);
            let table = ScaledTable::<KNOTS>::exponential((s * 4_294_967_296.0) as u64);
            // Beyond m = 2 there is no direction.
            let [_, relative] = errors(&table, |m| if m < 2.0 { (-s * m).exp() } else { 0.0 });
            assert!(relative <= 3.1e-3, "s = {s}: {relative:e}");
            worst = worst.max(relative);
        }
        assert!(worst >= 2.9e-3, "{worst:e}");
    }

    /// Four bytes a knot buy a quarter of the error for twice the knots.
    #[test]
    fn the_error_falls_with_the_square_of_the_cells() {
        let at = |value: u32| f64::from(value) / f64::from(1u32 << 31);
        let worst = |read: &dyn Fn(u32) -> u32| {
            (0..10_000u32).fold(0.0f64, |worst, i| {
                let x = i * 2_000;
                let exact =
                    (500.0 * (-f64::from(x) / f64::from(1 << COORDINATE_BITS)).ln_1p()).exp();
                worst.max((at(read(x)) - exact).abs())
            })
        };
        let (few, some, many) = (
            ScaledTable::<65>::power(500 << 32),
            ScaledTable::<129>::power(500 << 32),
            ScaledTable::<257>::power(500 << 32),
        );
        let errors = [
            worst(&|x| few.at(x)),
            worst(&|x| some.at(x)),
            worst(&|x| many.at(x)),
        ];
        assert!((3.0..4.6).contains(&(errors[0] / errors[1])), "{errors:?}");
        assert!((3.0..4.6).contains(&(errors[1] / errors[2])), "{errors:?}");
    }
}
