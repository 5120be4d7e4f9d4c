//! What a pixel sees of shapes that are not traced: tables made on a host.

use super::{Octahedral, Tracing};
use crate::geometry::Direction;

/// What is known of each pixel before anything is traced.
pub trait View<A: Tracing> {
    /// Depth, normal and material in column `x` of row `y`; `None` where the
    /// traced shapes decide.
    fn at(&self, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)>;
}

/// Nothing: every shape is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoView;

impl<A: Tracing> View<A> for NoView {
    #[inline]
    fn at(&self, _: usize, _: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        None
    }
}

/// A mesh as the scene's camera sees it, with what stands before it left out.
///
/// Pixels are kept in spans, row by row, and normals (and depths) only for
/// those. A table that contradicts itself shows less, and never panics:
/// `tests/tests/mesh.rs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshView<'a, N, D = NoDepths> {
    /// For each row its first span's index, and after the last row the number
    /// of spans.
    pub rows: &'a [u32],
    /// Spans, from left to right within a row.
    pub spans: &'a [Span],
    /// A normal for each pixel of each span.
    pub normals: &'a [N],
    /// The same for depths, where something asks for a place.
    pub depths: D,
}

/// Pixels of a row that lie side by side and have one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    start: u16,
    end: u16,
    /// The first normal's index, and in the upper eight bits the material's.
    first: u32,
}

impl Span {
    /// The columns from `start` to `end`, exclusive; `first` is the index of
    /// the first one's normal, below 2²⁴, and `material` the scene's.
    #[must_use]
    pub const fn new(start: u16, end: u16, first: u32, material: u8) -> Self {
        Self {
            start,
            end,
            first: (material as u32) << 24 | (first & 0x00FF_FFFF),
        }
    }

    /// `start`, `end`, `first` and `material`.
    #[must_use]
    pub const fn parts(&self) -> (u16, u16, u32, u8) {
        let (index, material) = (self.first & 0x00FF_FFFF, (self.first >> 24) as u8);
        (self.start, self.end, index, material)
    }
}

impl<A: Tracing, N: Octahedral, D: Depths<A>> View<A> for MeshView<'_, N, D> {
    #[inline]
    fn at(&self, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        let first = *self.rows.get(y)? as usize;
        let end = *self.rows.get(y.wrapping_add(1))? as usize;
        for span in self.spans.get(first..end)? {
            let (start, end, first, material) = span.parts();
            if x < usize::from(start) {
                return None;
            }
            if x < usize::from(end) {
                let index = (first as usize).wrapping_add(x - usize::from(start));
                let normal = self.normals.get(index)?.normal();
                return Some((self.depths.at(index), normal, material));
            }
        }
        None
    }
}

/// Distances of a view's pixels from the eye.
pub trait Depths<A: Tracing> {
    /// That of the pixel with this index among the normals.
    fn at(&self, index: usize) -> A::Depth;
}

/// For scenes in which nothing asks for a place: all are 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoDepths;

impl<A: Tracing> Depths<A> for NoDepths {
    #[inline]
    fn at(&self, _: usize) -> A::Depth {
        A::Depth::default()
    }
}

/// Two bytes a pixel, between the least and the greatest depth: off by at most
/// 2⁻¹⁷ of their difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoredDepths<'a, A: Tracing> {
    /// Least depth, in scene units.
    pub near: A::Length,
    /// How much more the code 2¹⁶ would mean.
    pub range: A::Length,
    /// Codes; beyond their end stands 0.
    pub codes: &'a [u16],
}

impl<A: Tracing> Depths<A> for StoredDepths<'_, A> {
    #[inline]
    fn at(&self, index: usize) -> A::Depth {
        A::stored_depth(
            self.near,
            self.range,
            self.codes.get(index).copied().unwrap_or(0),
        )
    }
}
