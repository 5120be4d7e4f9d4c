//! The steps that find out what a pixel sees.

use core::fmt::Debug;

use super::Camera;
use crate::arithmetic::Arithmetic;
use crate::geometry::Direction;

/// An arithmetic that can also intersect rays with the shapes of a scene.
///
/// Positions never appear: a shape holds where the eye is as seen from it, so
/// that nothing cancels. A sphere's lengths are in units of its radius.
pub trait Tracing: Arithmetic {
    /// The unit vector in which a pixel looks, as finely as tracing needs.
    type Ray;
    /// A length in the scene, or in radii of a sphere: |length| < 128.
    type Length: Copy + Debug + PartialEq + PartialOrd;
    /// A camera's steps, below 4, fine enough to add a thousand of them.
    type Fine: Copy + Debug + PartialEq;
    /// A coordinate within a unit sphere, −2 … 2.
    type Near: Copy;
    /// Distance along a ray.
    type Depth: Copy + Default + PartialOrd;

    /// The unit vector in which pixel (x, y) looks.
    fn ray(camera: &Camera<Self>, x: usize, y: usize) -> Self::Ray;
    /// −d: V.
    fn reverse(d: &Self::Ray) -> Direction<Self>;
    /// Distance along the ray `d` to its point nearest to a sphere's centre;
    /// `eye` is the eye as seen from the centre.
    fn along(eye: &[Self::Length; 3], d: &Self::Ray) -> Self::Length;
    /// That point as seen from the centre; `None` where a coordinate is not
    /// within a radius or two.
    fn nearest(
        eye: &[Self::Length; 3],
        d: &Self::Ray,
        along: Self::Length,
    ) -> Option<[Self::Near; 3]>;
    /// √(1 − |nearest|²), half of the ray's chord; `None` outside the sphere.
    fn half_chord(nearest: &[Self::Near; 3]) -> Option<Self::Near>;
    /// nearest − half chord · d: where the ray enters, which is the normal.
    fn entry(nearest: &[Self::Near; 3], half: Self::Near, d: &Self::Ray) -> Direction<Self>;
    /// radius · (along − half chord); `None` behind the eye.
    fn sphere_depth(
        radius: Self::Length,
        along: Self::Length,
        half: Self::Near,
    ) -> Option<Self::Depth>;
    /// height / −(N·d); `None` where the ray does not descend.
    fn plane_depth(
        height: Self::Length,
        normal: &Direction<Self>,
        d: &Self::Ray,
    ) -> Option<Self::Depth>;

    /// The unit vector along a vector whose coordinates are whole numbers and
    /// have magnitudes that add up to about 2³⁰.
    fn normalised(vector: [i32; 3]) -> Direction<Self>;
    /// near + range · code/2¹⁶.
    fn stored_depth(near: Self::Length, range: Self::Length, code: u16) -> Self::Depth;
}
