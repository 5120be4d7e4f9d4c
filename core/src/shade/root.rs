//! Roots of 64-bit numbers, without a division.

/// 1/√x with 7 fraction bits at the middles of the sixteenths from 1/4 to 1.
const FIRST: [u8; 12] = {
    let mut table = [0; 12];
    let mut cell = 4;
    while cell < 16 {
        // (2 · 2⁷)² over the middle, (2 · cell + 1)/32.
        let doubled = ((256 * 256 * 32) / (2 * cell + 1) as u32).isqrt();
        table[cell - 4] = doubled.div_ceil(2) as u8;
        cell += 1;
    }
    table
};

/// A normalised root: of `square` = x · 2⁽⁶⁴⁻ˢʰⁱᶠᵗ⁾, x in [1/4, 1).
pub(crate) struct Root {
    /// x with 32 fraction bits.
    mantissa: u32,
    /// 1/√x with 31 fraction bits.
    inverse: u32,
    /// Even.
    shift: u32,
}

impl Root {
    /// By Newton's iteration, y ← y·(3 − x·y²)/2: the 31 bits are within 8 of
    /// exact, tested here. The root of 0 is that of the least normalised
    /// number.
    #[inline]
    pub(crate) fn of(square: u64) -> Self {
        // Two places at a time: squares that matter are long, and small cores
        // have no instruction that counts zeros, nor one that shifts so far.
        let mut shift = 0;
        let mut square = square;
        while square < 1 << 62 && shift < 64 {
            square <<= 2;
            shift += 2;
        }
        let mantissa = ((square >> 32) as u32).max(1 << 30);
        let cell = (mantissa >> 28) as usize;
        let first = FIRST.get(cell.wrapping_sub(4)).copied().unwrap_or(u8::MAX);
        let mut inverse = u32::from(first) << 24;
        let mut round = 0;
        while round < 3 {
            let square = high(inverse, inverse);
            // 1 but for the error, with 30 fraction bits.
            let one = high(mantissa, square);
            let factor = (3u32 << 30).wrapping_sub(one);
            let wide = u64::from(inverse).wrapping_mul(u64::from(factor)) >> 31;
            inverse = if wide > u64::from(u32::MAX) {
                u32::MAX
            } else {
                wide as u32
            };
            round += 1;
        }
        Self {
            mantissa,
            inverse,
            shift,
        }
    }

    /// √`square`, within 12 · 2⁻³² of its value and a step; of 0 it is 0.
    #[inline]
    pub(crate) fn root(&self) -> u32 {
        // x/√x with 32 fraction bits, then back by half of the shift.
        let wide = u64::from(self.mantissa).wrapping_mul(u64::from(self.inverse)) >> 31;
        let root = if wide > u64::from(u32::MAX) {
            u32::MAX
        } else {
            wide as u32
        };
        root.checked_shr(self.shift / 2).unwrap_or(0)
    }

    /// 2⁵⁸/√`square` for a square from 2⁵⁶ on, within three steps; a smaller one
    /// counts as the normalised number that it is.
    #[inline]
    pub(crate) fn inverse_58(&self) -> u32 {
        self.inverse >> (5u32.saturating_sub(self.shift / 2))
    }
}

/// The upper half of a product.
#[inline]
fn high(a: u32, b: u32) -> u32 {
    (u64::from(a).wrapping_mul(u64::from(b)) >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::Root;

    /// Squares of every length, their ends, and many between.
    fn squares() -> impl Iterator<Item = u64> {
        (0..64u32).flat_map(|bits| {
            let low = 1u64 << bits;
            (0..4000u64).map(move |i| low + (u128::from(low) * u128::from(i) / 4000) as u64)
        })
    }

    #[test]
    fn roots_are_within_their_bound() {
        let mut worst = 0.0f64;
        for square in squares().chain([u64::MAX, (1 << 56) - 1, 1 << 56]) {
            let exact = (square as f64).sqrt();
            let found = f64::from(Root::of(square).root());
            worst = worst.max(((found - exact).abs() - 1.0) / exact * 4_294_967_296.0);
        }
        assert!((5.0..=12.0).contains(&worst), "{worst}");
        assert_eq!(Root::of(0).root(), 0);
        assert!(Root::of(1).root() <= 1);
    }

    #[test]
    fn inverses_are_within_their_bound() {
        let mut worst = 0.0f64;
        for square in squares().filter(|square| *square >= 1 << 56) {
            let exact = (58.0 - 0.5 * (square as f64).log2()).exp2();
            let found = f64::from(Root::of(square).inverse_58());
            worst = worst.max((found - exact).abs());
        }
        assert!((0.9..=3.0).contains(&worst), "{worst}");
    }
}
