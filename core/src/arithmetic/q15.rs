//! 16-bit directions, products of 32 bits.

use fixed::types::{I2F14, U1F31, U32F32, U64F64};

use super::short::{FACTOR, product_of_cosines, scale, scale_by_half};
use super::{Arithmetic, peak};
use crate::colour::Rgb;
use crate::geometry::Direction;
use crate::shade::Linear;
use crate::table::{
    CosineCurve, CosinePowerTable, ProfileCurve, ScaledTable, SquareCurve, reciprocal, root,
};

/// Fraction bits of a component.
const COMPONENT_BITS: u32 = 14;
/// Fraction bits of a cosine.
const COSINE_BITS: u32 = 30;
/// From a sum of products of components to a cosine.
const COSINE_SHIFT: u32 = COSINE_BITS - 2 * COMPONENT_BITS;

/// 16-bit fixed point: directions in `I2F14`, shares in `U1F31`, lobes in
/// tables of `KNOTS` knots.
///
/// For cores without a long multiply or a divider (Cortex-M0 and M0+): no
/// product on its way from two directions to linear light is wider than 32
/// bits, and nothing is divided. Cores that multiply to 64 bits or count
/// leading zeros at once do so, with the same bits. The versine is exact for the directions
/// given; coarse are only the directions themselves, which a picture shows at
/// grazing and in narrow lobes. Sums of components wrap only for directions
/// whose length is far from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q15<const KNOTS: usize = 129>;

/// K as a mantissa of 16 bits and a shift, within 2⁻¹⁶ of its value: 2⁻²⁴ to
/// 2³².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gain15 {
    /// In the upper half of the word.
    mantissa: u32,
    left: u32,
    right: u32,
    /// Greatest product that survives the shift to the left.
    limit: u32,
}

impl Gain15 {
    /// Bits by which a share has more than the light: 31 against 24.
    const EXCESS: u32 = 7;

    /// The gain K, any number that `U32F32` holds.
    #[must_use]
    pub const fn new(k: U32F32) -> Self {
        let bits = k.to_bits();
        let zeros = bits.leading_zeros();
        // K = mantissa · 2^(32 − zeros − 16).
        let mantissa = if zeros < 64 {
            rounded((bits << zeros >> 32) as u32)
        } else {
            0
        };
        // K < 2^(32 − zeros): from 31 fraction bits to the light's 24.
        let (up, down) = (32u32, Self::EXCESS + zeros);
        let left = up.saturating_sub(down);
        let right = down.saturating_sub(up);
        Self {
            // Below one step of the light.
            mantissa: if right < 32 { mantissa } else { 0 },
            left,
            right: right % 32,
            limit: u32::MAX >> left,
        }
    }
}

/// To 16 bits, but not beyond them.
const fn rounded(mantissa: u32) -> u32 {
    mantissa.saturating_add(1 << 15) & FACTOR
}

/// What constructors of models need.
impl<const KNOTS: usize> Q15<KNOTS> {
    /// The lobe of exponent `n`, given with 32 fraction bits.
    pub(crate) const fn stored_power(n: u64) -> ScaledTable<KNOTS> {
        ScaledTable::power(n)
    }

    /// The profile e^(−s·m), `s` given with 32 fraction bits.
    pub(crate) const fn stored_exponential(s: u64) -> ScaledTable<KNOTS> {
        ScaledTable::exponential(s)
    }

    /// A separation from one with 60 fraction bits, rounded down: separations
    /// of directions are multiples of its step.
    pub(crate) const fn separation(bits: u64) -> u32 {
        if bits == u64::MAX {
            u32::MAX
        } else {
            (bits >> (60 - 2 * COMPONENT_BITS)) as u32
        }
    }
}

/// Its components' bits.
#[cfg_attr(long_multiply, inline)]
#[cfg_attr(not(long_multiply), inline(always))]
fn components<const KNOTS: usize>(d: &Direction<Q15<KNOTS>>) -> [i32; 3] {
    [d.x, d.y, d.z].map(|component| i32::from(component.to_bits()))
}

/// 28 fraction bits; wraps for directions that are far too long.
#[cfg_attr(long_multiply, inline)]
#[cfg_attr(not(long_multiply), inline(always))]
fn sum_of_products(a: [i32; 3], b: [i32; 3]) -> i32 {
    let [x, y, z] = [0, 1, 2].map(|i: usize| a[i].wrapping_mul(b[i]));
    x.wrapping_add(y).wrapping_add(z)
}

