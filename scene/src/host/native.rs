//! libm's functions as a desktop computes them quickly: the same bits.

use microbrdf::arithmetic::{Libm, Math};

/// The functions of [`Libm`], to the last bit, in instructions that a compiler
/// can give to several pixels at once: the processor's root, and exponential and
/// logarithm without a branch. For pictures, on hosts with `std`.
///
/// They follow libm's own steps, so that every rounding is the same; where libm
/// takes a shorter way, both are computed and one is chosen. The tests compare one
/// of thirteen arguments that a lobe or a profile can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Native;

impl Math for Native {
    const NAME: &'static str = Libm::NAME;

    #[inline(always)]
    fn exp(y: f32) -> f32 {
        exp(y)
    }

    #[inline(always)]
    fn ln_one_minus(x: f32) -> f32 {
        ln_one_minus(x)
    }

    // Correctly rounded, as libm's is.
    #[inline(always)]
    fn root(y: f32) -> f32 {
        y.sqrt()
    }

    #[inline]
    fn power(cosine: f32, exponent: f32) -> f32 {
        Libm::power(cosine, exponent)
    }
}

/// ln 2 in two parts, of which the first has few bits: its product with a small
/// integer is exact.
const EXP_LN2: [f32; 2] = [f32::from_bits(0x3f31_7200), f32::from_bits(0x35bf_be8e)];
/// 1/ln 2.
const INVERSE_LN2: f32 = f32::from_bits(0x3fb8_aa3b);
/// Coefficients of x · coth(x/2) − 2 over x².
const EXP_SERIES: [f32; 2] = [f32::from_bits(0x3e2a_aa8f), f32::from_bits(0xbb35_5215)];
/// Arguments from here on are told apart from 0, are reduced by ln 2 once, and
/// by a multiple of it: 2⁻¹⁴, ln 2/2 and 3/2 ln 2, as libm rounds them.
const EXP_PLAIN: f32 = f32::from_bits(0x3900_0000);
const EXP_ONCE: f32 = f32::from_bits(0x3eb1_7218);
const EXP_OFTEN: f32 = f32::from_bits(0x3f85_1592);
/// Single precision has steps of 1 here.
const WHOLE: f32 = 12_582_912.0;
/// Below this eʸ is 0.
const EXP_LEAST: f32 = -f32::from_bits(0x42cf_f1b4);

/// eʸ.
#[inline(always)]
fn exp(y: f32) -> f32 {
    // Beyond these it is 0 and infinite, and the steps would leave their types.
    let within = y.clamp(-104.0, 89.0);
    let magnitude = within.abs();
    let once = if within < 0.0 { -1 } else { 1 };
    // Rounded to the nearest by the sum's last bit, then towards 0. (Conversion to
    // an integer that saturates is no instruction, and keeps vectors apart.)
    let nearest = INVERSE_LN2 * within + 0.5f32.copysign(within);
    let sum = nearest + WHOLE;
    let beyond = (sum - WHOLE).abs() > nearest.abs();
    let nearest = sum.to_bits().wrapping_sub(WHOLE.to_bits()) as i32;
    let nearest = nearest - if beyond { once } else { 0 };
    let k = if magnitude > EXP_OFTEN {
        nearest
    } else if magnitude > EXP_ONCE {
        once
    } else {
        0
    };
    let [high, low] = [within - k as f32 * EXP_LN2[0], k as f32 * EXP_LN2[1]];
    let x = high - low;
    let square = x * x;
    let c = x - square * (EXP_SERIES[0] + square * EXP_SERIES[1]);
    let reduced = 1.0 + (x * c / (2.0 - c) - low + high);
    // In two steps, of which only the second may round.
    let half = k >> 1;
    let scaled = reduced * power_of_two(half) * power_of_two(k - half);
    let near = if magnitude > EXP_PLAIN {
        scaled
    } else {
        1.0 + y
    };
    let found = if y < EXP_LEAST { 0.0 } else { near };
    if y.is_nan() { y } else { found }
}

