//! The steps of a model for eight pixels.
//!
//! A decision is taken for all of them: where a step of the core ends early, it
//! does so only if that is right for each. [`Lit`](super::geometry::Lit) sees to
//! those that are not lit.

use ::wide::f32x8;
use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic, Math};
use microbrdf::geometry::Direction;
use microbrdf::shade::{LINEAR_ONE, Linear};
use microbrdf::table::{CosineCurve, ProfileCurve, SquareCurve};

use super::lanes::{Lanes, One, WIDTH, Which};
use crate::host::Native;

/// Single precision, eight numbers at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide;

/// Three numbers for each pixel.
#[inline(always)]
fn colours(cosines: Lanes, step: impl Fn(f32) -> Rgb<f32>) -> Rgb<Lanes> {
    let mut found = [[0.0; WIDTH]; 3];
    for (i, cosine) in cosines.array().into_iter().enumerate() {
        let colour = step(cosine).to_array();
        for (lanes, channel) in found.iter_mut().zip(colour) {
            lanes[i] = channel;
        }
    }
    Rgb::from_array(found.map(|lanes| Lanes(f32x8::from(lanes))))
}

/// Pixels to which light comes and from which it is seen.
#[inline(always)]
pub(super) fn lit(n_dot_l: Lanes, n_dot_v: Lanes) -> Which {
    n_dot_l.above(Lanes::ZERO).and(upright(n_dot_l, n_dot_v))
}

#[inline(always)]
fn upright(n_dot_l: Lanes, n_dot_v: Lanes) -> Which {
    let is_cosine = |c: Lanes| c.at_least(Lanes::ZERO).and(c.at_most(Lanes::all(f32::MAX)));
    is_cosine(n_dot_l).and(is_cosine(n_dot_v))
}

impl Arithmetic for Wide {
    const NAME: &'static str = One::NAME;

    type Component = Lanes;
    type Cosine = Lanes;
    type Offset = Lanes;
    type Separation = Lanes;
    type Versine = Lanes;
    type Unit = Lanes;
    type Ratio = Lanes;
    type Scale = f32;
    type Radiance = Lanes;
    type Value = Lanes;
    type Gain = f32;
    type Light = Lanes;
    type Power = f32;
    type Profile = f32;
    type CosinePower = f32;

    const COSINE_ZERO: Lanes = Lanes::ZERO;
    const ZERO: Lanes = Lanes::ZERO;
    const ONE: Lanes = Lanes::ONE;

    #[inline(always)]
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> Lanes {
        a.x * b.x + a.y * b.y + a.z * b.z
    }
    #[inline(always)]
    fn upright(z: Lanes) -> Lanes {
        z
    }
    #[inline(always)]
    fn sum(a: Lanes, b: Lanes) -> Lanes {
        a + b
    }
    #[inline(always)]
    fn difference(a: Lanes, b: Lanes) -> Lanes {
        a - b
    }
    #[inline(always)]
    fn height(a: Lanes, b: Lanes) -> Lanes {
        a - b
    }
    #[inline(always)]
    fn tangential(n: Lanes, l: Lanes, v: Lanes, cosines: (Lanes, Lanes)) -> Lanes {
        (l + v) - (cosines.0 + cosines.1) * n
    }
    #[inline(always)]
    fn square<const N: usize>(offsets: [Lanes; N]) -> Lanes {
        (offsets.iter()).fold(Lanes::ZERO, |sum, offset| sum + *offset * *offset)
    }
    #[inline(always)]
    fn half(square: Lanes) -> Lanes {
        Lanes::all(0.5) * square
    }

    /// For one pixel at least.
    #[inline(always)]
    fn above_horizon(n_dot_l: Lanes, n_dot_v: Lanes) -> bool {
        upright(n_dot_l, n_dot_v).any()
    }
    /// For one pixel at least.
    #[inline(always)]
    fn lit(n_dot_l: Lanes, n_dot_v: Lanes) -> bool {
        lit(n_dot_l, n_dot_v).any()
    }
    #[inline(always)]
    fn larger(n_dot_l: Lanes, n_dot_v: Lanes) -> Lanes {
        n_dot_l.at_least(n_dot_v).choose(n_dot_l, n_dot_v)
    }
    #[inline(always)]
    fn within(separation: Lanes, limit: Lanes) -> Lanes {
        separation.at_most(limit).or_zero(Lanes::ONE)
    }
    /// A pixel's directions are numbers, or it is not shown.
    #[inline(always)]
    fn is_number(_: Lanes) -> bool {
        true
    }

