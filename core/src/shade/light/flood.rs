//! A lamp that shines about an axis.

use fixed::types::U32F32;

use super::{Dimmed, Light, PointLight};
use crate::arithmetic::{Float, Math, Q15, Q31, exponent};
use crate::error::ParameterError;
use crate::geometry::{Direction, retro_versine};
use crate::shade::Placing;

/// A point whose intensity falls as cosⁿξ with the angle ξ to its axis, and
/// is 0 behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloodLight<A: Placing> {
    lamp: PointLight<A>,
    /// Against the axis: from what it shines at to the lamp.
    back: Direction<A>,
    lobe: A::Power,
}

impl<A: Placing> Light<A> for FloodLight<A> {
    type Beam = Dimmed<A>;

    #[inline]
    fn beam(&self, place: impl Fn() -> A::Place) -> Dimmed<A> {
        let beam = self.lamp.beam(place);
        let share = A::power(&self.lobe, retro_versine(&self.back, &beam.direction));
        Dimmed {
            dimming: beam.dimming.map(|dimming| A::narrow(dimming, share)),
            ..beam
        }
    }

    #[inline]
    fn lamp(&self) -> Option<&[A::Length; 3]> {
        self.lamp.lamp()
    }
}

impl<M: Math> FloodLight<Float<M>> {
    /// The lamp `lamp` about an axis; `back` is the unit vector against it,
    /// `n` from 0 to 1e8 the exponent.
    ///
    /// # Errors
    /// `n` outside its range or not a number.
    pub const fn new(
        lamp: PointLight<Float<M>>,
        back: Direction<Float<M>>,
        n: f32,
    ) -> Result<Self, ParameterError> {
        let n = match exponent::single(n) {
            Ok(n) => n,
            Err(error) => return Err(error),
        };
        Ok(Self {
            lamp,
            back,
            lobe: n,
        })
    }
}

macro_rules! in_fixed_point {
    ($arithmetic:ident) => {
        impl<const SIZE: usize> FloodLight<$arithmetic<SIZE>> {
            /// The lamp `lamp` about an axis; `back` is the unit vector against it,
            /// `n`, 0 or from 1 to 1e8, the exponent.
            ///
            /// # Errors
            /// `n` outside its range.
            pub const fn new(
                lamp: PointLight<$arithmetic<SIZE>>,
                back: Direction<$arithmetic<SIZE>>,
                n: U32F32,
            ) -> Result<Self, ParameterError> {
                let bits = match exponent::fixed(n) {
                    Ok(bits) => bits,
                    Err(error) => return Err(error),
                };
                Ok(Self {
                    lamp,
                    back,
                    lobe: $arithmetic::<SIZE>::stored_power(bits),
                })
            }
        }
    };
}

in_fixed_point!(Q31);
in_fixed_point!(Q15);