/// 2ᵏ for k within its type's normal range.
#[inline(always)]
fn power_of_two(k: i32) -> f32 {
    f32::from_bits(((k + 127) as u32) << 23)
}

/// ln 2 in two parts, as libm's logarithm has it.
const LN_LN2: [f32; 2] = [f32::from_bits(0x3f31_7180), f32::from_bits(0x3717_f7d1)];
/// Coefficients of (ln(1 + s) − ln(1 − s))/s − 2 over even powers of s.
const LN_SERIES: [f32; 4] = [
    f32::from_bits(0x3f2a_aaaa),
    f32::from_bits(0x3ecc_ce13),
    f32::from_bits(0x3e91_e9ee),
    f32::from_bits(0x3e78_9e26),
];
/// √½ as libm rounds it, and how far below 1 it is in bits.
const LN_LEFT: u32 = 0x3f35_04f3;
const LN_SHIFT: u32 = 0x3f80_0000 - LN_LEFT;
/// 2⁻²⁴, below which ln(1 − x) is −x, and about 1 − √½, to which nothing is
/// reduced.
const LN_PLAIN: f32 = f32::from_bits(0x3380_0000);
const LN_NEAR: f32 = f32::from_bits(0x3e95_f619);

/// ln(1 − x) for 0 ≤ x < 1; for other x any number.
#[inline(always)]
fn ln_one_minus(x: f32) -> f32 {
    let y = -x;
    let u = 1.0 + y;
    // 1 − x = 2ᵏ · (1 + f), and what u lost of it.
    let shifted = u.to_bits().wrapping_add(LN_SHIFT);
    let near = x <= LN_NEAR;
    let k = if near {
        0
    } else {
        (shifted >> 23) as i32 - 0x7f
    };
    let lost = if near { 0.0 } else { (y - (u - 1.0)) / u };
    let reduced = f32::from_bits((shifted & 0x007f_ffff).wrapping_add(LN_LEFT)) - 1.0;
    let f = if near { y } else { reduced };

    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let odd = w * (LN_SERIES[1] + w * LN_SERIES[3]);
    let even = z * (LN_SERIES[0] + w * LN_SERIES[2]);
    let half_square = 0.5 * f * f;
    let k = k as f32;
    let found =
        s * (half_square + (even + odd)) + (k * LN_LN2[1] + lost) - half_square + f + k * LN_LN2[0];
    if x < LN_PLAIN { y } else { found }
}

#[cfg(test)]
mod tests {
    use microbrdf::arithmetic::{Libm, Math};
    use rayon::prelude::*;

    use super::Native;

    /// All numbers were compared when this was written (two minutes); each time one
    /// of so many is.
    const EVERY: u32 = 13;

    /// Both give the same bits for numbers from `first` to `last`.
    fn agree(first: f32, last: f32, one: fn(f32) -> f32, other: fn(f32) -> f32) {
        let [first, last] = [first, last].map(f32::to_bits);
        let differ = (0..(last - first) / EVERY + 1)
            .into_par_iter()
            .find_any(|i| {
                let number = f32::from_bits(first + i * EVERY);
                one(number).to_bits() != other(number).to_bits()
            });
        assert_eq!(differ.map(|i| f32::from_bits(first + i * EVERY)), None);
    }

    #[test]
    fn the_exponential_is_libms() {
        agree(-0.0, -110.0, Native::exp, Libm::exp);
        agree(0.0, 90.0, Native::exp, Libm::exp);
        for y in [f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN] {
            assert_eq!(Native::exp(y), Libm::exp(y));
        }
        assert!(Native::exp(f32::NAN).is_nan());
    }

    #[test]
    fn the_logarithm_is_libms() {
        agree(
            0.0,
            1.0f32.next_down(),
            Native::ln_one_minus,
            Libm::ln_one_minus,
        );
    }

    #[test]
    fn the_root_is_libms() {
        agree(0.0, 4.0, Native::root, Libm::root);
        assert_eq!(Native::root(f32::INFINITY), f32::INFINITY);
        assert!(Native::root(-1.0).is_nan() && Native::root(f32::NAN).is_nan());
    }
}
