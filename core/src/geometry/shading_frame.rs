//! Directions given in the shading frame.

use super::{Direction, Geometry};
use crate::arithmetic::Arithmetic;

/// L and V with respect to the surface: the normal is +z.
///
/// Here R − V = (−(Lx+Vx), −(Ly+Vy), Lz−Vz): only sums, exact in fixed point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadingFrame<A: Arithmetic> {
    /// To the light.
    pub l: Direction<A>,
    /// To the viewer.
    pub v: Direction<A>,
}

impl<A: Arithmetic> ShadingFrame<A> {
    /// The pair of `l`, to the light, and `v`, to the viewer.
    #[inline]
    pub const fn new(l: Direction<A>, v: Direction<A>) -> Self {
        Self { l, v }
    }
}

impl<A: Arithmetic> Geometry<A> for ShadingFrame<A> {
    #[inline]
    fn cosines(&self) -> (A::Cosine, A::Cosine) {
        (self.l.cosine(), self.v.cosine())
    }

    #[inline]
    fn versine(&self) -> A::Versine {
        let (l, v) = (&self.l, &self.v);
        A::half(A::square([
            A::sum(l.x, v.x),
            A::sum(l.y, v.y),
            A::difference(l.z, v.z),
        ]))
    }

    #[inline]
    fn retro_versine(&self) -> A::Versine {
        super::retro_versine(&self.l, &self.v)
    }

    #[inline]
    fn separation(&self) -> A::Separation {
        let (l, v) = (&self.l, &self.v);
        A::square([A::sum(l.x, v.x), A::sum(l.y, v.y)])
    }
}
