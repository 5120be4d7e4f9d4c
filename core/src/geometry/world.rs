//! Directions given in any frame, with the normal.

use super::{Direction, Geometry};
use crate::arithmetic::Arithmetic;

/// N, L and V in world space, all unit vectors of one frame.
///
/// With h = L + V, R − V has the projection h_P = h − (N·h)N on the base
/// plane and the height N·L − N·V: a sum of small things near the mirror
/// direction, where 1 − R·V would lose all its digits. Each cosine carries
/// the absolute error of a dot product (f32: 8e-8), so grazing cosines below
/// 1e-4 are better handed over in a shading frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct World<A: Arithmetic> {
    normal: Direction<A>,
    l: Direction<A>,
    v: Direction<A>,
    cosines: (A::Cosine, A::Cosine),
}

impl<A: Arithmetic> World<A> {
    /// The pair of `l`, to the light, and `v`, to the viewer, at a surface
    /// with normal `n`.
    #[inline]
    pub fn new(n: Direction<A>, l: Direction<A>, v: Direction<A>) -> Self {
        Self::with_cosine(n, l, v, A::dot(&n, &v))
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
            cosines: (A::dot(&n, &l), n_dot_v),
        }
    }

    /// h_P, the sum of L and V without its part along the normal.
    #[inline]
    fn projected_sum(&self) -> [A::Offset; 3] {
        let (n, l, v) = (&self.normal, &self.l, &self.v);
        [
            A::tangential(n.x, l.x, v.x, self.cosines),
            A::tangential(n.y, l.y, v.y, self.cosines),
            A::tangential(n.z, l.z, v.z, self.cosines),
        ]
    }
}

impl<A: Arithmetic> Geometry<A> for World<A> {
    #[inline]
    fn cosines(&self) -> (A::Cosine, A::Cosine) {
        self.cosines
    }

    #[inline]
    fn versine(&self) -> A::Versine {
        let [x, y, z] = self.projected_sum();
        A::half(A::square_of_rounded([
            x,
            y,
            z,
            A::height(self.cosines.0, self.cosines.1),
        ]))
    }

    #[inline]
    fn retro_versine(&self) -> A::Versine {
        super::retro_versine(&self.l, &self.v)
    }

    #[inline]
    fn separation(&self) -> A::Separation {
        A::square_of_rounded(self.projected_sum())
    }
}
