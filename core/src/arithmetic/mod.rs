//! How numbers are represented and computed.
//!
//! The trait abstracts the steps of a reflectance model, not operators: in
//! fixed point the binary point moves at every product, so that no number
//! type could carry a model's formula. Each step says which quantity it takes
//! and gives; its implementor chooses bits and rounding.

pub(crate) mod exponent;
mod f32;
mod math;
mod peak;
pub(crate) mod q15;
pub(crate) mod q31;
pub(crate) mod short;

pub use self::f32::{F32, Float};
#[cfg(feature = "micromath")]
pub use math::{Approximate, Micromath};
pub use math::{Libm, Math};
pub use q15::{Gain15, Q15};
pub use q31::{Gain31, Q31};

use core::fmt::Debug;

use crate::colour::Rgb;
use crate::geometry::Direction;
use crate::shade::Linear;
use crate::table::{CosineCurve, ProfileCurve, SquareCurve};

/// The steps of which every model of this crate is made, in one way to
/// compute. Implemented by zero-sized markers.
pub trait Arithmetic: Copy + Debug + PartialEq + 'static {
    /// Name on command lines and on the wire.
    const NAME: &'static str;

    /// Coordinate of a direction; holds −1 … 1.
    type Component: Copy + Debug + PartialEq + PartialOrd;
    /// Cosine of the angle between two directions; holds −1 … 1.
    type Cosine: Copy + Debug + PartialEq + PartialOrd;
    /// Sum or difference of two components, −2 … 2.
    type Offset: Copy;
    /// Squared distance of two directions or of their projections, 0 … 4.
    type Separation: Copy + Debug + PartialOrd;
    /// 1 − cosine of the angle between two directions, 0 … 2.
    type Versine: Copy;
    /// A share, 0 … 1: lobe, ratio of cosines, reflectance. Holds numbers
    /// just below 2, because the red of a spectral metal can pass 1.
    type Unit: Copy + Debug + PartialEq + PartialOrd;
    /// A ratio of cosines, 0 … 1.
    type Ratio: Copy;
    /// Peak of a BRDF over the share, in sr⁻¹.
    type Scale: Copy + Debug + PartialEq;
    /// Reflected radiance for unit normal irradiance.
    type Radiance: Copy + Debug + PartialEq;
    /// BRDF value in sr⁻¹, without the cosine.
    type Value: Copy + Debug + PartialEq;
    /// Exposed light per unit of share: the K of out = clamp(K·ρ, 0, 1).
    type Gain: Copy + Debug + PartialEq;
    /// Exposed linear light that is still being summed.
    type Light: Copy + Debug + Default;
    /// A stored lobe cosⁿα.
    type Power: Copy + Debug + PartialEq;
    /// A stored profile ξ(m).
    type Profile: Copy + Debug + PartialEq;
    /// A stored power c^(1−p) of a cosine.
    type CosinePower: Copy + Debug + PartialEq;

    /// The cosine 0.
    const COSINE_ZERO: Self::Cosine;
    /// The share 0.
    const ZERO: Self::Unit;
    /// The share 1.
    const ONE: Self::Unit;

    /// Cosine of the angle between two directions.
    fn dot(a: &Direction<Self>, b: &Direction<Self>) -> Self::Cosine;
    /// The cosine of a direction with the shading frame's normal, which is its
    /// third coordinate.
    fn upright(z: Self::Component) -> Self::Cosine;
    /// a + b.
    fn sum(a: Self::Component, b: Self::Component) -> Self::Offset;
    /// a − b.
    fn difference(a: Self::Component, b: Self::Component) -> Self::Offset;
    /// a − b of two cosines.
    fn height(a: Self::Cosine, b: Self::Cosine) -> Self::Offset;
    /// One coordinate of L + V without its part along the normal:
    /// l + v − (N·L + N·V)·n.
    fn tangential(
        n: Self::Component,
        l: Self::Component,
        v: Self::Component,
        cosines: (Self::Cosine, Self::Cosine),
    ) -> Self::Offset;
    /// Sum of squares.
    fn square<const N: usize>(offsets: [Self::Offset; N]) -> Self::Separation;
    /// The same of what [`Self::height`] and [`Self::tangential`] give, which may have
    /// more digits.
    #[inline]
    fn square_of_rounded<const N: usize>(offsets: [Self::Offset; N]) -> Self::Separation {
        Self::square(offsets)
    }
    /// The versine of two directions whose difference has that square.
    fn half(square: Self::Separation) -> Self::Versine;

    /// Whether neither cosine is negative. In floating point it is false, too,
    /// for what is infinite or not a number.
    fn above_horizon(n_dot_l: Self::Cosine, n_dot_v: Self::Cosine) -> bool;
    /// Whether light arrives and is seen: as [`Self::above_horizon`], and not
    /// along the surface.
    fn lit(n_dot_l: Self::Cosine, n_dot_v: Self::Cosine) -> bool;
    /// cosΘmin: the larger cosine belongs to the smaller angle (3.4).
    #[inline]
    fn larger(n_dot_l: Self::Cosine, n_dot_v: Self::Cosine) -> Self::Cosine {
        if n_dot_l >= n_dot_v { n_dot_l } else { n_dot_v }
    }
    /// The share 1 where a separation is at most `limit`, 0 where it is more.
    #[inline]
    fn within(separation: Self::Separation, limit: Self::Separation) -> Self::Unit {
        if separation <= limit {
            Self::ONE
        } else {
            Self::ZERO
        }
    }
    /// Whether the directions behind a versine were numbers.
    fn is_number(x: Self::Versine) -> bool;
    /// cosⁿα = (1 − x)ⁿ; 0 for x ≥ 1.
    fn power(stored: &Self::Power, x: Self::Versine) -> Self::Unit;
    /// ξ(m) for m².
    fn profile(stored: &Self::Profile, m_squared: Self::Separation) -> Self::Unit;
    /// ξ(m) for m², of a free profile.
    fn free_profile(curve: &ProfileCurve, m_squared: Self::Separation) -> Self::Unit;
    /// A profile over m², of a table with a reach of its own.
    fn square_profile(curve: &SquareCurve, m_squared: Self::Separation) -> Self::Unit;
    /// cosθ' = √(m²/4 + (N·L² + N·V²)/2) for cosines that are not negative:
    /// sinθ' is half the distance of the projections of L and V (4.53), which
    /// loses no digits here.
    fn cos_theta_prime(
        m_squared: Self::Separation,
        cosines: (Self::Cosine, Self::Cosine),
    ) -> Self::Cosine;
    /// c^(1−p) for a cosine c ≥ 0.
    fn cosine_power(stored: &Self::CosinePower, cosine: Self::Cosine) -> Self::Unit;
    /// a / max(a, b) for cosines that are not negative: `None` where it is
    /// 1, which half of all directions have; 0 where both are 0.
    fn ratio(a: Self::Cosine, b: Self::Cosine) -> Option<Self::Ratio>;
    /// share · ratio.
    fn attenuate(share: Self::Unit, ratio: Self::Ratio) -> Self::Unit;
    /// share · cosine, for a cosine that is not negative.
    fn foreshorten(share: Self::Unit, cosine: Self::Cosine) -> Self::Unit;
    /// A share, at most 1: where [`Self::foreshorten`] lets the cosine of a
    /// direction that is too long pass 1, because a pixel is clamped anyway.
    #[inline]
    fn bounded(share: Self::Unit) -> Self::Unit {
        share
    }
    /// A curve over a cosine.
    fn curve(curve: &CosineCurve, cosine: Self::Cosine) -> Rgb<Self::Unit>;
    /// share · curve(cosine), per channel.
    #[inline]
    fn tint(share: Self::Unit, curve: &CosineCurve, cosine: Self::Cosine) -> Rgb<Self::Unit> {
        Self::curve(curve, cosine).map(|channel| Self::product(share, channel))
    }
    /// a · b.
    fn product(a: Self::Unit, b: Self::Unit) -> Self::Unit;
    /// a + b, at most 1.
    fn total(a: Self::Unit, b: Self::Unit) -> Self::Unit;

    /// peak · share.
    fn radiance(peak: Self::Scale, share: Self::Unit) -> Self::Radiance;
    /// a + b, at most the greatest value that the type holds.
    fn add_radiances(a: Self::Radiance, b: Self::Radiance) -> Self::Radiance;
    /// peak · share, as a BRDF value.
    fn value(peak: Self::Scale, share: Self::Unit) -> Self::Value;
    /// peak · share / cosine; at most the greatest value that the type holds,
    /// which is what a cosine of 0 gets unless the share is 0, too.
    fn value_over(peak: Self::Scale, share: Self::Unit, cosine: Self::Cosine) -> Self::Value;
    /// a + b, at most the greatest value that the type holds.
    fn add_values(a: Self::Value, b: Self::Value) -> Self::Value;

    /// K · ρ, not yet clamped to 1.
    fn expose(gain: Self::Gain, share: Self::Unit) -> Self::Light;
    /// a + b, saturating.
    fn add_light(a: Self::Light, b: Self::Light) -> Self::Light;
    /// The clamped pixel.
    fn linear(light: Rgb<Self::Light>) -> Linear;
}
