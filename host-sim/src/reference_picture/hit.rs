//! What a ray meets first, and how far it is from meeting something else.

use microbrdf_scene::vector::dot;
use microbrdf_scene::{Description, PlaneDescription, plane_axes};

/// What a ray was traced to.
#[derive(Clone, Copy)]
pub(super) struct Hit {
    pub(super) depth: f64,
    pub(super) normal: [f64; 3],
    pub(super) material: usize,
    /// Distance to an edge of a checker, as an angle.
    edge: f64,
    /// What throws no shadow on itself.
    pub(super) object: Object,
}

/// What stands in a scene.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Object {
    Sphere(usize),
    Plane(usize),
    Mesh,
}

/// What the ray in the direction `d` from the eye meets first, and the distance
/// to the nearest jump of the geometry; `x` and `y` are its pixel.
pub(super) fn first(
    description: &Description,
    d: [f64; 3],
    [x, y]: [usize; 2],
) -> (Option<Hit>, f64) {
    // What is seen of a mesh was resolved when the scene was read, for all
    // arithmetics alike: there it jumps nowhere.
    if let Some(seen) = description.view.as_ref().and_then(|view| view.at(x, y)) {
        let hit = Hit {
            depth: seen.depth,
            normal: seen.normal,
            material: seen.material,
            edge: f64::INFINITY,
            object: Object::Mesh,
        };
        return (Some(hit), f64::INFINITY);
    }
    let eye = description.camera.eye;
    let mut jump = f64::INFINITY;
    let mut hits: Vec<Hit> = Vec::new();
    for (index, sphere) in description.spheres.iter().enumerate() {
        let from = [0, 1, 2].map(|i| (eye[i] - sphere.center[i]) / sphere.radius);
        let along = -dot(from, d);
        let nearest = [0, 1, 2].map(|i| from[i] + along * d[i]);
        let square = dot(nearest, nearest);
        if along <= 0.0 {
            continue;
        }
        jump = jump.min((square.sqrt() - 1.0).abs());
        if square < 1.0 {
            let half = (1.0 - square).sqrt();
            let normal = [0, 1, 2].map(|i| nearest[i] - half * d[i]);
            let depth = sphere.radius * (along - half);
            hits.push(Hit {
                depth,
                normal,
                material: sphere.material,
                edge: f64::INFINITY,
                object: Object::Sphere(index),
            });
        }
    }
    for (index, plane) in description.planes.iter().enumerate() {
        let descent = -dot(plane.normal, d);
        jump = jump.min(descent.abs());
        if descent > 0.0 {
            let offset = [0, 1, 2].map(|i| eye[i] - plane.point[i]);
            let depth = dot(offset, plane.normal) / descent;
            let place = [0, 1, 2].map(|i| offset[i] + depth * d[i]);
            let (material, edge) = squares(plane, place);
            // A turn moves the place by up to depth / descent.
            let edge = edge * descent / depth;
            hits.push(Hit {
                depth,
                normal: plane.normal,
                material,
                edge,
                object: Object::Plane(index),
            });
        }
    }
    hits.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    if let [first, second, ..] = &hits[..] {
        jump = jump.min((second.depth - first.depth) / first.depth);
    }
    let first = hits.first().copied();
    (first, first.map_or(jump, |hit| jump.min(hit.edge)))
}

/// The material at a place, given as seen from the plane's point, and the
/// distance to the nearest edge of another.
fn squares(plane: &PlaneDescription, place: [f64; 3]) -> (usize, f64) {
    /// What rounding leaves of a coordinate on an edge, in squares.
    const ROUNDING: f64 = 1e-11;
    let Some(checker) = plane.checker else {
        return (plane.material, f64::INFINITY);
    };
    let positions = plane_axes(plane.normal).map(|axis| dot(place, axis) / checker.size);
    // An edge belongs to the square on the side of the greater coordinate.
    let square = |position: f64| (position + ROUNDING).floor().rem_euclid(2.0);
    let [x, y] = positions;
    let material = if square(x) == square(y) {
        plane.material
    } else {
        checker.material
    };
    let edge = positions.map(|position| (position - position.round()).abs());
    (material, edge[0].min(edge[1]) * checker.size)
}
