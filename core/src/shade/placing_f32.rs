//! Places in single precision.

use super::{Placing, Sphere};
use crate::arithmetic::{Arithmetic, Float, Math};
use crate::geometry::Direction;

impl<M: Math> Placing for Float<M> {
    type Place = [f32; 3];
    type Dimming = f32;

    #[inline]
    fn place(d: &Direction<Self>, depth: f32) -> [f32; 3] {
        [d.x * depth, d.y * depth, d.z * depth]
    }

    #[inline]
    fn odd_stripe(eye: f32, across: &[f32; 3], d: &Direction<Self>, depth: f32) -> bool {
        let slope = across[0] * d.x + across[1] * d.y + across[2] * d.z;
        let position = eye + depth * slope;
        // The conversion saturates: next to the horizon, where no stripe is
        // as wide as a pixel.
        let towards_zero = position as i32;
        let below = position < towards_zero as f32;
        towards_zero.wrapping_sub(i32::from(below)) & 1 != 0
    }

    #[inline]
    fn towards(place: &[f32; 3], lamp: &[f32; 3], near: f32) -> (Direction<Self>, f32) {
        let to = [0, 1, 2].map(|i| lamp[i] - place[i]);
        let inverse = 1.0 / M::root(Self::square(to));
        let [x, y, z] = to.map(|component| component * inverse);
        let reach = near * inverse;
        // `min` takes what is not a number to 1; then no cosine is a number,
        // either, and the share is 0.
        (Direction::new(x, y, z), (reach * reach).min(1.0))
    }

    #[inline]
    fn hides(
        sphere: &Sphere<Self>,
        place: &[f32; 3],
        l: &Direction<Self>,
        lamp: Option<&[f32; 3]>,
    ) -> bool {
        let from = [0, 1, 2].map(|i| place[i] + sphere.eye[i] * sphere.radius);
        let along = |v: [f32; 3]| v[0] * l.x + v[1] * l.y + v[2] * l.z;
        let ahead = -along(from);
        if ahead <= 0.0 {
            return false;
        }
        let [x, y, z] = from;
        let aside = [y * l.z - z * l.y, z * l.x - x * l.z, x * l.y - y * l.x];
        // A lamp before the nearest point is hidden only within the sphere.
        let beyond = match lamp {
            Some(lamp) => (ahead - along([0, 1, 2].map(|i| lamp[i] - place[i]))).max(0.0),
            None => 0.0,
        };
        // All lengths are |l| times what they are: `micromath`'s is not quite 1.
        let radius = sphere.radius * sphere.radius;
        Self::square(aside) + beyond * beyond < radius * Self::square([l.x, l.y, l.z])
    }

    #[inline]
    fn narrow(dimming: f32, share: f32) -> f32 {
        dimming * share
    }

    #[inline]
    fn dim(share: f32, dimming: f32) -> f32 {
        share * dimming
    }
}
