//! The functions of micromath: short, and rough.

use micromath::F32 as Rough;

use super::Math;
use crate::arithmetic::Float;

/// micromath's functions, each kept where its error is bounded.
///
/// `exp` is within 2.4e-3 of its value. `ln` is off by up to 0.12 below 1 and
/// by 6.2e-5 above, so it is only asked above 1, and a series takes its place
/// near 1: what is left is 6e-5·n of a lobe beyond x = 1/16. `invsqrt` is off by 3.5 %, which two steps of Newton's method bring
/// to 5e-6. `arithmetic::math::micromath::tests`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Approximate;

/// Single precision with micromath's functions: a measured point of the trade
/// of speed for accuracy. Shares are within 0.4 % of the exact ones and 2e-5
/// of the peak.
pub type Micromath = Float<Approximate>;

impl Math for Approximate {
    const NAME: &'static str = "micromath";

    #[inline]
    fn exp(y: f32) -> f32 {
        // Its steps overflow for what is 0 in single precision.
        if y > -87.0 { Rough(y).exp().0 } else { 0.0 }
    }

    #[inline]
    fn ln_one_minus(x: f32) -> f32 {
        if x < 1.0 / 16.0 {
            // Horner's scheme of x + x²/2 + …; the next term is 2e-7 of it.
            let series = [1.0 / 5.0, 1.0 / 4.0, 1.0 / 3.0, 1.0 / 2.0, 1.0];
            -x * series.iter().fold(0.0, |sum, term| sum * x + term)
        } else {
            -Rough(1.0 / (1.0 - x)).ln().0
        }
    }

    #[inline]
    fn root(y: f32) -> f32 {
        if y <= 0.0 {
            return 0.0;
        }
        if y.is_nan() {
            // Its steps overflow for some of these.
            return y;
        }
        let newton = |inverse: f32| inverse * (1.5 - 0.5 * y * inverse * inverse);
        y * newton(newton(Rough(y).invsqrt().0))
    }

    #[inline]
    fn power(cosine: f32, exponent: f32) -> f32 {
        Self::exp(-exponent * Rough(1.0 / cosine).ln().0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Approximate, Math, Rough};

    /// The greatest of an error over `count` even steps in (0, `end`).
    fn greatest(count: u32, end: f32, error: impl Fn(f32) -> f64) -> f64 {
        (1..count).fold(0.0, |worst, i| {
            error(end * i as f32 / count as f32).max(worst)
        })
    }

    fn is_about(found: f64, stated: f64) {
        assert!((0.85 * stated..=stated).contains(&found), "{found:e}");
    }

    #[test]
    fn what_is_taken_from_the_library() {
        let exp = |y: f32| (f64::from(Approximate::exp(-y)) / f64::from(-y).exp() - 1.0).abs();
        is_about(greatest(200_000, 20.0, exp), 2.4e-3);
        let below = |u: f32| (f64::from(Rough(u).ln().0) - f64::from(u).ln()).abs();
        is_about(greatest(100_000, 1.0, below), 0.12);
        let above = |u: f32| (f64::from(Rough(1.0 / u).ln().0) + f64::from(u).ln()).abs();
        is_about(greatest(100_000, 1.0, above), 6.2e-5);
        let inverse = |y: f32| (f64::from(Rough(y).invsqrt().0) * f64::from(y).sqrt() - 1.0).abs();
        is_about(greatest(400_000, 4.0, inverse), 3.5e-2);
    }

    #[test]
    fn what_is_made_of_it() {
        let root = |y: f32| (f64::from(Approximate::root(y)) / f64::from(y).sqrt() - 1.0).abs();
        let found = greatest(400_000, 4.0, root);
        assert!(found <= 5e-6, "{found:e}");
        let near = |x: f32| {
            let exact = f64::from(-x).ln_1p();
            (f64::from(Approximate::ln_one_minus(x)) / exact - 1.0).abs()
        };
        let found = greatest(100_000, 1.0 / 16.0, near);
        assert!(found <= 5e-7, "{found:e}");
    }
}
