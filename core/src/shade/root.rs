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
            // It fits, as the product below does: all mantissas are tested.
            inverse = improved(mantissa, inverse) as u32;
            round += 1;
        }
        Self {
            mantissa,
            inverse,
            shift,
        }
    }

    /// √x with 32 fraction bits, 1/√x with 31, and how often √x is halved for the root
    /// of 2⁻⁶⁴ · `square`; the first two within 12 and 8 of exact.
    #[inline]
    pub(crate) fn parts(&self) -> (u32, u32, u32) {
        let root = product(self.mantissa, self.inverse) as u32;
        (root, self.inverse, self.shift / 2)
    }

    /// √`square`, within 12 · 2⁻³² of its value and a step; of 0 it is 0.
    #[inline]
    pub(crate) fn root(&self) -> u32 {
        let (root, _, halvings) = self.parts();
        root.checked_shr(halvings).unwrap_or(0)
    }

    /// 2⁵⁸/√`square` for a square from 2⁵⁶ on, within three steps; a smaller one
    /// counts as the normalised number that it is.
    #[inline]
    pub(crate) fn inverse_58(&self) -> u32 {
        self.inverse >> (5u32.saturating_sub(self.shift / 2))
    }
}

/// A better 1/√x with 31 fraction bits, of x with 32.
#[inline]
fn improved(mantissa: u32, inverse: u32) -> u64 {
    let square = high(inverse, inverse);
    // 1 but for the error, with 30 fraction bits.
    let one = high(mantissa, square);
    product((3u32 << 30).wrapping_sub(one), inverse)
}

/// A product without its lower 31 bits.
#[inline]
fn product(a: u32, b: u32) -> u64 {
    u64::from(a).wrapping_mul(u64::from(b)) >> 31
}

/// The upper half of a product.
#[inline]
fn high(a: u32, b: u32) -> u32 {
    (u64::from(a).wrapping_mul(u64::from(b)) >> 32) as u32
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::{FIRST, Root, improved, product};

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

    /// Every mantissa, through all rounds: nothing has more than 32 bits.
    #[test]
    fn no_mantissa_takes_more_than_32_bits() {
        let greatest = |mantissas: core::ops::Range<u64>| {
            mantissas.fold((0, 0), |(most_inverse, most_root), mantissa| {
                let mantissa = mantissa as u32;
                let mut inverse = u32::from(FIRST[(mantissa >> 28) as usize - 4]) << 24;
                let mut most = most_inverse;
                for _ in 0..3 {
                    let wide = improved(mantissa, inverse);
                    most = most.max(wide);
                    inverse = wide as u32;
                }
                (most, most_root.max(product(mantissa, inverse)))
            })
        };
        let parts: Vec<_> = std::thread::scope(|scope| {
            let parts: Vec<_> = (4..16u64)
                .map(|cell| scope.spawn(move || greatest(cell << 28..(cell + 1) << 28)))
                .collect();
            parts.into_iter().map(|part| part.join().unwrap()).collect()
        });
        let inverse = parts.iter().map(|part| part.0).max();
        let root = parts.iter().map(|part| part.1).max();
        assert_eq!((inverse, root), (Some(0xFFFF_FFF7), Some(0xFFFF_FFFF)));
    }
}
