//! Sampling in 32-bit fixed point.

use fixed::types::{I2F30, U0F32, U32F32};

use super::exponential::one_minus_exp_neg;
use super::logarithm::{neg_ln_one_minus, times};
use super::reciprocal::Reciprocal;
use super::steps::{BROAD, NARROW, Sampling};
use crate::arithmetic::{Arithmetic, Q31};
use crate::brdf::mixture_mass;
use crate::geometry::Direction;
use crate::table::integer::divide;

/// Fraction bits of a component, again.
const BITS: u32 = crate::arithmetic::q31::COMPONENT_BITS;

/// How far from a lobe's axis a direction is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cap31 {
    /// 1 − cos α, 32 fraction bits.
    versine: u32,
    /// sin α, 32 fraction bits.
    sine: u32,
}

/// How distances of density ∝ m·e^(−s·m) are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spread31 {
    /// 1 − (1 + s)e^(−s), 64 fraction bits.
    mass: u64,
    scale: Scale,
}

/// What a distance is scaled by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scale {
    /// √(2·mass)/s with 31 fraction bits, for s < 1/2.
    Slope(u32),
    /// 1/s.
    Width(Reciprocal),
}

impl Spread31 {
    /// For a sharpness in [0, 4096].
    pub(super) const fn new(sharpness: U32F32) -> Self {
        let bits = sharpness.to_bits();
        let [mass, slope] = mixture_mass(bits);
        let most = u64::MAX as u128;
        Self {
            mass: if mass < most { mass } else { most } as u64,
            scale: if bits < 1 << 31 {
                Scale::Slope((slope >> 32) as u32)
            } else {
                Scale::Width(Reciprocal::new(bits))
            },
        }
    }
}

/// The middle of a random number's cell, 64 fraction bits: never 0 nor 1.
#[inline]
fn middle(u: U0F32) -> u64 {
    (u64::from(u.to_bits()) << 32) | (1 << 31)
}

/// Σ cᵢ·tⁱ with 29 fraction bits, the coefficients too; `t` has 31.
#[inline]
fn polynomial(coefficients: &[i32], t: u32) -> i64 {
    coefficients.iter().rev().fold(0, |sum: i64, coefficient| {
        ((sum.wrapping_mul(i64::from(t))) >> 31).wrapping_add(i64::from(*coefficient))
    })
}

/// a·b of components, with twice their fraction bits.
#[inline]
fn product(a: I2F30, b: I2F30) -> i64 {
    i64::from(a.to_bits()) * i64::from(b.to_bits())
}

/// A component from 32 fraction bits more.
#[inline]
fn rounded(bits: i64) -> I2F30 {
    I2F30::from_bits((bits.wrapping_add(1 << 31) >> 32) as i32)
}

/// √ of a number with twice a component's fraction bits.
#[inline]
fn height(square: i64) -> I2F30 {
    let root = (square.max(0) as u64).isqrt();
    I2F30::from_bits(root.min(i32::MAX as u64) as i32)
}

impl<const CELLS: usize> Sampling for Q31<CELLS> {
    type Uniform = U0F32;
    type Concentration = Reciprocal;
    type Cap = Cap31;
    type Spread = Spread31;

    const COMPONENT_ZERO: I2F30 = I2F30::ZERO;
    const COSINE_ONE: I2F30 = I2F30::ONE;
    const SCALE_ONE: U32F32 = U32F32::ONE;
    const SEPARATION_ONE: u64 = 1 << (2 * BITS);

    #[inline]
    fn quotient(a: U32F32, b: U32F32) -> U32F32 {
        let quotient = divide(u128::from(a.to_bits()) << 32, u128::from(b.to_bits()));
        U32F32::from_bits(quotient.min(u128::from(u64::MAX)) as u64)
    }

    #[inline]
    fn mirrored(direction: &Direction<Self>) -> Direction<Self> {
        Direction::new(
            direction.x.wrapping_neg(),
            direction.y.wrapping_neg(),
            direction.z,
        )
    }