    #[inline(always)]
    fn power(n: &f32, x: Lanes) -> Lanes {
        // Beyond this e^(n·ln(1 − x)) ≤ e^(−n·x) is 0 in single precision.
        const END: f32 = 105.0;
        let shown = x
            .below(Lanes::ONE)
            .and((Lanes::all(*n) * x).below(Lanes::all(END)));
        if !shown.any() {
            return Lanes::ZERO;
        }
        // A loop, since a closure of that size would be called.
        let mut powers = x.array();
        for power in &mut powers {
            *power = Native::exp(n * Native::ln_one_minus(*power));
        }
        x.below(Lanes::ONE).or_zero(Lanes(f32x8::from(powers)))
    }
    #[inline(always)]
    fn profile(s: &f32, m_squared: Lanes) -> Lanes {
        m_squared.map(|square| One::profile(s, square))
    }
    #[inline(always)]
    fn free_profile(curve: &ProfileCurve, m_squared: Lanes) -> Lanes {
        m_squared.map(|square| One::free_profile(curve, square))
    }
    #[inline(always)]
    fn square_profile(curve: &SquareCurve, m_squared: Lanes) -> Lanes {
        m_squared.map(|square| One::square_profile(curve, square))
    }
    #[inline(always)]
    fn cos_theta_prime(m_squared: Lanes, (a, b): (Lanes, Lanes)) -> Lanes {
        (Lanes::all(0.25) * m_squared + Lanes::all(0.5) * (a * a + b * b)).root()
    }
    #[inline(always)]
    fn cosine_power(exponent: &f32, cosine: Lanes) -> Lanes {
        cosine.map(|cosine| One::cosine_power(exponent, cosine))
    }

    /// Where the core has none it is 1, which changes no bit.
    #[inline(always)]
    fn ratio(a: Lanes, b: Lanes) -> Option<Lanes> {
        let below = a.at_least(b).choose(Lanes::ONE, a / b);
        Some(a.at_most(Lanes::ZERO).choose(Lanes::ZERO, below))
    }
    #[inline(always)]
    fn attenuate(share: Lanes, ratio: Lanes) -> Lanes {
        share * ratio
    }
    #[inline(always)]
    fn foreshorten(share: Lanes, cosine: Lanes) -> Lanes {
        let bounded = cosine.below(Lanes::ONE).choose(cosine, Lanes::ONE);
        cosine.above(Lanes::ZERO).or_zero(share * bounded)
    }
    #[inline(always)]
    fn curve(curve: &CosineCurve, cosine: Lanes) -> Rgb<Lanes> {
        colours(cosine, |cosine| One::curve(curve, cosine))
    }
    #[inline(always)]
    fn product(a: Lanes, b: Lanes) -> Lanes {
        a * b
    }
    #[inline(always)]
    fn total(a: Lanes, b: Lanes) -> Lanes {
        a.zip(b, One::total)
    }

    #[inline(always)]
    fn radiance(peak: f32, share: Lanes) -> Lanes {
        share.map(|share| One::radiance(peak, share))
    }
    #[inline(always)]
    fn add_radiances(a: Lanes, b: Lanes) -> Lanes {
        a.zip(b, One::add_radiances)
    }
    #[inline(always)]
    fn value(peak: f32, share: Lanes) -> Lanes {
        share.map(|share| One::value(peak, share))
    }
    #[inline(always)]
    fn value_over(peak: f32, share: Lanes, cosine: Lanes) -> Lanes {
        share.zip(cosine, |share, cosine| One::value_over(peak, share, cosine))
    }
    #[inline(always)]
    fn add_values(a: Lanes, b: Lanes) -> Lanes {
        a.zip(b, One::add_values)
    }

    #[inline(always)]
    fn expose(gain: f32, share: Lanes) -> Lanes {
        Lanes::all(gain) * share
    }
    #[inline(always)]
    fn add_light(a: Lanes, b: Lanes) -> Lanes {
        a + b
    }
    /// The first pixel; [`clamped`] has all.
    #[inline(always)]
    fn linear(light: Rgb<Lanes>) -> Linear {
        clamped(&light)[0]
    }
}

/// The clamped pixels, as the core's `linear` rounds each.
#[inline(always)]
pub(super) fn clamped(light: &Rgb<Lanes>) -> [Linear; WIDTH] {
    // Clamped before, so that the processor's conversion will do. What is not a
    // number is 0.
    let codes = |light: Lanes| {
        let bounded = light.above(Lanes::ZERO).or_zero(light);
        let bounded = bounded.below(Lanes::ONE).choose(bounded, Lanes::ONE);
        let steps = bounded * Lanes::all(LINEAR_ONE as f32) + Lanes::all(0.5);
        steps.0.fast_trunc_int().to_array()
    };
    let [r, g, b] = light.to_array().map(codes);
    std::array::from_fn(|i| Linear::from_raw(r[i] as u32, g[i] as u32, b[i] as u32))
}

#[cfg(test)]
mod tests {
    use microbrdf::Rgb;
    use microbrdf::arithmetic::Arithmetic;

    use super::{Lanes, One, Wide, clamped};

    #[test]
    fn eight_pixels_are_rounded_as_one_is() {
        let mut lights = vec![
            f32::NAN,
            f32::INFINITY,
            -f32::INFINITY,
            -0.0,
            -1e-9,
            1.0,
            1e9,
        ];
        lights.extend((0..4000).map(|i| i as f32 * 3e-4));
        lights.extend((0..4000).map(|i| 1.0 - i as f32 * 3e-8));
        lights.extend((0..4000).map(|i| i as f32 * 1.5e-8));
        for light in lights {
            let expected = One::linear(Rgb::grey(light));
            assert_eq!(
                clamped(&Rgb::grey(Lanes::all(light))),
                [expected; 8],
                "{light}"
            );
            assert_eq!(Wide::linear(Rgb::grey(Lanes::all(light))), expected);
        }
    }
}
