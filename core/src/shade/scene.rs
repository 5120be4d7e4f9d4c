//! A scene, shaded row by row.

use super::shadow::Met;
use super::{
    Camera, Ground, Light, Linear, NoView, OneSample, Placing, Plane, Samples, Shadows, Sphere,
    Surface, Tracing, Unshadowed, View,
};
use crate::geometry::Direction;

/// Everything that a picture is computed from. `S` is the type of its
/// materials: an enum of all models on a host, of just the scene's own on a
/// microcontroller; the row function is the same. `P`, `L` and `V` are those of
/// its planes, lights and view in the same way.
#[derive(Clone, Copy, Debug)]
pub struct Scene<
    'a,
    A: Tracing,
    S,
    P = Plane<A>,
    L = Direction<A>,
    V = NoView,
    H = Unshadowed,
    N = OneSample,
> {
    /// Where it is seen from; with [`FourSamples`](super::FourSamples) it has
    /// four columns and four rows for each of the picture's.
    pub camera: Camera<A>,
    /// What was resolved beforehand, and hides all that follows.
    pub view: V,
    /// Its spheres.
    pub spheres: &'a [Sphere<A>],
    /// Its planes.
    pub planes: &'a [P],
    /// Its lights.
    pub lights: &'a [L],
    /// Its materials; a shape whose index is past the end is black.
    pub materials: &'a [S],
    /// What a ray that meets nothing sees.
    pub background: Linear,
    /// Whether its spheres throw shadows.
    pub shadows: H,
    /// How many rays a pixel is made of.
    pub samples: N,
}

impl<A, S, P, L, V, H, N> Scene<'_, A, S, P, L, V, H, N>
where
    A: Placing,
    S: Surface<A>,
    P: Ground<A>,
    L: Light<A>,
    V: View<A>,
    H: Shadows,
    N: Samples,
{
    /// Shades row `y`, counted from the top, and hands each pixel with its
    /// column to `sink`, from left to right.
    #[inline]
    pub fn shade_row(&self, y: usize, mut sink: impl FnMut(usize, Linear)) {
        for x in 0..usize::from(self.camera.width / self.samples.side()) {
            sink(x, self.shade_pixel(x, y));
        }
    }

    /// Shades the pixel in column `x` of row `y`, counted from the top left.
    #[inline]
    #[must_use]
    pub fn shade_pixel(&self, x: usize, y: usize) -> Linear {
        self.samples.pixel(x, y, |x, y| self.seen(x, y))
    }

    /// What the camera sees in column `x` of its row `y`.
    #[inline]
    fn seen(&self, x: usize, y: usize) -> Linear {
        let resolved = self.view.at(x, y);
        if resolved.is_none() && self.is_empty(x, y) {
            return self.background;
        }
        let d = A::ray(&self.camera, x, y);
        let seen = resolved.or_else(|| self.first_hit(&d, x, y));
        let Some((depth, normal, material)) = seen else {
            return self.background;
        };
        let Some(surface) = self.materials.get(usize::from(material)) else {
            return Linear::default();
        };
        let met = Met {
            place: || A::place(&d, depth),
            spheres: self.spheres,
            shadows: self.shadows,
        };
        A::linear(surface.light(&normal, &A::reverse(&d), self.lights, &met))
    }

    /// Whether no shape can be there: not even the ray is needed then.
    #[inline]
    fn is_empty(&self, x: usize, y: usize) -> bool {
        self.planes.is_empty() && !self.spheres.iter().any(|sphere| sphere.extent.holds(x, y))
    }

    /// Depth, normal and material of what the ray meets first.
    #[inline]
    fn first_hit(&self, d: &A::Ray, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        let near = self
            .spheres
            .iter()
            .filter(|sphere| sphere.extent.holds(x, y));
        let spheres = near.map(|sphere| sphere.hit(d));
        let planes = self.planes.iter().map(|plane| plane.hit(d));
        let mut first: Option<(A::Depth, Direction<A>, u8)> = None;
        for hit in spheres.chain(planes) {
            let Some(hit) = hit else { continue };
            if first.is_none_or(|(nearest, ..)| hit.0 < nearest) {
                first = Some(hit);
            }
        }
        first
    }
}