    #[inline]
    fn cap(concentration: &Reciprocal, u: U0F32) -> Cap31 {
        let versine = one_minus_exp_neg(concentration.of(neg_ln_one_minus(middle(u))));
        // x − x²/2, half of sin²α: at most 1/2.
        let half = versine - (times(versine, versine) >> 1);
        let square = half.min((1 << 63) - 1) << 1;
        Cap31 {
            versine: (versine >> 32) as u32,
            sine: square.isqrt() as u32,
        }
    }

    #[inline]
    fn about(axis: &Direction<Self>, cap: Cap31, u: U0F32) -> Direction<Self> {
        // Frisvad's frame, whose third axis is not below the horizon; 32
        // fraction bits in the frame, 62 in the products.
        let [first, second] =
            super::turn::fixed(u.to_bits()).map(|part| (i64::from(cap.sine) * part) >> 31);
        let [x, y, z] = [axis.x, axis.y, axis.z].map(|c| i64::from(c.to_bits()));
        let along = first.wrapping_mul(x).wrapping_add(second.wrapping_mul(y));
        let tilt = along.checked_div(z.max(0) + (1 << BITS)).unwrap_or(0);
        let cosine = (1 << 32) - i64::from(cap.versine);
        let factor = cosine.wrapping_sub(tilt);
        let beside =
            |axis: i64, part: i64| rounded(axis.wrapping_mul(factor).wrapping_add(part << BITS));
        Direction::new(
            beside(x, first),
            beside(y, second),
            rounded(z.wrapping_mul(cosine).wrapping_sub(along)),
        )
    }

    #[inline]
    fn root(radius: I2F30, u: U0F32) -> I2F30 {
        let root = i64::from(middle(u).isqrt() as u32);
        I2F30::from_bits(((i64::from(radius.to_bits()) * root) >> 32) as i32)
    }

    #[inline]
    fn spread(stored: &Spread31, u: U0F32) -> I2F30 {
        let y = neg_ln_one_minus(times(middle(u), stored.mass));
        // √(2y) with 29 fraction bits, at most 6.8.
        let q = (y << 1).isqrt() as u32;
        let m = match stored.scale {
            Scale::Slope(slope) => {
                let root = u64::from(middle(u).isqrt() as u32);
                let scaled = (u64::from(slope) * root) >> 32;
                (scaled * polynomial(&BROAD, q << 2) as u64) >> 30
            }
            Scale::Width(width) => {
                // q/8 has three fraction bits more.
                let x = u64::from(q) * polynomial(&NARROW, q >> 1) as u64;
                width.of(x) >> 28
            }
        };
        I2F30::from_bits(m.min(1 << BITS) as i32)
    }

    #[inline]
    fn circle(radius: I2F30, u: U0F32) -> [I2F30; 2] {
        // Towards 0, so that no point lies farther than the radius.
        super::turn::fixed(u.to_bits())
            .map(|part| I2F30::from_bits((i64::from(radius.to_bits()) * part / (1 << 31)) as i32))
    }

    #[inline]
    fn beside(v: &Direction<Self>, [x, y]: [I2F30; 2]) -> Option<Direction<Self>> {
        let along = product(v.x, x).wrapping_add(product(v.y, y));
        let square = product(v.z, v.z)
            .wrapping_add(along.wrapping_shl(1))
            .wrapping_sub(product(x, x))
            .wrapping_sub(product(y, y));
        (square >= 0)
            .then(|| Direction::new(x.wrapping_sub(v.x), y.wrapping_sub(v.y), height(square)))
    }

    #[inline]
    fn raised([x, y]: [I2F30; 2]) -> Direction<Self> {
        let square = (1 << (2 * BITS)) - product(x, x) - product(y, y);
        Direction::new(x, y, height(square))
    }

    #[inline]
    fn step_back(a: u64, b: u64) -> u64 {
        let distance = a.isqrt().saturating_sub(b.isqrt());
        <Self as Arithmetic>::square([distance.min(i32::MAX as u64) as i32])
    }
}
