//! A scene, shaded row by row.

use super::{
    Camera, Ground, Light, Linear, NoView, Placing, Plane, Sphere, Surface, Tracing, View,
};
use crate::geometry::Direction;

/// Everything that a picture is computed from. `S` is the type of its
/// materials: an enum of all models on a host, of just the scene's own on a
/// microcontroller; the row function is the same. `P`, `L` and `V` are those of
/// its planes, lights and view in the same way.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, A: Tracing, S, P = Plane<A>, L = Direction<A>, V = NoView> {
    /// Where it is seen from.
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
}

impl<A, S, P, L, V> Scene<'_, A, S, P, L, V>
where
    A: Placing,
    S: Surface<A>,
    P: Ground<A>,
    L: Light<A>,
    V: View<A>,
{
    /// Shades row `y`, counted from the top, and hands each pixel with its
    /// column to `sink`, from left to right.
    #[inline]
    pub fn shade_row(&self, y: usize, mut sink: impl FnMut(usize, Linear)) {
        for x in 0..usize::from(self.camera.width) {
            sink(x, self.shade_pixel(x, y));
        }
    }

    /// Shades the pixel in column `x` of row `y`, counted from the top left.
    #[inline]
    #[must_use]
    pub fn shade_pixel(&self, x: usize, y: usize) -> Linear {
        let d = A::ray(&self.camera, x, y);
        let seen = self.view.at(x, y).or_else(|| self.first_hit(&d));
        let Some((depth, normal, material)) = seen else {
            return self.background;
        };
        let Some(surface) = self.materials.get(usize::from(material)) else {
            return Linear::default();
        };
        let place = || A::place(&d, depth);
        A::linear(surface.light(&normal, &A::reverse(&d), self.lights, place))
    }

    /// Depth, normal and material of what the ray meets first.
    #[inline]
    fn first_hit(&self, d: &A::Ray) -> Option<(A::Depth, Direction<A>, u8)> {
        let spheres = self.spheres.iter().map(|sphere| sphere.hit(d));
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
