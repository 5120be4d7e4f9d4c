//! Normals in three or four bytes: points of an octahedron, unfolded.

use super::Tracing;
use crate::geometry::Direction;

/// A stored unit vector: the octahedron |x| + |y| + |z| = 1, its lower half
/// folded outwards, is a square, of which two coordinates are kept.
///
/// Q. Meyer, J. Süßmuth, G. Sußner, M. Stamminger, G. Greiner, "On
/// Floating-Point Normal Vectors", Computer Graphics Forum 29 (4), 2010.
pub trait Octahedral: Copy {
    /// Greatest magnitude of a coordinate, which stands for 1.
    const GREATEST: i32;
    /// log2 of what makes 2³⁰ of `GREATEST`, nearly.
    const SHIFT: u32;

    /// From two coordinates within ±`GREATEST`.
    #[must_use]
    fn from_coordinates(coordinates: [i32; 2]) -> Self;

    /// The two coordinates, at most a step beyond ±`GREATEST`.
    #[must_use]
    fn coordinates(self) -> [i32; 2];

    /// The vector that they stand for, of any length: |x| + |y| + |z| is 2³⁰,
    /// or a step more or less.
    #[inline]
    #[must_use]
    fn vector(self) -> [i32; 3] {
        let [x, y] = self.coordinates();
        let z = Self::GREATEST - x.abs() - y.abs();
        // What was folded outwards goes back by as much as z is below 0.
        let fold = z.min(0);
        let back = |c: i32| if c < 0 { c - fold } else { c + fold };
        [back(x), back(y), z].map(|c| c << Self::SHIFT)
    }

    /// The unit vector.
    #[inline]
    #[must_use]
    fn normal<A: Tracing>(self) -> Direction<A> {
        A::normalised(self.vector())
    }
}

/// Twelve bits for each coordinate: within 6.91e-4 rad, tested in
/// `tests/tests/mesh.rs`.
impl Octahedral for [u8; 3] {
    const GREATEST: i32 = 2047;
    const SHIFT: u32 = 19;

    #[inline]
    fn from_coordinates([x, y]: [i32; 2]) -> Self {
        let twelve = |c: i32| (c.wrapping_add(2048) & 0xFFF) as u32;
        let word = twelve(y) << 12 | twelve(x);
        let [low, middle, high, _] = word.to_le_bytes();
        [low, middle, high]
    }

    #[inline]
    fn coordinates(self) -> [i32; 2] {
        let [low, middle, high] = self.map(i32::from);
        let x = (middle & 15) << 8 | low;
        let y = high << 4 | middle >> 4;
        [x - 2048, y - 2048]
    }
}

/// Sixteen bits for each coordinate: within 4.32e-5 rad, tested in
/// `tests/tests/mesh.rs`.
impl Octahedral for [i16; 2] {
    const GREATEST: i32 = 32_767;
    const SHIFT: u32 = 15;

    #[inline]
    fn from_coordinates(coordinates: [i32; 2]) -> Self {
        coordinates.map(|c| c as i16)
    }

    #[inline]
    fn coordinates(self) -> [i32; 2] {
        self.map(i32::from)
    }
}
