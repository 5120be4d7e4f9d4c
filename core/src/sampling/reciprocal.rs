//! 1/a, to multiply by.

use crate::table::integer::divide;

/// 1/a for an a from 1/2 on, as a mantissa of 32 bits and a shift; relative
/// error at most 2⁻³¹.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reciprocal {
    mantissa: u32,
    shift: u32,
}

impl Reciprocal {
    /// That of `a`, given with 32 fraction bits; the greatest number for 0.
    pub(super) const fn new(a: u64) -> Self {
        // a = normal · 2^−zeros with normal in [2⁶³, 2⁶⁴), so that the
        // mantissa is in (2³¹, 2³²].
        let zeros = a.leading_zeros() % 64;
        let mantissa = divide(1 << 95, (a as u128) << zeros);
        let most = u32::MAX as u128;
        Self {
            mantissa: if mantissa < most { mantissa } else { most } as u32,
            // 2⁹⁵/(a·2³²·2^zeros) · 2^−shift = 1/a.
            shift: 63 - zeros,
        }
    }

    /// value/a; below 2⁶⁴ for values below 2⁶³.
    #[inline]
    pub(super) fn of(self, value: u64) -> u64 {
        ((u128::from(value) * u128::from(self.mantissa)) >> (self.shift % 64)) as u64
    }
}
