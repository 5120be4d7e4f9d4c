//! An exponential in 64-bit integers, for the loop.

use super::logarithm::{LN_2, LOGARITHM_BITS, times};

/// Terms of the series: ln 2¹⁴/14! is 7e-14.
const TERMS: usize = 13;

/// 1 − e^(−y) with 64 fraction bits for a `y` with 58, at most 64.
///
/// Error at most 2⁻⁴² of it + 2⁻⁶²; `sampling::exponential::tests`.
#[inline]
pub(super) fn one_minus_exp_neg(y: u64) -> u64 {
    let halvings = y / LN_2;
    let rest = (y % LN_2) << (64 - LOGARITHM_BITS);
    // Horner: r(1 − r/2(1 − r/3(…))).
    let mut sum = u64::MAX;
    for divisor in (2..=TERMS as u64).rev() {
        sum = u64::MAX - times(times(rest, u64::MAX / divisor), sum);
    }
    let fallen = times(rest, sum);
    match halvings {
        0 => fallen,
        1..=63 => (u64::MAX << (64 - halvings)) + (fallen >> halvings),
        _ => u64::MAX,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_agrees_with_f64() {
        let one = (1u64 << LOGARITHM_BITS) as f64;
        let mut greatest = 0.0f64;
        let mut y = 1e-9;
        while y < 63.0 {
            let fixed = (y * one) as u64;
            let found = one_minus_exp_neg(fixed) as f64 / 18446744073709551616.0;
            let exact = -(-(fixed as f64 / one)).exp_m1();
            greatest = greatest.max(((found - exact).abs() - 0.5f64.powi(62)) / exact);
            y *= 1.001;
        }
        assert!(greatest <= 0.5f64.powi(42), "{greatest:e}");
        assert!(greatest > 0.5f64.powi(44), "{greatest:e}");
        assert_eq!(one_minus_exp_neg(0), 0);
        assert_eq!(one_minus_exp_neg(u64::MAX), u64::MAX);
    }
}
