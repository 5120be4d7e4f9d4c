//! Sampling in single precision.

use super::steps::{BROAD, NARROW, Sampling};
use crate::arithmetic::F32;
use crate::brdf::mixture_mass;
use crate::geometry::Direction;

/// How distances of density ∝ m·e^(−s·m) are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    sharpness: f32,
    /// 1 − (1 + s)e^(−s).
    mass: f32,
    /// √(2·mass)/s.
    slope: f32,
}

impl Spread {
    /// For a sharpness in [0, 4096].
    pub(super) const fn new(sharpness: f32) -> Self {
        let [mass, slope] = mixture_mass((sharpness * 4_294_967_296.0) as u64);
        Self {
            sharpness,
            mass: mass as f32 / 18_446_744_073_709_551_616.0,
            slope: slope as f32 / 9_223_372_036_854_775_808.0,
        }
    }
}

impl Sampling for F32 {
    type Uniform = f32;
    type Concentration = f32;
    type Cap = [f32; 2];
    type Spread = Spread;

    const COMPONENT_ZERO: f32 = 0.0;
    const COSINE_ONE: f32 = 1.0;
    const SCALE_ONE: f32 = 1.0;
    const SEPARATION_ONE: f32 = 1.0;

    #[inline]
    fn quotient(a: f32, b: f32) -> f32 {
        a / b
    }

    #[inline]
    fn mirrored(direction: &Direction<Self>) -> Direction<Self> {
        Direction::new(-direction.x, -direction.y, direction.z)
    }

    #[inline]
    fn cap(concentration: &f32, u: f32) -> [f32; 2] {
        let versine = -libm::expm1f(libm::log1pf(-u) * concentration);
        [versine, libm::sqrtf(versine * (2.0 - versine))]
    }

    #[inline]
    fn about(axis: &Direction<Self>, [versine, sine]: [f32; 2], u: f32) -> Direction<Self> {
        // Frisvad's frame, whose third axis is not below the horizon.
        let [first, second] = super::turn::single(u).map(|part| sine * part);
        let along = first * axis.x + second * axis.y;
        let factor = 1.0 - versine - along / (1.0 + axis.z);
        Direction::new(
            axis.x * factor + first,
            axis.y * factor + second,
            axis.z * (1.0 - versine) - along,
        )
    }

    #[inline]
    fn root(radius: f32, u: f32) -> f32 {
        radius * libm::sqrtf(u)
    }

    #[inline]
    fn spread(stored: &Spread, u: f32) -> f32 {
        let share = u * stored.mass;
        let y = -libm::log1pf(-share);
        let q = libm::sqrtf(2.0 * y);
        let m = if stored.sharpness < 0.5 {
            stored.slope * libm::sqrtf(u) * polynomial(&BROAD, q)
        } else {
            q * polynomial(&NARROW, 0.125 * q) / stored.sharpness
        };
        m.min(1.0)
    }

    #[inline]
    fn circle(radius: f32, u: f32) -> [f32; 2] {
        super::turn::single(u).map(|part| radius * part)
    }

    #[inline]
    fn beside(v: &Direction<Self>, [x, y]: [f32; 2]) -> Option<Direction<Self>> {
        let square = v.z * v.z + 2.0 * (v.x * x + v.y * y) - (x * x + y * y);
        // Not for what is infinite or not a number, either.
        if (0.0..=f32::MAX).contains(&square) {
            Some(Direction::new(x - v.x, y - v.y, libm::sqrtf(square)))
        } else {
            None
        }
    }

    #[inline]
    fn raised([x, y]: [f32; 2]) -> Direction<Self> {
        let square = 1.0 - (x * x + y * y);
        // Keeps what is not a number.
        let square = if square < 0.0 { 0.0 } else { square };
        Direction::new(x, y, libm::sqrtf(square))
    }

    #[inline]
    fn step_back(a: f32, b: f32) -> f32 {
        let distance = libm::sqrtf(a) - libm::sqrtf(b);
        distance * distance
    }
}

/// Σ cᵢ·tⁱ, from integers with 29 fraction bits.
#[inline]
fn polynomial(coefficients: &[i32], t: f32) -> f32 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| {
        sum * t + *coefficient as f32 / 536_870_912.0
    })
}
