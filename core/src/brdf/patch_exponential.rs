//! The exponential mixture of patches (4.46).

use fixed::types::U32F32;

use super::Shape;
use super::foreshortening::Flat;
use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31};
use crate::error::ParameterError;
use crate::geometry::Geometry;
use crate::table::integer::{INVERSE_PI, ONE, divide, exp_neg, times};

/// f = C(s) · e^(−s·m), C(s) = s²/(2π(1 − (1+s)e^−s)) (4.45, 4.46).
///
/// s = 0 is Lambert's law of albedo 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchExponential<A: Arithmetic> {
    profile: A::Profile,
    peak: A::Scale,
}

const SHARPNESS_RANGE: ParameterError = ParameterError::new("sharpness", "a number from 0 to 4096");

impl<M: Math> PatchExponential<Float<M>> {
    /// The mixture of sharpness `s`, from 0 to 4096.
    ///
    /// # Errors
    /// `s` outside its range or not a number.
    // `contains` is not a `const fn`.
    #[allow(clippy::manual_range_contains)]
    pub const fn new(s: f32) -> Result<Self, ParameterError> {
        if !(s >= 0.0 && s <= 4096.0) {
            return Err(SHARPNESS_RANGE);
        }
        // The peak from the integer formula: it has no 0/0 at small s.
        let bits = (s * 4_294_967_296.0) as u64;
        let peak = mixture_peak(bits) as f32 / 4_294_967_296.0;
        Ok(Self { profile: s, peak })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> PatchExponential<$arithmetic<SIZE>> {
            /// The mixture of sharpness `s`, from 0 to 4096.
            ///
            /// # Errors
            /// `s` outside its range.
            pub const fn new(s: U32F32) -> Result<Self, ParameterError> {
                let bits = s.to_bits();
                if bits > 4096 << 32 {
                    return Err(SHARPNESS_RANGE);
                }
                let peak = U32F32::from_bits(mixture_peak(bits));
                Ok(Self {
                    profile: $arithmetic::<SIZE>::stored_exponential(bits),
                    peak,
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

/// C(s) (4.45), 32 fraction bits in and out, error at most 1e-9 of it.
const fn mixture_peak(s: u64) -> u64 {
    // C = 1/(2π·q) = (1/π)/(2q), to 32 fraction bits.
    divide(INVERSE_PI << 31, mixture_integral(s)) as u64
}

/// q = (1 − (1+s)e^−s)/s², 64 fraction bits for an s with 32.
const fn mixture_integral(s: u64) -> u128 {
    if s < 1 << 31 {
        // The closed form is 0/0 at s = 0. q = Σ (−s)^k (k+1)/(k+2)!.
        let s = (s as u128) << 32;
        let mut k = 16;
        let mut sum = 0;
        // Horner: q = 1/2 − s(1/3 − s(1/8 − …)); each inner term is positive.
        while k > 0 {
            k -= 1;
            sum = series_coefficient(k) - ((s * sum) >> 64);
        }
        sum
    } else {
        divide(divide(above_tail(s) << 32, s as u128) << 32, s as u128)
    }
}

/// 1 − (1+s)e^−s, 64 fraction bits for an s with 32.
const fn above_tail(s: u64) -> u128 {
    let exponential = exp_neg(times(s, ONE));
    let tail = exponential + ((exponential * s as u128) >> 32);
    ONE - tail
}

/// What sampling needs of s, which has 32 fraction bits: the mass
/// 1 − (1+s)e^−s with 64 fraction bits, and √(2·mass)/s with 63.
pub(crate) const fn mixture_mass(s: u64) -> [u128; 2] {
    let integral = mixture_integral(s);
    let mass = if s < 1 << 31 {
        (integral * (s as u128 * s as u128)) >> 64
    } else {
        above_tail(s)
    };
    [mass, (integral << 63).isqrt()]
}

/// (k+1)/(k+2)! with 64 fraction bits.
const fn series_coefficient(k: u32) -> u128 {
    let mut factorial = 1;
    let mut i = 2;
    while i <= k + 2 {
        factorial *= i as u128;
        i += 1;
    }
    divide(ONE * (k as u128 + 1), factorial)
}

impl<A: Arithmetic> PatchExponential<A> {
    /// The mixture of a profile as an arithmetic of one's own holds it, with its
    /// peak in sr⁻¹; nothing is checked.
    #[must_use]
    pub const fn from_stored(profile: A::Profile, peak: A::Scale) -> Self {
        Self { profile, peak }
    }

    /// ξ(m) for m².
    #[inline]
    pub(crate) fn profile(&self, m_squared: A::Separation) -> A::Unit {
        A::profile(&self.profile, m_squared)
    }
}

impl<A: Arithmetic> Shape for PatchExponential<A> {
    type Arithmetic = A;
    type Foreshortening = Flat;

    #[inline]
    fn amplitude(&self) -> A::Scale {
        self.peak
    }

    #[inline]
    fn foreshortening(&self) -> &Flat {
        &Flat
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<A>) -> A::Unit {
        self.profile(geometry.separation())
    }
}
