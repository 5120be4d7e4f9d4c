//! Logarithm, exponential and power in integers, for building tables.
//!
//! Everything here is a `const fn` over 64-bit fractions, so that a table in
//! flash, one filled at start-up and one on the host hold the same entries.
//! It is exact to about 2⁻⁶⁰ and takes its time: no shading path calls it.

/// ln 2 with 64 fraction bits.
pub(crate) const LN_2: u128 = 0xB172_17F7_D1CF_79AC;
/// 1.0 with 64 fraction bits.
pub(crate) const ONE: u128 = 1 << 64;
/// 1/π with 64 fraction bits.
pub(crate) const INVERSE_PI: u128 = 0x517C_C1B7_2722_0A95;

/// −ln(1 − x), `x` in [0, 1) with 64 fraction bits; the result has 64 too.
///
/// Works on x, not on 1 − x, so that a small x keeps its digits. Error at
/// most 2⁻⁵⁹; `table::integer::tests`.
pub(crate) const fn neg_ln_one_minus(x: u64) -> u128 {
    if x == 0 {
        return 0;
    }
    // 1 − x = 2^−halvings · w with w in [1/2, 1).
    let mut w = ONE - x as u128;
    let mut halvings = 0;
    while w < ONE / 2 {
        w <<= 1;
        halvings += 1;
    }
    // −ln w = 2 artanh((1 − w)/(1 + w)).
    let s = divide((ONE - w) << 64, ONE + w);
    let square = (s * s) >> 64;
    let mut term = s;
    let mut sum = 0;
    let mut odd = 1;
    while term != 0 {
        sum += divide(term, odd);
        term = (term * square) >> 64;
        odd += 2;
    }
    2 * sum + halvings * LN_2
}

/// e^−y, `y` ≥ 0 with 64 fraction bits; the result in [0, 1] has 64 too.
///
/// Error at most 2⁻⁶⁰; `table::integer::tests`.
pub(crate) const fn exp_neg(y: u128) -> u128 {
    let halvings = y / LN_2;
    if halvings >= 64 {
        return 0;
    }
    let rest = y % LN_2;
    // Horner's scheme of the Taylor series; 0.7²⁰/20! < 2⁻⁷¹.
    let mut sum = ONE;
    let mut i = 20;
    while i > 0 {
        sum = ONE - divide((rest * sum) >> 64, i);
        i -= 1;
    }
    sum >> halvings
}

/// `factor · y`, `factor` with 32 fraction bits and `y` with 64.
///
/// Saturates where the product would pass 2⁶³: its e^− is 0 by far.
pub(crate) const fn times(factor: u64, y: u128) -> u128 {
    let whole = y >> 64;
    if whole >= 1 << 31 {
        return u128::MAX;
    }
    ((whole * factor as u128) << 32) + (((y & (ONE - 1)) * factor as u128) >> 32)
}

/// (1 − x)ⁿ, `x` in [0, 1) with 64 fraction bits, `n` with 32; 64 in the result.
///
/// Error at most 2⁻³³ for n ≤ 2²⁷, 2⁻⁵⁰ for n ≤ 2⁸; `table::integer::tests`.
pub(crate) const fn power_of_one_minus(x: u64, n: u64) -> u128 {
    exp_neg(times(n, neg_ln_one_minus(x)))
}

/// a / b, and 0 for b = 0, which no caller passes: a division without a panic
/// that the optimiser would have to disprove.
pub(crate) const fn divide(a: u128, b: u128) -> u128 {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// Rounds a number with 64 fraction bits to one with `bits`.
pub(crate) const fn round_to(value: u128, bits: u32) -> u32 {
    let drop = 64 - bits;
    ((value + (1 << (drop - 1))) >> drop) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: f64 = 18446744073709551616.0;

    fn close(actual: u128, expected: f64, tolerance: f64) {
        let error = (actual as f64 / UNIT - expected).abs();
        assert!(error <= tolerance, "{actual:#x} is off by {error:e}");
    }

    #[test]
    fn logarithm_agrees_with_f64() {
        for i in 0..64 {
            let x = u64::MAX >> i;
            let expected = if i == 0 {
                64.0 * f64::ln(2.0)
            } else {
                -f64::ln_1p(-(0.5f64.powi(i)))
            };
            close(neg_ln_one_minus(x), expected, 1e-14);
        }
    }

    #[test]
    fn exponential_agrees_with_f64() {
        for i in 0..400 {
            let y = f64::from(i) * 0.11;
            close(exp_neg((y * UNIT) as u128), (-y).exp(), 2e-15);
        }
    }

    #[test]
    fn power_keeps_its_digits_for_large_exponents() {
        for (n, tolerance) in [(1.0, 1e-15), (20.0, 1e-14), (5e3, 1e-13), (1e8, 1e-10)] {
            for tau in [0.0, 0.1, 0.5, 0.9] {
                let x = ((tau / n) * UNIT) as u64;
                let expected = (n * f64::ln_1p(-(x as f64 / UNIT))).exp();
                close(
                    power_of_one_minus(x, (n * 4294967296.0) as u64),
                    expected,
                    tolerance,
                );
            }
        }
    }
}
