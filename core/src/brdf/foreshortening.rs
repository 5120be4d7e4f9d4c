//! What a lobe is divided by.

use fixed::types::U0F32;

use crate::arithmetic::{Arithmetic, Float, Math, Q15, Q31};
use crate::error::ParameterError;
use crate::table::CosinePowerTable;

/// Division by cosᵖΘmin (3.12), and the bounded ratio that a shader needs in
/// its place: forming it first keeps every intermediate within [0, 1].
pub trait Foreshortening<A: Arithmetic> {
    /// shape · cosΘL / cosᵖΘmin, the quotient in [0, 1], for cosines that are
    /// not negative.
    fn attenuate(&self, shape: A::Unit, n_dot_l: A::Cosine, n_dot_v: A::Cosine) -> A::Unit;

    /// peak · shape / cosᵖΘmin for cosΘmin ≥ 0.
    fn value(&self, peak: A::Scale, shape: A::Unit, cos_min: A::Cosine) -> A::Value;
}

/// p = 0: no division. Reciprocal Phong, the patches, Lambert.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flat;

impl<A: Arithmetic> Foreshortening<A> for Flat {
    #[inline]
    fn attenuate(&self, shape: A::Unit, n_dot_l: A::Cosine, _: A::Cosine) -> A::Unit {
        A::foreshorten(shape, n_dot_l)
    }

    #[inline]
    fn value(&self, peak: A::Scale, shape: A::Unit, _: A::Cosine) -> A::Value {
        A::value(peak, shape)
    }
}

/// p = 1: the metallic model's division by cosΘmin (3.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Metallic;

impl Metallic {
    /// shape · cosΘL / cosΘmin, and cosΘmin, of one comparison.
    #[inline]
    pub(super) fn attenuated<A: Arithmetic>(
        shape: A::Unit,
        n_dot_l: A::Cosine,
        n_dot_v: A::Cosine,
    ) -> (A::Unit, A::Cosine) {
        match A::ratio(n_dot_l, n_dot_v) {
            None => (shape, n_dot_l),
            Some(ratio) => (A::attenuate(shape, ratio), n_dot_v),
        }
    }
}

impl<A: Arithmetic> Foreshortening<A> for Metallic {
    #[inline]
    fn attenuate(&self, shape: A::Unit, n_dot_l: A::Cosine, n_dot_v: A::Cosine) -> A::Unit {
        Self::attenuated::<A>(shape, n_dot_l, n_dot_v).0
    }

    #[inline]
    fn value(&self, peak: A::Scale, shape: A::Unit, cos_min: A::Cosine) -> A::Value {
        A::value_over(peak, shape, cos_min)
    }
}

/// 0 < p < 1: the p-model's transition between the two (3.12).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerModel<A: Arithmetic> {
    /// c^(1−p).
    rest: A::CosinePower,
}

impl<A: Arithmetic> PowerModel<A> {
    /// Division by cosᵖΘmin, with c^(1−p) as an arithmetic of one's own holds it;
    /// nothing is checked.
    #[must_use]
    pub const fn from_stored(rest: A::CosinePower) -> Self {
        Self { rest }
    }
}

impl<M: Math> PowerModel<Float<M>> {
    /// Division by cosᵖΘmin, `p` in [0, 1].
    ///
    /// # Errors
    /// `p` outside [0, 1] or not a number.
    pub const fn new(p: f32) -> Result<Self, ParameterError> {
        if p >= 0.0 && p <= 1.0 {
            Ok(Self { rest: 1.0 - p })
        } else {
            Err(P_RANGE)
        }
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> PowerModel<$arithmetic<SIZE>> {
            /// Division by cosᵖΘmin, `p` in (0, 1); for the ends there are [`Flat`]
            /// and [`Metallic`].
            ///
            /// # Errors
            /// `p` = 0.
            pub const fn new(p: U0F32) -> Result<Self, ParameterError> {
                if p.to_bits() == 0 {
                    return Err(P_RANGE);
                }
                Ok(Self {
                    rest: CosinePowerTable::new((1 << 32) - p.to_bits() as u64),
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);

const P_RANGE: ParameterError = ParameterError::new("p", "a number from 0 to 1");

impl<A: Arithmetic> Foreshortening<A> for PowerModel<A> {
    #[inline]
    fn attenuate(&self, shape: A::Unit, n_dot_l: A::Cosine, n_dot_v: A::Cosine) -> A::Unit {
        let rest = A::cosine_power(&self.rest, A::larger(n_dot_l, n_dot_v));
        let metallic = Foreshortening::<A>::attenuate(&Metallic, shape, n_dot_l, n_dot_v);
        A::product(metallic, rest)
    }

    #[inline]
    fn value(&self, peak: A::Scale, shape: A::Unit, cos_min: A::Cosine) -> A::Value {
        if cos_min == A::COSINE_ZERO {
            return A::value_over(peak, shape, cos_min);
        }
        let rest = A::cosine_power(&self.rest, cos_min);
        A::value_over(peak, A::product(shape, rest), cos_min)
    }
}
