//! Directions given in any frame, with the normal.

use super::{Direction, Geometry};
use crate::arithmetic::Arithmetic;

/// N, L and V in world space, all unit vectors of one frame.
///
/// [`Arithmetic::world_versine`] says how 1 − R·V keeps its digits near the
/// mirror direction, where it is the difference of two numbers. Each cosine carries
/// the absolute error of a dot product (f32: 8e-8), so grazing cosines below
/// 1e-4 are better handed over in a shading frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<A: Arithmetic> {
    normal: Direction<A>,
    l: Direction<A>,
    v: Direction<A>,
    products: (A::Product, A::Product),
}

impl<A: Arithmetic> World<A> {
    /// The pair of `l`, to the light, and `v`, to the viewer, at a surface
    /// with normal `n`.
    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    pub fn new(n: Direction<A>, l: Direction<A>, v: Direction<A>) -> Self {
        Self {
            normal: n,
            l,
            v,
            products: A::products(&n, &l, &v),
        }
    }

    /// As [`Self::new`], where N·V is known: with several lights it is the
    /// same for all.
    #[inline]
    pub fn with_cosine(
        n: Direction<A>,
        l: Direction<A>,
        v: Direction<A>,
        n_dot_v: A::Cosine,
    ) -> Self {
        Self {
            normal: n,
            l,
            v,
            products: (A::product_of(A::dot(&n, &l)), A::product_of(n_dot_v)),
        }
    }
}

impl<A: Arithmetic> Geometry<A> for World<A> {
    const DEAR: bool = true;

    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    fn cosines(&self) -> (A::Cosine, A::Cosine) {
        (A::cosine(self.products.0), A::cosine(self.products.1))
    }

    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    fn products(&self) -> (A::Product, A::Product) {
        self.products
    }

    #[cfg_attr(long_multiply, inline)]
    #[cfg_attr(not(long_multiply), inline(always))]
    fn versine(&self) -> A::Versine {
        A::world_versine(&self.normal, &self.l, &self.v, self.products)
    }

    #[inline]
    fn retro_versine(&self) -> A::Versine {
        super::retro_versine(&self.l, &self.v)
    }

    #[inline]
    fn separation(&self) -> A::Separation {
        A::world_separation(&self.normal, &self.l, &self.v, self.products)
    }
}
