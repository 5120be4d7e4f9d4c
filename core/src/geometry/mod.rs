//! What a model needs to know of two directions.

mod direction;
mod shading_frame;
mod short_world;
mod world;

pub use direction::Direction;
pub use shading_frame::ShadingFrame;
pub use short_world::{Products, ShortWorld};
pub use world::World;

use crate::arithmetic::Arithmetic;

/// Two directions at a surface, L to the light and V to the viewer, and the
/// four scalars that every model of this crate is a function of.
///
/// All of them are symmetric in L and V, bit for bit, which makes the models
/// reciprocal. R is L mirrored at the normal.
pub trait Geometry<A: Arithmetic> {
    /// N·L and N·V.
    fn cosines(&self) -> (A::Cosine, A::Cosine);
    /// 1 − R·V, as |R − V|²/2: no cancellation near the mirror direction.
    fn versine(&self) -> A::Versine;
    /// 1 − L·V, as |L − V|²/2.
    fn retro_versine(&self) -> A::Versine;
    /// m²: squared distance of the projections of R and V on the base plane
    /// (4.1).
    fn separation(&self) -> A::Separation;
}

/// 1 − L·V: half the square of L − V.
#[inline]
pub(crate) fn retro_versine<A: Arithmetic>(l: &Direction<A>, v: &Direction<A>) -> A::Versine {
    A::half(A::square([
        A::difference(l.x, v.x),
        A::difference(l.y, v.y),
        A::difference(l.z, v.z),
    ]))
}
