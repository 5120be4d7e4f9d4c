//! 32-bit fixed point with 64-bit products.

use fixed::types::{I2F30, U1F31, U32F32, U64F64};

use super::{Arithmetic, peak};
use crate::colour::Rgb;
use crate::geometry::Direction;
use crate::shade::Linear;
use crate::table::{CosineCurve, CosinePowerTable, ProfileCurve, SquareCurve, UniformTable};

/// Fraction bits of a component.
pub(crate) const COMPONENT_BITS: u32 = 30;
/// Fraction bits of a share.
pub(crate) const UNIT_BITS: u32 = 31;
/// Fraction bits of m as the profile tables take it.
const PROFILE_BITS: u32 = 54;
/// Fraction bits of the versine.
const VERSINE_BITS: u32 = 2 * COMPONENT_BITS + 1;

/// 32-bit fixed point: directions in `I2F30`, shares in `U1F31`, lobes in
/// tables of `CELLS` cells.
///
/// The versine is exact for the directions given. 64-bit products and one
/// division make it suit cores with a long multiply (Cortex-M3 and up); it
/// runs, and gives the same bits, on all. Sums of components wrap only for
/// directions whose length is far from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q31<const CELLS: usize = 1024>;

/// K as a mantissa of 32 bits and a shift: 2⁻²⁴ to 2³².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gain31 {
    mantissa: u32,
    shift: u32,
}

impl Gain31 {
    /// The gain K, any number that `U32F32` holds.
    #[must_use]
    pub const fn new(k: U32F32) -> Self {
        let bits = k.to_bits();
        // K = mantissa · 2^−zeros; the product with a share has 31 fraction
        // bits more, of which the light keeps 24.
        let zeros = bits.leading_zeros();
        if zeros > 56 {
            // Below one step of the light.
            return Self {
                mantissa: 0,
                shift: 0,
            };
        }
        Self {
            mantissa: ((bits << zeros) >> 32) as u32,
            shift: UNIT_BITS - 24 + zeros,
        }
    }
}

/// What constructors of models need.
impl<const CELLS: usize> Q31<CELLS> {
    /// The lobe of exponent `n`, given with 32 fraction bits.
    pub(crate) const fn stored_power(n: u64) -> UniformTable<CELLS> {
        UniformTable::power(n, VERSINE_BITS)
    }

    /// The profile e^(−s·m), `s` given with 32 fraction bits.
    pub(crate) const fn stored_exponential(s: u64) -> UniformTable<CELLS> {
        UniformTable::exponential(s, PROFILE_BITS)
    }

    /// A separation from one with 60 fraction bits.
    pub(crate) const fn separation(bits: u64) -> u64 {
        bits
    }
}

impl<const CELLS: usize> Arithmetic for Q31<CELLS> {
    const NAME: &'static str = "q31";

    type Component = I2F30;
    type Cosine = I2F30;
    /// 30 fraction bits; read as a magnitude, so that 2.0 is held.
    type Offset = i32;
    /// 60 fraction bits.
    type Separation = u64;
    /// 61 fraction bits.
    type Versine = u64;
    type Unit = U1F31;
    type Ratio = U1F31;
    type Scale = U32F32;
    type Radiance = U32F32;
    type Value = U64F64;
    type Gain = Gain31;
    /// 24 fraction bits, saturating.
    type Light = u32;
    type Power = UniformTable<CELLS>;
    type Profile = UniformTable<CELLS>;
    type CosinePower = CosinePowerTable;

    const COSINE_ZERO: I2F30 = I2F30::ZERO;
    const ZERO: U1F31 = U1F31::ZERO;
    const ONE: U1F31 = U1F31::ONE;

    #[inline]
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> I2F30 {
        let product = |a: I2F30, b: I2F30| i64::from(a.to_bits()) * i64::from(b.to_bits());
        let sum = product(a.x, b.x)
            .wrapping_add(product(a.y, b.y))
            .wrapping_add(product(a.z, b.z));
        I2F30::from_bits((sum.wrapping_add(1 << (COMPONENT_BITS - 1)) >> COMPONENT_BITS) as i32)
    }

    #[inline]
    fn sum(a: I2F30, b: I2F30) -> i32 {
        a.to_bits().wrapping_add(b.to_bits())
    }

    #[inline]
    fn difference(a: I2F30, b: I2F30) -> i32 {
        a.to_bits().wrapping_sub(b.to_bits())
    }

    #[inline]
    fn upright(z: I2F30) -> I2F30 {
        z
    }

    #[inline]
    fn height(a: I2F30, b: I2F30) -> i32 {
        Self::difference(a, b)
    }