/// N·L and N·V, that as N·(L + V) − N·L, which are the same bits: of V nothing
/// is kept then beside its sum with L.
#[cfg_attr(long_multiply, inline)]
#[cfg_attr(not(long_multiply), inline(always))]
fn products_by_sum<const KNOTS: usize>(
    n: &Direction<Q15<KNOTS>>,
    l: &Direction<Q15<KNOTS>>,
    v: &Direction<Q15<KNOTS>>,
) -> (i32, i32) {
    let (n, l, v) = (components(n), components(l), components(v));
    let both = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
    let n_dot_l = sum_of_products(n, l);
    let n_dot_v = sum_of_products(n, both).wrapping_sub(n_dot_l);
    (n_dot_l, n_dot_v)
}

/// |L + V|² − 4p(2 − |N|²), for 4p, with 28 fraction bits: sums of products of
/// components are exact, so that nothing cancels that was rounded. With
/// p = (N·L)(N·V) it is twice 1 − R·V, with p = ((N·L + N·V)/2)² it is m²; |N|²
/// makes good that N is rounded, which p alone would show as 4p times that. Off
/// by 2 · 2⁻²⁴ at most, by 6 · 2⁻²⁴ where 4p is rounded to 22 fraction bits, and by
/// 2e-4 of its value. Never negative: `tests`.
// Without a long multiply registers are few: what is inlined first is ordered
// as it stands here.
#[cfg_attr(long_multiply, inline)]
#[cfg_attr(not(long_multiply), inline(always))]
fn sum_without<const KNOTS: usize>(
    n: &Direction<Q15<KNOTS>>,
    l: &Direction<Q15<KNOTS>>,
    v: &Direction<Q15<KNOTS>>,
    four_p: i32,
) -> u32 {
    let sum = |a, b| Q15::<KNOTS>::sum(a, b);
    let square = Q15::<KNOTS>::square([sum(l.z, v.z), sum(l.y, v.y), sum(l.x, v.x)]);
    // |N|² − 1 is the lower half of |N|², 28 fraction bits; of p 14 are taken.
    let excess = i32::from(sum_of_products(components(n), components(n)) as i16);
    let rest = ((four_p >> 16) * excess) >> 12;
    let found = (square as i32).wrapping_sub(four_p).wrapping_add(rest);
    found.max(0) as u32
}

impl<const KNOTS: usize> Arithmetic for Q15<KNOTS> {
    const NAME: &'static str = "q15";

    type Component = I2F14;
    /// 30 fraction bits, so that the sum of three products is exact.
    type Cosine = i32;
    /// 28 fraction bits, exact.
    type Product = i32;
    /// 14 fraction bits.
    type Offset = i32;
    /// 28 fraction bits.
    type Separation = u32;
    /// 29 fraction bits.
    type Versine = u32;
    type Unit = U1F31;
    /// 16 fraction bits: below 1.
    type Ratio = u32;
    type Scale = U32F32;
    type Radiance = U32F32;
    type Value = U64F64;
    type Gain = Gain15;
    /// 24 fraction bits, saturating.
    type Light = u32;
    type Power = ScaledTable<KNOTS>;
    type Profile = ScaledTable<KNOTS>;
    type CosinePower = CosinePowerTable;

    const COSINE_ZERO: i32 = 0;
    const ZERO: U1F31 = U1F31::ZERO;
    const ONE: U1F31 = U1F31::ONE;

    #[inline]
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> i32 {
        sum_of_products(components(a), components(b)) << COSINE_SHIFT
    }

    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    fn products(n: &Direction<Self>, l: &Direction<Self>, v: &Direction<Self>) -> (i32, i32) {
        if cfg!(long_multiply) {
            let (n, l, v) = (components(n), components(l), components(v));
            (sum_of_products(n, l), sum_of_products(n, v))
        } else {
            products_by_sum(n, l, v)
        }
    }

    #[inline]
    fn cosine(product: i32) -> i32 {
        product << COSINE_SHIFT
    }

    #[inline]
    fn product_of(cosine: i32) -> i32 {
        cosine >> COSINE_SHIFT
    }

    #[inline]
    fn upright(z: I2F14) -> i32 {
        i32::from(z.to_bits()) << (COSINE_BITS - COMPONENT_BITS)
    }

