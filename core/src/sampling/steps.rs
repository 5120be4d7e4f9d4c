//! The steps of which every sampler is made.

use core::fmt::Debug;

use crate::arithmetic::Arithmetic;
use crate::geometry::Direction;

/// The steps of sampling in one way to compute.
pub trait Sampling: Arithmetic {
    /// A random number in [0, 1).
    type Uniform: Copy + Debug;
    /// A stored 1/(n + 1).
    type Concentration: Copy + Debug + PartialEq;
    /// How far from a lobe's axis: the versine of the angle and its sine.
    type Cap: Copy;
    /// What a distance of density ∝ m·e^(−s·m) on [0, 1] is drawn with.
    type Spread: Copy + Debug + PartialEq;

    /// The coordinate 0.
    const COMPONENT_ZERO: Self::Component;
    /// The cosine 1.
    const COSINE_ONE: Self::Component;
    /// The factor 1.
    const SCALE_ONE: Self::Scale;
    /// The squared distance 1.
    const SEPARATION_ONE: Self::Separation;

    /// a / b for b > 0.
    fn quotient(a: Self::Scale, b: Self::Scale) -> Self::Scale;
    /// R for V, V for R: mirrored at the normal.
    fn mirrored(direction: &Direction<Self>) -> Direction<Self>;

    /// The cap that holds the share `u` of a cosⁿα lobe (3.20): 1 − cos α
    /// = 1 − (1 − u)^(1/(n+1)), without cancellation.
    fn cap(stored: &Self::Concentration, u: Self::Uniform) -> Self::Cap;
    /// The direction at a cap's edge about an axis that is not below the
    /// horizon, turned by `u` of a whole turn.
    fn about(axis: &Direction<Self>, cap: Self::Cap, u: Self::Uniform) -> Direction<Self>;

    /// radius·√u, the distance of a uniform point of a disc from its centre;
    /// for a radius in [0, 1].
    fn root(radius: Self::Component, u: Self::Uniform) -> Self::Component;
    /// The distance m in [0, 1] below which lies the share `u` of the density
    /// ∝ m·e^(−s·m).
    fn spread(stored: &Self::Spread, u: Self::Uniform) -> Self::Component;
    /// The point at a distance from the origin, turned by `u` of a whole
    /// turn.
    fn circle(radius: Self::Component, u: Self::Uniform) -> [Self::Component; 2];
    /// The direction whose projection is `offset` from that of R; `None`
    /// where that lies outside the base circle.
    fn beside(v: &Direction<Self>, offset: [Self::Component; 2]) -> Option<Direction<Self>>;
    /// The direction above a point of the base circle (4.17).
    fn raised(point: [Self::Component; 2]) -> Direction<Self>;
    /// (√a − √b)² for a ≥ b.
    fn step_back(a: Self::Separation, b: Self::Separation) -> Self::Separation;
}

// The m below which lies a share of the density ∝ m·e^(−s·m) solves
// x − ln(1 + x) = y for x = s·m and y = −ln(1 − share·mass): x is a smooth
// function of q = √(2y), the lower branch of Lambert's W.

/// For s < 1/2 (q < 0.45): x over √(2·share·mass), in powers of q, 29 fraction
/// bits; relative error 4e-9, fitted at Chebyshev's nodes.
pub(super) const BROAD: [i32; 5] = [536870912, 178956842, 82025347, 20348806, 3522480];

/// For q to 6.8: x/q in powers of q/8, 29 fraction bits; relative error 1.2e-6.
pub(super) const NARROW: [i32; 7] = [
    536871518,
    1431528210,
    958761203,
    -1074550196,
    887498540,
    -459922831,
    109106634,
];
