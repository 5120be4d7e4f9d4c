//! What keeps a light from a place.

use microbrdf_scene::Description;
use microbrdf_scene::vector::{cross, dot, length};

use super::hit::Object;

/// Whether anything but `own` stands within `reach` of a place in the
/// direction `l`, and the angle by which `l` must turn to pass the nearest
/// edge of a sphere.
pub(super) fn hidden(
    description: &Description,
    own: Object,
    place: [f64; 3],
    l: [f64; 3],
    reach: f64,
) -> (bool, f64) {
    let mut hidden = false;
    let mut angle = f64::INFINITY;
    for (index, sphere) in description.spheres.iter().enumerate() {
        if own == Object::Sphere(index) {
            continue;
        }
        let to = [0, 1, 2].map(|i| sphere.center[i] - place[i]);
        let distance = length(to);
        let ahead = dot(to, l);
        let aside = length(cross(to, l));
        let half = sphere.radius.powi(2) - aside.powi(2);
        hidden |= ahead > 0.0 && half > 0.0 && ahead - half.sqrt() < reach;
        if ahead > 0.0 && ahead - sphere.radius < reach {
            angle = angle.min((aside - sphere.radius).abs() / distance);
        }
    }
    for (index, plane) in description.planes.iter().enumerate() {
        let from = [0, 1, 2].map(|i| place[i] - plane.point[i]);
        let descent = -dot(plane.normal, l);
        hidden |= own != Object::Plane(index)
            && descent > 0.0
            && dot(from, plane.normal) / descent < reach;
    }
    (hidden, angle)
}