    #[inline]
    fn sum(a: I2F14, b: I2F14) -> i32 {
        i32::from(a.to_bits()) + i32::from(b.to_bits())
    }

    #[inline]
    fn difference(a: I2F14, b: I2F14) -> i32 {
        i32::from(a.to_bits()) - i32::from(b.to_bits())
    }

    #[inline]
    fn height(a: i32, b: i32) -> i32 {
        const DROP: u32 = COSINE_BITS - COMPONENT_BITS;
        // Of each one's own steps: symmetric in both, to the bit.
        (a >> DROP) - (b >> DROP)
    }

    #[inline]
    fn square<const N: usize>(offsets: [i32; N]) -> u32 {
        offsets.iter().fold(0, |sum: u32, offset| {
            sum.wrapping_add(offset.wrapping_mul(*offset) as u32)
        })
    }

    #[inline]
    fn half(square: u32) -> u32 {
        square
    }

    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    fn world_versine(
        n: &Direction<Self>,
        l: &Direction<Self>,
        v: &Direction<Self>,
        (a, b): (i32, i32),
    ) -> u32 {
        // 28 fraction bits of 4p are 30 of p, of which 24 are formed.
        sum_without::<KNOTS>(n, l, v, product_of_cosines::<24>(a, b) << 6)
    }

    #[inline]
    fn world_separation(
        n: &Direction<Self>,
        l: &Direction<Self>,
        v: &Direction<Self>,
        (a, b): (i32, i32),
    ) -> u32 {
        // Of m² a root is taken, which shows its last bits.
        let height = a.wrapping_add(b);
        sum_without::<KNOTS>(n, l, v, product_of_cosines::<28>(height, height))
    }

    #[inline]
    fn above_horizon(n_dot_l: i32, n_dot_v: i32) -> bool {
        // Either sign bit.
        n_dot_l | n_dot_v >= 0
    }

    #[inline]
    fn lit(n_dot_l: i32, n_dot_v: i32) -> bool {
        // Either sign bit.
        n_dot_l.wrapping_sub(1) | n_dot_v >= 0
    }

    #[inline]
    fn is_number(_: u32) -> bool {
        true
    }

    #[inline]
    fn power(table: &ScaledTable<KNOTS>, x: u32) -> U1F31 {
        U1F31::from_bits(table.at(x))
    }

    #[inline]
    fn profile(table: &ScaledTable<KNOTS>, m_squared: u32) -> U1F31 {
        U1F31::from_bits(table.at(root::root(m_squared)))
    }

    #[inline]
    fn free_profile(curve: &ProfileCurve, m_squared: u32) -> U1F31 {
        U1F31::from_bits(curve.at_short(root::root(m_squared)))
    }

    #[inline]
    fn square_profile(curve: &SquareCurve, m_squared: u32) -> U1F31 {
        U1F31::from_bits(curve.at_short(m_squared))
    }

    /// The cosines are taken to 15 fraction bits.
    #[inline]
    fn cos_theta_prime(m_squared: u32, (a, b): (i32, i32)) -> i32 {
        // a² + b² with 30 fraction bits; twice it with the 28 of m².
        let twice = Self::square([a >> 15, b >> 15]) >> 1;
        // 2cosθ' with 29 fraction bits is cosθ' with 30.
        root::root(m_squared.wrapping_add(twice)) as i32
    }

    #[inline]
    fn cosine_power(table: &CosinePowerTable, cosine: i32) -> U1F31 {
        U1F31::from_bits(table.at(cosine))
    }

    #[inline]
    fn ratio(a: i32, b: i32) -> Option<u32> {
        if a >= b {
            None
        } else {
            Some(reciprocal::quotient(a as u32, b as u32))
        }
    }

    /// Truncates: off by less than 2⁻³¹.
    #[inline]
    fn attenuate(share: U1F31, ratio: u32) -> U1F31 {
        U1F31::from_bits(scale_by_half(share.to_bits(), ratio))
    }

    /// The cosine is taken to 15 fraction bits.
    #[inline]
    fn foreshorten(share: U1F31, cosine: i32) -> U1F31 {
        // 31 fraction bits.
        let cosine = (cosine as u32) << 1;
        U1F31::from_bits(scale(share.to_bits(), cosine) << 1)
    }

    #[inline]
    fn bounded(share: U1F31) -> U1F31 {
        share.min(U1F31::ONE)
    }

