//! Cosine and sine of a share of a whole turn.

use core::f32::consts::FRAC_PI_2;

use super::logarithm::times;

/// cos 2πu and sin 2πu for `u` in [0, 1) with 32 fraction bits; the results
/// have 31. Error at most 2⁻³⁰; `sampling::turn::tests`.
#[inline]
pub(super) fn fixed(u: u32) -> [i64; 2] {
    // π/2 with 31 fraction bits.
    const QUARTER: u64 = 3_373_259_426;
    let part = u << 2;
    // Within an eighth of a turn both series are short.
    let far = part > 1 << 31;
    let near = if far { part.wrapping_neg() } else { part };
    let theta = (u64::from(near) * QUARTER) << 1;
    let square = times(theta, theta);
    let series = |divisors: [u64; 6]| {
        divisors.iter().rev().fold(u64::MAX, |sum, divisor| {
            u64::MAX - times(times(square, u64::MAX / divisor), sum)
        })
    };
    let rounded = |value: u64| (((value >> 32) + 1) >> 1) as i64;
    let sine = rounded(times(theta, series([6, 20, 42, 72, 110, 156])));
    let cosine = rounded(series([2, 12, 30, 56, 90, 132]));
    turned(u >> 30, far, [cosine, sine])
}

/// As [`fixed`], in single precision. Error at most 2e-7;
/// `sampling::turn::tests`. A u outside [0, 1) gets numbers from −1 to 1, one
/// that is not a number gets such.
#[inline]
pub(super) fn single(u: f32) -> [f32; 2] {
    let turns = 4.0 * u;
    // The conversion saturates.
    let quarter = turns as u32;
    let part = (turns - quarter as f32).clamp(0.0, 1.0);
    let far = part > 0.5;
    let theta = FRAC_PI_2 * if far { 1.0 - part } else { part };
    let square = theta * theta;
    let sine = theta * series(square, [6.0, 20.0, 42.0, 72.0]);
    let cosine = series(square, [2.0, 12.0, 30.0, 56.0]);
    turned(quarter, far, [cosine, sine])
}

/// 1 − x/d₀(1 − x/d₁(…)).
#[inline]
fn series(square: f32, divisors: [f32; 4]) -> f32 {
    let mut sum = 1.0;
    for divisor in divisors.iter().rev() {
        sum = 1.0 - square / divisor * sum;
    }
    sum
}

/// Cosine and sine in any quarter, from those of what lies between the
/// nearer end of the quarter and the angle.
#[inline]
fn turned<T: Copy + core::ops::Neg<Output = T>>(
    quarter: u32,
    far: bool,
    [cosine, sine]: [T; 2],
) -> [T; 2] {
    let [cosine, sine] = if far { [sine, cosine] } else { [cosine, sine] };
    match quarter % 4 {
        0 => [cosine, sine],
        1 => [-sine, cosine],
        2 => [-cosine, -sine],
        _ => [sine, -cosine],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_agree_with_f64() {
        let (mut integers, mut floats) = (0.0f64, 0.0f64);
        for i in 0..=200_000u32 {
            let u = i.wrapping_mul(42_949) & !0xFF;
            let (sine, cosine) =
                (core::f64::consts::TAU * f64::from(u) / 4_294_967_296.0).sin_cos();
            let [c, s] = fixed(u).map(|value| value as f64 / 2_147_483_648.0);
            integers = integers.max((c - cosine).abs()).max((s - sine).abs());
            let [c, s] = single(u as f32 / 4_294_967_296.0).map(f64::from);
            floats = floats.max((c - cosine).abs()).max((s - sine).abs());
        }
        assert!(integers <= 0.5f64.powi(30), "{integers:e}");
        assert!(floats <= 2e-7, "{floats:e}");
    }
}
