//! Mixtures of patches with any profile ξ(m) (4.39).

use super::Shape;
use super::foreshortening::Flat;
use crate::arithmetic::Arithmetic;
use crate::geometry::Geometry;
use crate::table::ProfileCurve;

/// f = C · ξ(m): a mixture of patch BRDFs whose profile is a table.
///
/// The constant C, in sr⁻¹, which keeps the greatest albedo at 1, is an
/// integral over the whole profile: the host computes it with the table
/// (`microbrdf_reference::models::PatchProfile`). An `f32` component that is not a
/// number makes the share 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchProfile<A: Arithmetic> {
    profile: ProfileCurve,
    peak: A::Scale,
}

impl<A: Arithmetic> PatchProfile<A> {
    /// The mixture of the profile `profile` with the constant `peak`.
    #[must_use]
    pub const fn new(profile: ProfileCurve, peak: A::Scale) -> Self {
        Self { profile, peak }
    }
}

impl<A: Arithmetic> Shape for PatchProfile<A> {
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
        A::free_profile(&self.profile, geometry.separation())
    }
}