    #[inline]
    fn tangential(n: I2F30, l: I2F30, v: I2F30, cosines: (I2F30, I2F30)) -> i32 {
        let height = i64::from(cosines.0.to_bits()) + i64::from(cosines.1.to_bits());
        let along =
            (height * i64::from(n.to_bits()) + (1 << (COMPONENT_BITS - 1))) >> COMPONENT_BITS;
        Self::sum(l, v).wrapping_sub(along as i32)
    }

    #[inline]
    fn square<const N: usize>(offsets: [i32; N]) -> u64 {
        offsets.iter().fold(0, |sum: u64, offset| {
            let magnitude = u64::from(offset.unsigned_abs());
            sum.wrapping_add(magnitude * magnitude)
        })
    }

    #[inline]
    fn half(square: u64) -> u64 {
        square
    }

    #[inline]
    fn above_horizon(n_dot_l: I2F30, n_dot_v: I2F30) -> bool {
        n_dot_l >= I2F30::ZERO && n_dot_v >= I2F30::ZERO
    }

    #[inline]
    fn lit(n_dot_l: I2F30, n_dot_v: I2F30) -> bool {
        n_dot_l > I2F30::ZERO && n_dot_v >= I2F30::ZERO
    }

    #[inline]
    fn is_number(_: u64) -> bool {
        true
    }

    #[inline]
    fn power(table: &UniformTable<CELLS>, x: u64) -> U1F31 {
        U1F31::from_bits(table.at(x))
    }

    #[inline]
    fn profile(table: &UniformTable<CELLS>, m_squared: u64) -> U1F31 {
        U1F31::from_bits(table.at(m_squared.isqrt() << (PROFILE_BITS - COMPONENT_BITS)))
    }

    #[inline]
    fn free_profile(curve: &ProfileCurve, m_squared: u64) -> U1F31 {
        U1F31::from_bits(curve.at(m_squared.isqrt() << (UNIT_BITS - COMPONENT_BITS)))
    }

    #[inline]
    fn square_profile(curve: &SquareCurve, m_squared: u64) -> U1F31 {
        U1F31::from_bits(curve.at(m_squared))
    }

    #[inline]
    fn cos_theta_prime(m_squared: u64, (a, b): (I2F30, I2F30)) -> I2F30 {
        // 2(a² + b²) with the 60 fraction bits of m²: the root is 2cosθ'.
        let twice = Self::square([a.to_bits(), b.to_bits()]).wrapping_mul(2);
        I2F30::from_bits((m_squared.wrapping_add(twice).isqrt() >> 1) as i32)
    }

    #[inline]
    fn cosine_power(table: &CosinePowerTable, cosine: I2F30) -> U1F31 {
        U1F31::from_bits(table.at(cosine.to_bits()))
    }

    #[inline]
    fn ratio(a: I2F30, b: I2F30) -> Option<U1F31> {
        let (a, b) = (a.to_bits(), b.to_bits());
        if a <= 0 {
            Some(U1F31::ZERO)
        } else if a >= b {
            None
        } else {
            let quotient = (u64::from(a as u32) << UNIT_BITS) / u64::from(b as u32);
            Some(U1F31::from_bits(quotient as u32))
        }
    }

    #[inline]
    fn attenuate(share: U1F31, ratio: U1F31) -> U1F31 {
        Self::product(share, ratio)
    }

    #[inline]
    fn foreshorten(share: U1F31, cosine: I2F30) -> U1F31 {
        let cosine = cosine.to_bits().clamp(0, 1 << COMPONENT_BITS) as u32;
        Self::product(share, U1F31::from_bits(cosine << 1))
    }

    #[inline]
    fn curve(curve: &CosineCurve, cosine: I2F30) -> Rgb<U1F31> {
        Rgb::from_array(curve.at(cosine.to_bits())).map(U1F31::from_bits)
    }

    #[inline]
    fn product(a: U1F31, b: U1F31) -> U1F31 {
        let product = u64::from(a.to_bits()) * u64::from(b.to_bits());
        U1F31::from_bits(((product + (1 << (UNIT_BITS - 1))) >> UNIT_BITS) as u32)
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
    fn value_over(peak: U32F32, share: U1F31, cosine: I2F30) -> U64F64 {
        peak::value_over(peak, share, cosine.to_bits())
    }

    #[inline]
    fn add_values(a: U64F64, b: U64F64) -> U64F64 {
        a.saturating_add(b)
    }

    #[inline]
    fn expose(gain: Gain31, share: U1F31) -> u32 {
        let product = u64::from(share.to_bits()) * u64::from(gain.mantissa);
        let light = product >> (gain.shift % 64);
        if light > u64::from(u32::MAX) {
            u32::MAX
        } else {
            light as u32
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
