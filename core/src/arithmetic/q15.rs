//! 16-bit directions, products of 32 bits.

use fixed::types::{I2F14, U1F31, U32F32, U64F64};

use super::short::{FACTOR, product_down, scale, sum_of_products};
use super::{Arithmetic, peak};
use crate::colour::Rgb;
use crate::geometry::Direction;
use crate::shade::Linear;
use crate::table::{
    CosineCurve, CosinePowerTable, ProfileCurve, Ratio15, ScaledTable, SquareCurve, root,
};

/// Fraction bits of a component.
const COMPONENT_BITS: u32 = 14;
/// Fraction bits of an offset in world space, which is rounded.
const FINE_BITS: u32 = 18;
/// Fraction bits of a cosine.
const COSINE_BITS: u32 = 30;

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

impl<const KNOTS: usize> Arithmetic for Q15<KNOTS> {
    const NAME: &'static str = "q15";

    type Component = I2F14;
    /// 30 fraction bits, so that the sum of three products is exact.
    type Cosine = i32;
    /// 14 fraction bits.
    type Offset = i32;
    /// 28 fraction bits.
    type Separation = u32;
    /// 29 fraction bits.
    type Versine = u32;
    type Unit = U1F31;
    type Ratio = Ratio15;
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
        sum_of_products(a.bits(), b.bits()) << (COSINE_BITS - 2 * COMPONENT_BITS)
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

    /// 18 fraction bits.
    #[inline]
    fn height(a: i32, b: i32) -> i32 {
        const DROP: u32 = COSINE_BITS - FINE_BITS;
        // Of each one's own steps: symmetric in both, to the bit.
        (a >> DROP) - (b >> DROP)
    }

    /// 18 fraction bits.
    #[inline]
    fn tangential(n: I2F14, l: I2F14, v: I2F14, cosines: (i32, i32)) -> i32 {
        // Fraction bits of the sum that its product with a component can take.
        const HEIGHT: u32 = 15;
        const DROP: u32 = HEIGHT + COMPONENT_BITS - FINE_BITS;
        let height = (cosines.0 >> (COSINE_BITS - HEIGHT)) + (cosines.1 >> (COSINE_BITS - HEIGHT));
        let along = height.wrapping_mul(i32::from(n.to_bits()));
        (Self::sum(l, v) << (FINE_BITS - COMPONENT_BITS))
            - (along.wrapping_add(1 << (DROP - 1)) >> DROP)
    }

    #[inline]
    fn square<const N: usize>(offsets: [i32; N]) -> u32 {
        offsets.iter().fold(0, |sum: u32, offset| {
            sum.wrapping_add(offset.wrapping_mul(*offset) as u32)
        })
    }

    /// Of 18 fraction bits: less than two steps of 2⁻²⁸ too small for each offset.
    #[inline]
    fn square_of_rounded<const N: usize>(offsets: [i32; N]) -> u32 {
        const MORE: u32 = FINE_BITS - COMPONENT_BITS;
        offsets.iter().fold(0, |sum: u32, offset| {
            // (u + l)² without l²: products of 32 bits.
            let offset = offset.unsigned_abs();
            let (upper, lower) = (offset >> MORE, offset & ((1 << MORE) - 1));
            let square = upper.wrapping_mul(upper);
            sum.wrapping_add(square)
                .wrapping_add(upper.wrapping_mul(lower) >> (MORE - 1))
        })
    }

    #[inline]
    fn half(square: u32) -> u32 {
        square
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
    fn ratio(a: i32, b: i32) -> Option<Ratio15> {
        if a >= b {
            None
        } else {
            Some(Ratio15::new(a as u32, b as u32))
        }
    }

    /// Truncates: off by less than 2⁻²⁹.
    #[inline]
    fn attenuate(share: U1F31, ratio: Ratio15) -> U1F31 {
        U1F31::from_bits(ratio.of(share.to_bits()))
    }

    /// Truncates: off by less than 2⁻³¹.
    #[inline]
    fn foreshorten(share: U1F31, cosine: i32) -> U1F31 {
        U1F31::from_bits(product_down::<30>(share.to_bits(), cosine as u32))
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
    use fixed::types::I2F14;

    use super::Q15;
    use crate::arithmetic::Arithmetic as _;

    type A = Q15;

    #[test]
    fn squares_of_18_bits_are_within_two_steps_each() {
        let ends = [
            0,
            1,
            15,
            16,
            17,
            255,
            12_345,
            99_999,
            (1 << 19) - 1,
            1 << 19,
        ];
        for a in ends {
            for b in ends {
                let exact = |n: [i64; 2]| (n[0] * n[0] + n[1] * n[1]) as f64 / 256.0;
                let found = f64::from(A::square_of_rounded([a, -b]));
                let off = found - exact([a.into(), b.into()]);
                assert!((-4.0..=0.0).contains(&off), "{a}, {b}: {off}");
                assert_eq!(A::square_of_rounded([-a, b]), A::square_of_rounded([a, -b]));
            }
        }
    }

    /// L + V without its part along N, and N·L − N·V, to half a step of 18 bits and to
    /// what cosines of 15 make of it.
    #[test]
    fn what_is_left_off_the_normal_has_18_bits() {
        for n in [-16_384i32, -9_999, 1, 7_777, 16_384] {
            for cosines in [(1 << 30, 1 << 29), (12_345_678, 987_654_321), (0, 3 << 15)] {
                let component = |bits: i32| I2F14::from_bits(bits as i16);
                let found = A::tangential(component(n), component(5_000), component(77), cosines);
                let heights = (f64::from(cosines.0) + f64::from(cosines.1)) / f64::from(1 << 30);
                let exact = 5_077.0 * 16.0 - 16.0 * f64::from(n) * heights;
                let cut = 2.0 * 16.0 * f64::from(n).abs() / f64::from(1 << 15);
                assert!(
                    (f64::from(found) - exact).abs() <= 0.5 + cut,
                    "{n}, {cosines:?}"
                );
                let (a, b) = cosines;
                let height = f64::from(a - b) / f64::from(1 << 12);
                assert!((f64::from(A::height(a, b)) - height).abs() <= 1.0);
                assert_eq!(A::height(a, b), -A::height(b, a));
            }
        }
    }
}
