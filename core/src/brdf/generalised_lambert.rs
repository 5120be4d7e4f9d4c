//! Generalised Lambert (4.59).

use super::Shape;
use super::foreshortening::Flat;
use super::lambert::Lambert;
use crate::arithmetic::Arithmetic;
use crate::colour::Rgb;
use crate::geometry::Geometry;
use crate::table::SquareCurve;

/// f = a · C · min((1 − m²/4)^(−d/2), ξmax) (4.58, 4.59): a matt surface that
/// darkens less towards its rim than Lambert's law, for an albedo a of red,
/// green and blue.
///
/// The peak is C · ξmax in sr⁻¹, and the share a · ξ/ξmax · cosΘL. C, which
/// keeps the greatest albedo at a, is an integral: the host computes it with
/// the table of ξ/ξmax
/// (`microbrdf_reference::models::GeneralisedLambert`). The table has a knot
/// at the clip; between its knots ξ is within 4e-4 of ξmax for clips from m = 1
/// to 1.9, tested in `tests/tests/tables.rs`. An `f32` component that is not a
/// number makes the share 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralisedLambert<A: Arithmetic> {
    body: Lambert<A>,
    profile: SquareCurve,
    peak: A::Scale,
}

impl<A: Arithmetic> GeneralisedLambert<A> {
    /// `profile` is ξ/ξmax over m², `peak` C · ξmax; the albedo is that of
    /// `body`.
    #[must_use]
    pub const fn new(body: Lambert<A>, profile: SquareCurve, peak: A::Scale) -> Self {
        Self {
            body,
            profile,
            peak,
        }
    }
}

impl<A: Arithmetic> Shape for GeneralisedLambert<A> {
    type Arithmetic = A;
    type Foreshortening = Flat;

    #[inline]
    fn amplitude(&self) -> A::Scale {
        self.peak
    }

    #[inline]
    fn foreshortening(&self) -> &Flat {
        &Flat
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<A>) -> A::Unit {
        A::square_profile(&self.profile, geometry.separation())
    }

    #[inline]
    fn coloured(&self, share: A::Unit, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        self.body.coloured(share, geometry)
    }
}
