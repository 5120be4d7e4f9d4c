//! R − V in any frame, coordinate by coordinate, for arithmetics that round the
//! product of a cosine and a component to the bits that the component has.

use super::Arithmetic;
use crate::geometry::Direction;

/// Arithmetics whose numbers are fine enough that L + V loses its part along N
/// in each coordinate by itself.
///
/// With h = L + V, R − V has the projection h_P = h − (N·h)N on the base plane
/// and the height N·L − N·V: sums of small things near the mirror direction,
/// where 1 − R·V would lose all its digits.
pub(super) trait Projection: Arithmetic {
    /// One coordinate of h_P: l + v − (N·L + N·V)·n.
    fn tangential(
        n: Self::Component,
        l: Self::Component,
        v: Self::Component,
        cosines: (Self::Cosine, Self::Cosine),
    ) -> Self::Offset;

    /// h_P.
    #[inline]
    fn projected(
        n: &Direction<Self>,
        l: &Direction<Self>,
        v: &Direction<Self>,
        cosines: (Self::Cosine, Self::Cosine),
    ) -> [Self::Offset; 3] {
        [
            Self::tangential(n.x, l.x, v.x, cosines),
            Self::tangential(n.y, l.y, v.y, cosines),
            Self::tangential(n.z, l.z, v.z, cosines),
        ]
    }

    /// 1 − R·V.
    #[inline]
    fn versine_by_coordinates(
        n: &Direction<Self>,
        l: &Direction<Self>,
        v: &Direction<Self>,
        cosines: (Self::Cosine, Self::Cosine),
    ) -> Self::Versine {
        let [x, y, z] = Self::projected(n, l, v, cosines);
        Self::half(Self::square([x, y, z, Self::height(cosines.0, cosines.1)]))
    }
}
