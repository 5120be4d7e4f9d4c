//! Single precision.

use core::marker::PhantomData;

use super::Arithmetic;
use super::math::{Libm, Math};
use crate::colour::Rgb;
use crate::geometry::Direction;
use crate::shade::{LINEAR_ONE, Linear};
use crate::table::{CosineCurve, ProfileCurve, SquareCurve};

/// Single precision, the same bits on every core; `M` is where exponentials
/// and roots come from.
///
/// An input that is not a number makes a share of 0; every result is finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Float<M>(PhantomData<M>);

/// Single precision with libm's functions.
pub type F32 = Float<Libm>;

impl<M: Math> Arithmetic for Float<M> {
    const NAME: &'static str = M::NAME;

    type Component = f32;
    type Cosine = f32;
    type Offset = f32;
    type Separation = f32;
    type Versine = f32;
    type Unit = f32;
    type Ratio = f32;
    type Scale = f32;
    type Radiance = f32;
    type Value = f32;
    type Gain = f32;
    type Light = f32;
    /// The exponent n.
    type Power = f32;
    /// The sharpness s of e^(−s·m).
    type Profile = f32;
    /// 1 − p.
    type CosinePower = f32;

    const COSINE_ZERO: f32 = 0.0;
    const ZERO: f32 = 0.0;
    const ONE: f32 = 1.0;

    #[inline]
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> f32 {
        a.x * b.x + a.y * b.y + a.z * b.z
    }

    #[inline]
    fn sum(a: f32, b: f32) -> f32 {
        a + b
    }

    #[inline]
    fn difference(a: f32, b: f32) -> f32 {
        a - b
    }

    #[inline]
    fn upright(z: f32) -> f32 {
        z
    }

    #[inline]
    fn height(a: f32, b: f32) -> f32 {
        a - b
    }

    #[inline]
    fn tangential(n: f32, l: f32, v: f32, cosines: (f32, f32)) -> f32 {
        (l + v) - (cosines.0 + cosines.1) * n
    }

    #[inline]
    fn square<const N: usize>(offsets: [f32; N]) -> f32 {
        offsets
            .iter()
            .fold(0.0, |sum, offset| sum + offset * offset)
    }

    #[inline]
    fn half(square: f32) -> f32 {
        0.5 * square
    }

    #[inline]
    fn above_horizon(n_dot_l: f32, n_dot_v: f32) -> bool {
        let is_cosine = |cosine: f32| (0.0..=f32::MAX).contains(&cosine);
        is_cosine(n_dot_l) && is_cosine(n_dot_v)
    }

    #[inline]
    fn lit(n_dot_l: f32, n_dot_v: f32) -> bool {
        n_dot_l > 0.0 && Self::above_horizon(n_dot_l, n_dot_v)
    }

    #[inline]
    fn is_number(x: f32) -> bool {
        x <= f32::MAX
    }

    /// exp(n·log1p(−x)): 1 − x is never formed, which would cost n·3e-8.
    #[inline]
    fn power(n: &f32, x: f32) -> f32 {
        // False for what is not a number, too.
        if x < 1.0 {
            M::exp(n * M::ln_one_minus(x))
        } else {
            0.0
        }
    }

    #[inline]
    fn profile(s: &f32, m_squared: f32) -> f32 {
        finite(M::exp(-s * M::root(m_squared)))
    }

    #[inline]
    fn free_profile(curve: &ProfileCurve, m_squared: f32) -> f32 {
        if Self::is_number(m_squared) {
            curve.at_f32(M::root(m_squared))
        } else {
            0.0
        }
    }

    #[inline]
    fn square_profile(curve: &SquareCurve, m_squared: f32) -> f32 {
        if Self::is_number(m_squared) {
            curve.at_f32(m_squared)
        } else {
            0.0
        }
    }

    #[inline]
    fn cos_theta_prime(m_squared: f32, (a, b): (f32, f32)) -> f32 {
        M::root(0.25 * m_squared + 0.5 * (a * a + b * b))
    }

    #[inline]
    fn cosine_power(exponent: &f32, cosine: f32) -> f32 {
        if cosine > 0.0 {
            M::power(cosine, *exponent).min(1.0)
        } else {
            0.0
        }
    }

    #[inline]
    fn ratio(a: f32, b: f32) -> Option<f32> {
        if a <= 0.0 {
            // −0 included.
            Some(0.0)
        } else if a >= b {
            None
        } else {
            Some(a / b)
        }
    }

    #[inline]
    fn attenuate(share: f32, ratio: f32) -> f32 {
        share * ratio
    }

    #[inline]
    fn foreshorten(share: f32, cosine: f32) -> f32 {
        // False for what is not a number, too.
        if cosine > 0.0 {
            share * cosine.min(1.0)
        } else {
            0.0
        }
    }

    #[inline]
    fn curve(curve: &CosineCurve, cosine: f32) -> Rgb<f32> {
        curve.at_f32(cosine)
    }

    #[inline]
    fn product(a: f32, b: f32) -> f32 {
        a * b
    }

    #[inline]
    fn total(a: f32, b: f32) -> f32 {
        (a + b).min(1.0)
    }

    #[inline]
    fn radiance(peak: f32, share: f32) -> f32 {
        finite(peak * share)
    }

    #[inline]
    fn add_radiances(a: f32, b: f32) -> f32 {
        finite(a + b)
    }

    #[inline]
    fn value(peak: f32, share: f32) -> f32 {
        finite(peak * share)
    }

    #[inline]
    fn value_over(peak: f32, share: f32, cosine: f32) -> f32 {
        if share <= 0.0 {
            0.0
        } else if cosine > 0.0 {
            finite(peak * share / cosine)
        } else {
            f32::MAX
        }
    }

    #[inline]
    fn add_values(a: f32, b: f32) -> f32 {
        finite(a + b)
    }

    #[inline]
    fn expose(gain: f32, share: f32) -> f32 {
        gain * share
    }

    #[inline]
    fn add_light(a: f32, b: f32) -> f32 {
        a + b
    }

    #[inline]
    fn linear(light: Rgb<f32>) -> Linear {
        // The conversion saturates, and takes what is not a number to 0.
        let code = |light: f32| (light * LINEAR_ONE as f32 + 0.5) as u32;
        Linear::from_raw(code(light.r), code(light.g), code(light.b))
    }
}

/// The greatest finite number for infinity, 0 for what is not a number.
#[inline]
fn finite(value: f32) -> f32 {
    if value.is_nan() {
        0.0
    } else {
        value.min(f32::MAX)
    }
}
