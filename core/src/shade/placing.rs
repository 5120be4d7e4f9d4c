//! The steps that need a place: checkers, lamps, shadows.

use core::fmt::Debug;

use super::{Sphere, Tracing};
use crate::geometry::Direction;

/// An arithmetic that can also tell where a ray meets a shape. What does not
/// ask for the place never computes it.
pub trait Placing: Tracing {
    /// A point as seen from the eye, in scene units.
    type Place: Copy;
    /// The share in [0, 1] of a lamp's light that arrives, to a relative
    /// 2⁻¹⁵ or better.
    type Dimming: Copy + Debug;

    /// Where the ray `d` is after `depth`.
    fn place(d: &Self::Ray, depth: Self::Depth) -> Self::Place;
    /// Whether ⌊eye + depth · (across·d)⌋ is odd: the stripe that the ray
    /// meets, of stripes that are 1/|across| wide.
    fn odd_stripe(
        eye: Self::Fine,
        across: &[Self::Fine; 3],
        d: &Self::Ray,
        depth: Self::Depth,
    ) -> bool;
    /// Direction to a lamp, which is given as seen from the eye, and
    /// (near/distance)², at most 1. In the lamp itself the direction is of no
    /// unit length.
    fn towards(
        place: &Self::Place,
        lamp: &[Self::Length; 3],
        near: Self::Length,
    ) -> (Direction<Self>, Self::Dimming);
    /// Whether a sphere stands between a place, which is not within it, and a
    /// light in the direction `l`: a lamp, as seen from the eye, or one at
    /// infinity. A place upon the sphere counts as hidden where the light is
    /// below its horizon.
    ///
    /// The light's ray passes the centre at |from × l|, `from` leading from the
    /// centre to the place; that is compared with the radius, so that nothing
    /// cancels at the edge.
    fn hides(
        sphere: &Sphere<Self>,
        place: &Self::Place,
        l: &Direction<Self>,
        lamp: Option<&[Self::Length; 3]>,
    ) -> bool;
    /// dimming · share.
    fn narrow(dimming: Self::Dimming, share: Self::Unit) -> Self::Dimming;
    /// share · dimming.
    fn dim(share: Self::Unit, dimming: Self::Dimming) -> Self::Unit;
}