    #[inline]
    fn curve(curve: &CosineCurve, cosine: i32) -> Rgb<U1F31> {
        // 15 fraction bits, to 31.
        Rgb::from_array(curve.at_short(cosine.max(0) as u32))
            .map(|channel| U1F31::from_bits(channel << 16))
    }

    /// The curve is taken to 15 fraction bits: off by at most 2⁻¹⁵ of the
    /// share.
    #[inline]
    fn tint(share: U1F31, curve: &CosineCurve, cosine: i32) -> Rgb<U1F31> {
        let share = share.to_bits();
        Rgb::from_array(curve.at_short(cosine as u32))
            .map(|channel| U1F31::from_bits(scale(share, channel << 16) << 1))
    }

    /// The second factor is taken to 16 fraction bits: off by at most 2⁻¹⁶ of
    /// the first one.
    #[inline]
    fn product(a: U1F31, b: U1F31) -> U1F31 {
        let (a, b) = (a.to_bits(), b.to_bits() >> 15);
        let high = (a >> 16).wrapping_mul(b);
        let low = ((a & 0xFFFF) >> 1).wrapping_mul(b);
        U1F31::from_bits(high.wrapping_add(low >> 15))
    }

    #[inline]
    fn total(a: U1F31, b: U1F31) -> U1F31 {
        a.saturating_add(b).min(U1F31::ONE)
    }

    #[inline]
    fn radiance(peak: U32F32, share: U1F31) -> U32F32 {
        peak::radiance(peak, share)
    }

    #[inline]
    fn add_radiances(a: U32F32, b: U32F32) -> U32F32 {
        a.saturating_add(b)
    }

    #[inline]
    fn value(peak: U32F32, share: U1F31) -> U64F64 {
        peak::value(peak, share)
    }

    #[inline]
    fn value_over(peak: U32F32, share: U1F31, cosine: i32) -> U64F64 {
        peak::value_over(peak, share, cosine)
    }

    #[inline]
    fn add_values(a: U64F64, b: U64F64) -> U64F64 {
        a.saturating_add(b)
    }

    #[inline]
    fn expose(gain: Gain15, share: U1F31) -> u32 {
        let product = scale(share.to_bits(), gain.mantissa);
        if product > gain.limit {
            u32::MAX
        } else {
            (product << (gain.left % 32)) >> (gain.right % 32)
        }
    }

    #[inline]
    fn add_light(a: u32, b: u32) -> u32 {
        a.saturating_add(b)
    }

    #[inline]
    fn linear(light: Rgb<u32>) -> Linear {
        Linear::from_raw(light.r, light.g, light.b)
    }
}

#[cfg(test)]
mod tests {
    use super::{Arithmetic, I2F14, Q15, products_by_sum};
    use crate::geometry::{Direction, Geometry as _, World};

    type A = Q15;

    fn direction([x, y, z]: [i16; 3]) -> Direction<A> {
        let [x, y, z] = [x, y, z].map(I2F14::from_bits);
        Direction::new(x, y, z)
    }

    fn dot(a: [i16; 3], b: [i16; 3]) -> i128 {
        (0..3).map(|i| i128::from(a[i]) * i128::from(b[i])).sum()
    }

    /// |h|²·|N|² − 4(N·L)(N·V) over |N|², and |h|² − (N·h)²/|N|²: of any lengths,
    /// exact, in units of 2⁻²⁸.
    fn exact(n: [i16; 3], l: [i16; 3], v: [i16; 3]) -> [f64; 2] {
        let (a, b, nn) = (dot(n, l), dot(n, v), dot(n, n));
        let square = dot(l, l) + dot(v, v) + 2 * dot(l, v);
        [4 * a * b, (a + b) * (a + b)].map(|part| (square * nn - part) as f64 / nn as f64)
    }

    fn found(n: [i16; 3], l: [i16; 3], v: [i16; 3]) -> [u32; 2] {
        let world = World::<A>::new(direction(n), direction(l), direction(v));
        [world.versine(), world.separation()]
    }

    /// A number in (−1, 1).
    fn draw(state: &mut u64) -> f64 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn unit(c: [f64; 3]) -> [f64; 3] {
        let length = c.iter().map(|c| c * c).sum::<f64>().sqrt();
        c.map(|c| c / length)
    }

