//! Numbers of neighbouring pixels.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

use ::wide::{CmpGe, CmpGt, CmpLe, CmpLt, f32x8};
use microbrdf::arithmetic::Float;
use microbrdf::geometry::Direction;

use super::Wide;
use crate::host::Native;

/// How many pixels.
pub(super) const WIDTH: usize = 8;

/// What each of them is computed in.
pub(super) type One = Float<Native>;

/// A number for each pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lanes(pub(super) f32x8);

/// Some of the pixels: all bits of each, or none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Which(f32x8);

impl Lanes {
    pub(super) const ZERO: Self = Self::all(0.0);
    pub(super) const ONE: Self = Self::all(1.0);

    /// The same for all.
    pub(super) const fn all(value: f32) -> Self {
        Self(f32x8::new([value; WIDTH]))
    }

    /// A number of each pixel, by itself.
    #[inline(always)]
    pub(super) fn of(number: impl Fn(usize) -> f32) -> Self {
        Self(f32x8::from(std::array::from_fn(number)))
    }

    /// Each by itself.
    #[inline(always)]
    pub(super) fn array(self) -> [f32; WIDTH] {
        self.0.to_array()
    }

    /// `step` of each number, by itself.
    #[inline(always)]
    pub(super) fn map(self, step: impl Fn(f32) -> f32) -> Self {
        Self(f32x8::from(self.array().map(step)))
    }

    /// `step` of each two numbers.
    #[inline(always)]
    pub(super) fn zip(self, other: Self, step: impl Fn(f32, f32) -> f32) -> Self {
        let (a, b) = (self.array(), other.array());
        Self(f32x8::from(std::array::from_fn(|i| step(a[i], b[i]))))
    }

    #[inline(always)]
    pub(super) fn root(self) -> Self {
        Self(self.0.sqrt())
    }

    /// The other sign, of 0, too.
    #[inline(always)]
    pub(super) fn negative(self) -> Self {
        Self(self.0 ^ f32x8::new([-0.0; WIDTH]))
    }

    #[inline(always)]
    pub(super) fn above(self, other: Self) -> Which {
        Which(self.0.cmp_gt(other.0))
    }
    #[inline(always)]
    pub(super) fn below(self, other: Self) -> Which {
        Which(self.0.cmp_lt(other.0))
    }
    #[inline(always)]
    pub(super) fn at_least(self, other: Self) -> Which {
        Which(self.0.cmp_ge(other.0))
    }
    #[inline(always)]
    pub(super) fn at_most(self, other: Self) -> Which {
        Which(self.0.cmp_le(other.0))
    }
    /// Those that are numbers.
    #[inline(always)]
    pub(super) fn numbers(self) -> Which {
        self.at_most(self)
    }
}

macro_rules! operator {
    ($trait:ident $function:ident) => {
        impl $trait for Lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        }
    };
}

operator!(Add add);
operator!(Sub sub);
operator!(Mul mul);
operator!(Div div);

/// As of arrays.
impl PartialOrd for Lanes {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.array().partial_cmp(&other.array())
    }
}

impl Which {
    #[inline(always)]
    pub(super) fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
    #[inline(always)]
    pub(super) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    /// Whether there is one.
    #[inline(always)]
    pub(super) fn any(self) -> bool {
        self.0.any()
    }
    /// `value` for these, `other` for the others.
    #[inline(always)]
    pub(super) fn choose(self, value: Lanes, other: Lanes) -> Lanes {
        Lanes(self.0.blend(value.0, other.0))
    }
    /// `value` for these, 0 for the others.
    #[inline(always)]
    pub(super) fn or_zero(self, value: Lanes) -> Lanes {
        Lanes(self.0 & value.0)
    }
    /// `value` for these, no number for the others.
    #[inline(always)]
    pub(super) fn or_none(self, value: Lanes) -> Lanes {
        self.choose(value, Lanes::all(f32::NAN))
    }
}

/// The same direction for all.
pub(super) fn all(direction: Direction<One>) -> Direction<Wide> {
    let Direction { x, y, z } = direction;
    Direction::new(Lanes::all(x), Lanes::all(y), Lanes::all(z))
}
