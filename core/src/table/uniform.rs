//! A curve in cells of equal width, read with linear interpolation.

use super::integer::{ONE, exp_neg, power_of_one_minus, round_to, times};

/// Bits of the position within a cell.
const FRACTION_BITS: u32 = 16;
/// Fraction bits of an entry: 1.0 is `1 << 31`.
const ENTRY_BITS: u32 = 31;

/// A curve over a coordinate from 0, in `CELLS` cells of equal width.
///
/// The width is a power of two, so that cell and position within it are two
/// shifts; the cells reach from 0 to where the curve has fallen below 2⁻³¹.
/// Beyond them the curve is 0. Inner knots lie half of the chord's error
/// below the curve, so that the error of a convex curve is centred on 0.
///
/// `CELLS` trades bytes against error: four bytes a cell, and the error falls
/// with its square. With 1024 cells the greatest error of (1 − x)ⁿ is 1.9e-4
/// of its value + 2⁻³⁰ for n from 5 to 1e8, and 1.6e-5 for n from 1 to 5,
/// whose tangent or curvature breaks off at x = 1; that of e^(−s·m) is 1.9e-4
/// of its value + 2⁻³⁰ for any s. It is greatest in the first cell, since the
/// peak is exact; tested in `tests/tests/tables.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UniformTable<const CELLS: usize> {
    /// Value at the left end of each cell, 31 fraction bits.
    starts: [u32; CELLS],
    /// Value at the right end of the last cell.
    end: u32,
    /// Binary logarithm of the width of a cell.
    shift: u32,
}

impl<const CELLS: usize> UniformTable<CELLS> {
    /// (1 − x)ⁿ over `x`, which is given to [`Self::at`] with `x_bits`
    /// fraction bits; `n` has 32 fraction bits. Beyond x = 1 it is 0.
    pub(crate) const fn power(n: u64, x_bits: u32) -> Self {
        Self::build(Curve::Power(n), x_bits, 1 << x_bits)
    }

    /// e^(−s·m) over `m`, which is given to [`Self::at`] with `m_bits`
    /// fraction bits; `s` has 32 fraction bits. Beyond m = 2 it is 0.
    pub(crate) const fn exponential(s: u64, m_bits: u32) -> Self {
        // Lengths within 2⁻¹⁴ of 1 take m a little past 2: cover it.
        Self::build(
            Curve::Exponential(s),
            m_bits,
            (2 << m_bits) + (1 << (m_bits - 10)),
        )
    }

    const fn build(curve: Curve, bits: u32, domain: u64) -> Self {
        // The least width with which the cells reach the end of the domain,
        // or at least the point where the curve vanishes.
        let mut shift = FRACTION_BITS;
        while ((CELLS as u64) << shift) < domain
            && round_to(curve.at((CELLS as u64) << shift, bits), ENTRY_BITS) > 0
        {
            shift += 1;
        }
        let half = 1 << (shift - 1);
        let mut starts = [0; CELLS];
        let mut sag_before = 0;
        let mut value = curve.at(0, bits);
        let mut i = 0;
        while i < CELLS {
            let left = (i as u64) << shift;
            let next = curve.at(left + 2 * half, bits);
            let middle = curve.at(left + half, bits);
            let sag = ((value + next) / 2).saturating_sub(middle);
            // The peak stays exact.
            let lowered = if i == 0 {
                value
            } else {
                value.saturating_sub((sag_before + sag) / 4)
            };
            starts[i] = round_to(lowered, ENTRY_BITS);
            sag_before = sag;
            value = next;
            i += 1;
        }
        Self {
            starts,
            end: round_to(value, ENTRY_BITS),
            shift,
        }
    }

    /// The curve's value at `coordinate`, with 31 fraction bits; 0 beyond the
    /// last cell.
    #[inline]
    pub(crate) fn at(&self, coordinate: u64) -> u32 {
        let position = coordinate >> (self.shift - FRACTION_BITS);
        let cell = (position >> FRACTION_BITS) as usize;
        let Some(&left) = self.starts.get(cell) else {
            return 0;
        };
        let right = *self.starts.get(cell + 1).unwrap_or(&self.end);
        let fraction = (position & ((1 << FRACTION_BITS) - 1)) as i64;
        let rise = (i64::from(right) - i64::from(left)) * fraction;
        (i64::from(left) + (rise >> FRACTION_BITS)) as u32
    }
}

/// A curve from which a table is built.
#[derive(Clone, Copy)]
enum Curve {
    Power(u64),
    Exponential(u64),
}

impl Curve {
    /// Value, 64 fraction bits, at a coordinate with `bits` fraction bits.
    const fn at(self, coordinate: u64, bits: u32) -> u128 {
        let argument = (coordinate as u128) << (64 - bits);
        match self {
            Self::Power(0) => ONE,
            Self::Power(_) if argument >= ONE => 0,
            Self::Power(n) => power_of_one_minus(argument as u64, n),
            Self::Exponential(s) => exp_neg(times(s, argument)),
        }
    }
}