    /// Of a length within 2⁻¹⁴ of 1, rounded.
    fn rounded(c: [f64; 3], off: f64) -> [i16; 3] {
        c.map(|c| (c * (1.0 + off / 16_384.0) * 16_384.0).round() as i16)
    }

    /// Both are what integers of any width give: for directions anywhere, for
    /// those near the mirror direction, and for lengths that are off.
    #[test]
    fn world_space_loses_no_digits() {
        let mut state = 7;
        let (mut worst, mut exactly) = ([0.0f64; 2], 0);
        for i in 0..200_000 {
            let vector = |state: &mut u64| unit([draw(state), draw(state), draw(state)]);
            let (n, l) = (vector(&mut state), vector(&mut state));
            let cosine: f64 = (0..3).map(|i| n[i] * l[i]).sum();
            let near = 0.5f64.powi(i % 15);
            let aside = vector(&mut state);
            let v = unit([0, 1, 2].map(|i| 2.0 * cosine * n[i] - l[i] + near * aside[i]));
            let [n, l, v] = [n, l, v].map(|c| rounded(c, draw(&mut state)));
            if [n, l, v]
                .iter()
                .any(|c| (dot(*c, *c) - (1 << 28)).abs() > 1 << 15)
            {
                continue;
            }
            let (found, swapped) = (found(n, l, v), found(n, v, l));
            assert_eq!(found, swapped, "{n:?}, {l:?}, {v:?}");
            let pairs = found.into_iter().zip(exact(n, l, v));
            for ((found, exact), worst) in pairs.zip(&mut worst) {
                let off = (f64::from(found) - exact).abs() - exact * 2e-4;
                *worst = worst.max(off);
                exactly += u32::from(off <= 64.0);
            }
        }
        // 2⁻²⁸ each.
        assert!((64.0..=96.0).contains(&worst[0]), "{worst:?}");
        assert!((12.0..=32.0).contains(&worst[1]), "{worst:?}");
        assert!(exactly > 100_000, "{exactly}");
    }

    /// Mirrored, grazing, along the normal, opposite, and where L + V has a
    /// component of 2.
    #[test]
    fn world_space_at_its_corners() {
        const ONE: i16 = 1 << 14;
        let axes = [
            [ONE, 0, 0],
            [0, ONE, 0],
            [0, 0, ONE],
            [-ONE, 0, 0],
            [0, -ONE, 0],
            [0, 0, -ONE],
            // 3-4-5, in the steps of a component almost a unit vector.
            [9_830, 0, 13_107],
            [-9_830, 0, 13_107],
            [1, 0, ONE],
            [ONE, 0, 1],
            [-ONE, 0, 1],
        ];
        for n in axes {
            for l in axes {
                for v in axes {
                    let close = dot(n, n) == 1 << 28;
                    for (found, exact) in found(n, l, v).into_iter().zip(exact(n, l, v)) {
                        let off = (f64::from(found) - exact).abs();
                        let most = if close {
                            64.0
                        } else {
                            96.0 + exact.abs() * 2e-4
                        };
                        assert!(off <= most, "{n:?}, {l:?}, {v:?}: {found} for {exact}");
                    }
                }
            }
        }
        for axis in axes.into_iter().take(6) {
            assert_eq!(found(axis, axis, axis), [0, 0]);
        }
        // 1 − R·V = 2 with 29 fraction bits.
        assert_eq!(found([0, 0, ONE], [ONE, 0, 0], [ONE, 0, 0])[0], 1 << 30);
    }

    /// Directions of any length: overflow checks are on.
    #[test]
    fn nothing_wraps_unasked() {
        let ends = [i16::MIN, -16_384, -1, 0, 1, 12_345, i16::MAX];
        let all = || ends.into_iter().flat_map(|x| ends.map(|y| [x, y, 777]));
        for n in all() {
            for l in all() {
                for v in all() {
                    let (found, swapped) = (found(n, l, v), found(n, v, l));
                    if [dot(n, l), dot(n, v)].iter().all(|dot| dot.abs() < 1 << 29) {
                        assert_eq!(found, swapped);
                    }
                    let [n, l, v] = [n, l, v].map(direction);
                    let (by_sum, dots) = (
                        products_by_sum(&n, &l, &v),
                        [A::dot(&n, &l), A::dot(&n, &v)],
                    );
                    assert_eq!([by_sum.0, by_sum.1].map(A::cosine), dots);
                }
            }
        }
    }
}
