//! The steps of a model for eight pixels.
//!
//! A decision is taken for all of them: where a step of the core ends early, it
//! does so only if that is right for each. [`Lit`](super::geometry::Lit) sees to
//! those that are not lit.

use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic, Math};
use microbrdf::geometry::Direction;
use microbrdf::shade::{LINEAR_ONE, Linear};
use microbrdf::table::{CosineCurve, ProfileCurve, SquareCurve};
use wide::f32x8;

use super::lanes::{Lanes, One, WIDTH, one};
use crate::host::Native;

/// Single precision, eight numbers at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide;

/// Whether something holds for a pixel.
#[inline(always)]
fn any(holds: impl Fn(usize) -> bool) -> bool {
    (0..WIDTH).fold(false, |any, i| any | holds(i))
}

/// Three numbers for each pixel.
#[inline(always)]
fn colours(step: impl Fn(usize) -> Rgb<f32>) -> Rgb<Lanes> {
    let mut found = Rgb::grey(Lanes::default());
    for i in 0..WIDTH {
        let colour = step(i);
        found.r.0[i] = colour.r;
        found.g.0[i] = colour.g;
        found.b.0[i] = colour.b;
    }
    found
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

    const COSINE_ZERO: Lanes = Lanes::all(0.0);
    const ZERO: Lanes = Lanes::all(0.0);
    const ONE: Lanes = Lanes::all(1.0);

    #[inline(always)]
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> Lanes {
        Lanes::of(|i| One::dot(&one(a, i), &one(b, i)))
    }
    #[inline(always)]
    fn upright(z: Lanes) -> Lanes {
        z
    }
    #[inline(always)]
    fn sum(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::sum(a.0[i], b.0[i]))
    }
    #[inline(always)]
    fn difference(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::difference(a.0[i], b.0[i]))
    }
    #[inline(always)]
    fn height(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::height(a.0[i], b.0[i]))
    }
    #[inline(always)]
    fn tangential(n: Lanes, l: Lanes, v: Lanes, cosines: (Lanes, Lanes)) -> Lanes {
        Lanes::of(|i| One::tangential(n.0[i], l.0[i], v.0[i], (cosines.0.0[i], cosines.1.0[i])))
    }
    #[inline(always)]
    fn square<const N: usize>(offsets: [Lanes; N]) -> Lanes {
        Lanes::of(|i| One::square(offsets.map(|offset| offset.0[i])))
    }
    #[inline(always)]
    fn half(square: Lanes) -> Lanes {
        Lanes::of(|i| One::half(square.0[i]))
    }

    /// For one pixel at least.
    #[inline(always)]
    fn above_horizon(n_dot_l: Lanes, n_dot_v: Lanes) -> bool {
        any(|i| One::above_horizon(n_dot_l.0[i], n_dot_v.0[i]))
    }
    /// For one pixel at least.
    #[inline(always)]
    fn lit(n_dot_l: Lanes, n_dot_v: Lanes) -> bool {
        any(|i| One::lit(n_dot_l.0[i], n_dot_v.0[i]))
    }
    #[inline(always)]
    fn larger(n_dot_l: Lanes, n_dot_v: Lanes) -> Lanes {
        Lanes::of(|i| One::larger(n_dot_l.0[i], n_dot_v.0[i]))
    }
    #[inline(always)]
    fn within(separation: Lanes, limit: Lanes) -> Lanes {
        Lanes::of(|i| One::within(separation.0[i], limit.0[i]))
    }
    /// A pixel's directions are numbers, or it is not shown.
    #[inline(always)]
    fn is_number(_: Lanes) -> bool {
        true
    }

    // `One::power` leaves out what it does not need, which eight at a time can't.
    // A loop, since a closure of that size would be called.
    #[inline(always)]
    fn power(n: &f32, x: Lanes) -> Lanes {
        // Beyond this e^(n·ln(1 − x)) ≤ e^(−n·x) is 0 in single precision.
        const END: f32 = 105.0;
        if !any(|i| (x.0[i] < 1.0) & (n * x.0[i] < END)) {
            return Self::ZERO;
        }
        let mut powers = [0.0; WIDTH];
        for (power, x) in powers.iter_mut().zip(x.0) {
            let within = Native::exp(n * Native::ln_one_minus(x));
            *power = if x < 1.0 { within } else { 0.0 };
        }
        Lanes(powers)
    }
    #[inline(always)]
    fn profile(s: &f32, m_squared: Lanes) -> Lanes {
        Lanes::of(|i| One::profile(s, m_squared.0[i]))
    }
    #[inline(always)]
    fn free_profile(curve: &ProfileCurve, m_squared: Lanes) -> Lanes {
        Lanes::of(|i| One::free_profile(curve, m_squared.0[i]))
    }
    #[inline(always)]
    fn square_profile(curve: &SquareCurve, m_squared: Lanes) -> Lanes {
        Lanes::of(|i| One::square_profile(curve, m_squared.0[i]))
    }
    #[inline(always)]
    fn cos_theta_prime(m_squared: Lanes, (a, b): (Lanes, Lanes)) -> Lanes {
        Lanes::of(|i| One::cos_theta_prime(m_squared.0[i], (a.0[i], b.0[i])))
    }
    #[inline(always)]
    fn cosine_power(exponent: &f32, cosine: Lanes) -> Lanes {
        Lanes::of(|i| One::cosine_power(exponent, cosine.0[i]))
    }

    /// Where the core has none it is 1, which changes no bit.
    #[inline(always)]
    fn ratio(a: Lanes, b: Lanes) -> Option<Lanes> {
        Some(Lanes::of(|i| One::ratio(a.0[i], b.0[i]).unwrap_or(1.0)))
    }
    #[inline(always)]
    fn attenuate(share: Lanes, ratio: Lanes) -> Lanes {
        Lanes::of(|i| One::attenuate(share.0[i], ratio.0[i]))
    }
    #[inline(always)]
    fn foreshorten(share: Lanes, cosine: Lanes) -> Lanes {
        Lanes::of(|i| One::foreshorten(share.0[i], cosine.0[i]))
    }
    #[inline(always)]
    fn curve(curve: &CosineCurve, cosine: Lanes) -> Rgb<Lanes> {
        colours(|i| One::curve(curve, cosine.0[i]))
    }
    #[inline(always)]
    fn product(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::product(a.0[i], b.0[i]))
    }
    #[inline(always)]
    fn total(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::total(a.0[i], b.0[i]))
    }

    #[inline(always)]
    fn radiance(peak: f32, share: Lanes) -> Lanes {
        Lanes::of(|i| One::radiance(peak, share.0[i]))
    }
    #[inline(always)]
    fn add_radiances(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::add_radiances(a.0[i], b.0[i]))
    }
    #[inline(always)]
    fn value(peak: f32, share: Lanes) -> Lanes {
        Lanes::of(|i| One::value(peak, share.0[i]))
    }
    #[inline(always)]
    fn value_over(peak: f32, share: Lanes, cosine: Lanes) -> Lanes {
        Lanes::of(|i| One::value_over(peak, share.0[i], cosine.0[i]))
    }
    #[inline(always)]
    fn add_values(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::add_values(a.0[i], b.0[i]))
    }

    #[inline(always)]
    fn expose(gain: f32, share: Lanes) -> Lanes {
        Lanes::of(|i| One::expose(gain, share.0[i]))
    }
    #[inline(always)]
    fn add_light(a: Lanes, b: Lanes) -> Lanes {
        Lanes::of(|i| One::add_light(a.0[i], b.0[i]))
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
    let codes = |lanes: &Lanes| {
        let steps = Lanes::of(|i| {
            let light = lanes.0[i];
            let bounded = if light > 0.0 { light } else { 0.0 };
            let bounded = if bounded < 1.0 { bounded } else { 1.0 };
            bounded * LINEAR_ONE as f32 + 0.5
        });
        f32x8::from(steps.0).fast_trunc_int().to_array()
    };
    let [r, g, b] = [codes(&light.r), codes(&light.g), codes(&light.b)];
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
