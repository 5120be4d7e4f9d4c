//! A logarithm in 64-bit integers, for the loop.

/// Fraction bits of the result.
pub(super) const LOGARITHM_BITS: u32 = 58;
/// ln 2 with those.
pub(super) const LN_2: u64 = 0xB172_17F7_D1CF_79AC >> (64 - LOGARITHM_BITS);
/// √½ with 64 fraction bits.
const ROOT_HALF: u64 = 0xB504_F333_F9DE_6484;
/// 1/3, 1/5 … 1/13 with 64 fraction bits.
const ODD: [u64; 6] = [
    u64::MAX / 3,
    u64::MAX / 5,
    u64::MAX / 7,
    u64::MAX / 9,
    u64::MAX / 11,
    u64::MAX / 13,
];

/// a·b, all with 64 fraction bits.
#[inline]
pub(super) fn times(a: u64, b: u64) -> u64 {
    ((u128::from(a) * u128::from(b)) >> 64) as u64
}

/// −ln(1 − x) with 58 fraction bits for an `x` in [0, 1) with 64.
///
/// Relative error at most 2⁻²⁸; `sampling::logarithm::tests`. A small x keeps
/// its digits.
#[inline]
pub(super) fn neg_ln_one_minus(x: u64) -> u64 {
    if x == 0 {
        return 0;
    }
    let w = x.wrapping_neg();
    let halvings = w.leading_zeros();
    let normal = w << (halvings % 64);
    let whole = u64::from(halvings) * LN_2;
    if normal >= ROOT_HALF {
        // (1 − w)/(1 + w).
        whole + artanh_twice(normal.wrapping_neg(), (normal >> 32) + (1 << 32))
    } else {
        // Twice w lies in [1, √2): (2w − 1)/(2w + 1).
        let above = (normal << 1) >> 1;
        whole + LN_2 - artanh_twice(above << 1, (normal >> 31) + (1 << 32))
    }
}

/// 2 artanh(a/b) with 58 fraction bits; a with 64, b in [1, 3) with 32;
/// a/b at most 0.1716.
#[inline]
fn artanh_twice(a: u64, b: u64) -> u64 {
    // As many digits of the quotient as the division of 64 bits gives.
    let zeros = a.leading_zeros();
    let Some(quotient) = (a << (zeros % 64)).checked_div(b) else {
        return 0;
    };
    // Now with 32 + zeros fraction bits; to 64.
    let s = if zeros <= 32 {
        quotient << (32 - zeros)
    } else {
        quotient >> (zeros - 32)
    };
    let square = times(s, s);
    let mut sum = 0;
    for inverse in ODD.iter().rev() {
        sum = times(square, sum + inverse);
    }
    (s + times(s, sum)) >> (63 - LOGARITHM_BITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_agrees_with_f64() {
        let mut greatest = 0.0f64;
        for i in 0..400_000u64 {
            let spread = i.wrapping_mul(0x9E37_79B9_7F4A_7C15);
            for x in [spread, spread >> (i % 60), !(spread >> (i % 40))] {
                let found = neg_ln_one_minus(x) as f64 / (1u64 << LOGARITHM_BITS) as f64;
                let unit = 18446744073709551616.0;
                let exact = if x >> 63 == 0 {
                    -(-(x as f64) / unit).ln_1p()
                } else {
                    -(x.wrapping_neg() as f64 / unit).ln()
                };
                if exact > 1e-9 {
                    greatest = greatest.max((found / exact - 1.0).abs());
                }
            }
        }
        assert!(greatest <= 0.5f64.powi(28), "{greatest:e}");
        assert!(greatest > 0.5f64.powi(33), "{greatest:e}");
    }
}
