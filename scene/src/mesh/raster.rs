//! What the camera sees of meshes, in double precision.

use crate::description::{CameraDescription, PlaneDescription, SphereDescription};
use crate::prepare::{camera_frame, half_pixel};
use crate::vector::{cross, dot, length, sub};

/// Least cosine of a normal with the direction to the viewer. Interpolated
/// normals lean away from the viewer next to a silhouette, where every model
/// is black: they are turned back to it.
pub(crate) const LEAST_COSINE: f64 = 1.0 / 32.0;
/// Least distance of a corner ahead of the camera.
const LEAST_AHEAD: f64 = 0.01;
/// Most pixels that all triangles' bounding boxes may have together.
const GREATEST_WORK: usize = 1 << 26;

/// A pixel of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Distance from the eye.
    pub depth: f64,
    /// Unit normal, interpolated, towards the viewer.
    pub normal: [f64; 3],
    /// Index into the scene's materials.
    pub material: usize,
}

/// The meshes of a scene as its camera sees them.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenView {
    /// Columns.
    pub width: usize,
    /// Pixels from the top left: `None` where something else is nearer, or
    /// there is no mesh.
    pub pixels: Vec<Option<Seen>>,
}

impl SeenView {
    /// What is seen of a mesh in column `x` of row `y`.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> Option<Seen> {
        let row = self.pixels.chunks(self.width).nth(y)?;
        row.get(x).copied().flatten()
    }

    /// What each pixel mirrors.
    pub(crate) fn mirrored(&self, camera: &CameraDescription) -> Vec<Option<Mirrored>> {
        let rays = Rays::new(camera);
        let at = |(index, pixel): (usize, &Option<Seen>)| {
            let d = rays.ray(index % self.width, index / self.width);
            pixel.map(|pixel| Mirrored {
                place: [0, 1, 2].map(|i| camera.eye[i] + pixel.depth * d[i]),
                direction: {
                    let descent = 2.0 * dot(pixel.normal, d);
                    [0, 1, 2].map(|i| d[i] - descent * pixel.normal[i])
                },
                material: pixel.material,
            })
        };
        self.pixels.iter().enumerate().map(at).collect()
    }
}

/// A point of a mesh, and where the viewer looks by way of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mirrored {
    /// Place in the scene.
    pub(crate) place: [f64; 3],
    /// Unit vector.
    pub(crate) direction: [f64; 3],
    /// Index into the scene's materials.
    pub(crate) material: usize,
}

/// A triangle in the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    /// Corners as seen from the eye.
    pub(crate) corners: [[f64; 3]; 3],
    /// Unit normals at them.
    pub(crate) normals: [[f64; 3]; 3],
    /// Index into the scene's materials.
    pub(crate) material: usize,
}

/// Looks at triangles through every pixel, and leaves out what a sphere or a
/// plane hides.
///
/// # Errors
/// A corner that is not ahead of the camera or too far off; triangles that
/// cover one another too often.
pub(crate) fn look(
    camera: &CameraDescription,
    triangles: &[Placed],
    spheres: &[SphereDescription],
    planes: &[PlaneDescription],
) -> Result<SeenView, String> {
    let (width, height) = (usize::from(camera.width), usize::from(camera.height));
    let rays = Rays::new(camera);
    let bounds = triangles
        .iter()
        .map(|triangle| rays.bounds(triangle))
        .collect::<Result<Vec<_>, _>>()?;
    let boxes = bounds.iter().flatten();
    let work: usize = boxes.map(|[x, y]| x.len() * y.len()).sum();
    if work > GREATEST_WORK {
        return Err(format!(
            "the triangles' bounding boxes have {work} pixels together: must be at most \
             {GREATEST_WORK}"
        ));
    }
    let mut pixels: Vec<Option<Seen>> = vec![None; width * height];
    for (triangle, bounds) in triangles.iter().zip(bounds) {
        let Some([columns, rows]) = bounds else {
            continue;
        };
        let [a, b, c] = triangle.corners;
        // Volumes with the ray: a shared edge has the same one, but for the
        // sign, from both of its sides, so that no pixel falls between.
        let sides = [cross(b, c), cross(c, a), cross(a, b)];
        for y in rows {
            for x in columns.clone() {
                let d = rays.ray(x, y);
                let Some(seen) = meet(triangle, &sides, d) else {
                    continue;
                };
                let pixel = &mut pixels[y * width + x];
                if pixel.is_none_or(|nearest| seen.depth < nearest.depth) {
                    *pixel = Some(seen);
                }
            }
        }
    }
    for (index, pixel) in pixels.iter_mut().enumerate() {
        let Some(seen) = pixel else { continue };
        let d = rays.ray(index % width, index / width);
        let hidden = |depth: Option<f64>| depth.is_some_and(|depth| depth < seen.depth);
        let by_sphere = spheres.iter().any(|s| hidden(sphere_depth(s, camera, d)));
        let by_plane = planes.iter().any(|p| hidden(plane_depth(p, camera, d)));
        if by_sphere || by_plane {
            *pixel = None;
        } else {
            seen.normal = towards(seen.normal, d);
        }
    }
    Ok(SeenView { width, pixels })
}

/// The camera's rays.
struct Rays<'a> {
    camera: &'a CameraDescription,
    /// Ahead, and half a pixel to the right and up.
    frame: [[f64; 3]; 3],
}

impl<'a> Rays<'a> {
    fn new(camera: &'a CameraDescription) -> Self {
        let [ahead, right, up] = camera_frame(camera);
        let step = half_pixel(camera);
        Self {
            camera,
            frame: [ahead, right.map(|c| c * step), up.map(|c| c * step)],
        }
    }

    fn ray(&self, x: usize, y: usize) -> [f64; 3] {
        let [ahead, right, up] = self.frame;
        let column = (2 * x + 1) as f64 - f64::from(self.camera.width);
        let row = f64::from(self.camera.height) - (2 * y + 1) as f64;
        let ray = [0, 1, 2].map(|i| ahead[i] + (column * right[i] + row * up[i]));
        ray.map(|c| c / length(ray))
    }

    /// Columns and rows that a triangle can cover; `None` outside the picture.
    fn bounds(&self, triangle: &Placed) -> Result<Option<[std::ops::Range<usize>; 2]>, String> {
        let [ahead, right, up] = self.frame;
        let step = dot(right, right);
        let mut least = [f64::INFINITY; 2];
        let mut most = [f64::NEG_INFINITY; 2];
        for corner in triangle.corners {
            let distance = length(corner);
            if distance > crate::description::GREATEST_LENGTH {
                return Err(format!(
                    "a corner is {distance:.1} from the camera: must be at most {}",
                    crate::description::GREATEST_LENGTH
                ));
            }
            let along = dot(corner, ahead);
            if along < LEAST_AHEAD {
                return Err(format!(
                    "a corner is {along:.4} ahead of the camera: must be at least {LEAST_AHEAD}"
                ));
            }
            let half = [dot(corner, right), -dot(corner, up)].map(|c| c / (along * step));
            let size = [self.camera.width, self.camera.height].map(f64::from);
            for axis in 0..2 {
                // Pixel i is at the half step 2i + 1 − size.
                let place = (half[axis] + size[axis] - 1.0) / 2.0;
                least[axis] = least[axis].min(place);
                most[axis] = most[axis].max(place);
            }
        }
        let size = [self.camera.width, self.camera.height].map(usize::from);
        // A pixel more on each side, for rounding.
        let range = |axis: usize| {
            let first = (least[axis].floor() - 1.0).max(0.0) as usize;
            let end = (most[axis].ceil() + 2.0).clamp(0.0, size[axis] as f64) as usize;
            first.min(end)..end
        };
        let ranges = [range(0), range(1)];
        let empty = ranges.iter().any(std::ops::Range::is_empty);
        Ok((!empty).then_some(ranges))
    }
}

/// Where a ray from the eye meets a triangle.
fn meet(triangle: &Placed, sides: &[[f64; 3]; 3], d: [f64; 3]) -> Option<Seen> {
    let volumes = sides.map(|side| dot(d, side));
    let all = |test: fn(&f64) -> bool| volumes.iter().all(test);
    if !all(|volume| *volume >= 0.0) && !all(|volume| *volume <= 0.0) {
        return None;
    }
    let sum: f64 = volumes.iter().sum();
    if sum == 0.0 {
        // Seen from its edge.
        return None;
    }
    let weights = volumes.map(|volume| volume / sum);
    let mean = |vectors: &[[f64; 3]; 3]| {
        [0, 1, 2].map(|i| (0..3).map(|k| weights[k] * vectors[k][i]).sum::<f64>())
    };
    let normal = mean(&triangle.normals);
    let size = length(normal);
    let [a, b, c] = triangle.corners;
    let flat = cross(sub(b, a), sub(c, a));
    // Opposite normals may cancel: then the triangle's own.
    let (normal, size) = if size < 1e-6 {
        (flat, length(flat))
    } else {
        (normal, size)
    };
    // From its back a surface shows its other side.
    let front = if dot(flat, d) * dot(flat, normal) > 0.0 {
        -size
    } else {
        size
    };
    Some(Seen {
        depth: dot(mean(&triangle.corners), d),
        normal: normal.map(|c| c / front),
        material: triangle.material,
    })
}

/// The unit vector `normal`, turned towards the viewer to the least cosine if
/// need be.
fn towards(normal: [f64; 3], d: [f64; 3]) -> [f64; 3] {
    let cosine = -dot(normal, d);
    if cosine >= LEAST_COSINE {
        return normal;
    }
    let across = [0, 1, 2].map(|i| normal[i] + cosine * d[i]);
    let size = length(across).max(1e-12);
    let sine = (1.0 - LEAST_COSINE * LEAST_COSINE).sqrt();
    let turned = [0, 1, 2].map(|i| sine * across[i] / size - LEAST_COSINE * d[i]);
    turned.map(|c| c / length(turned))
}

fn sphere_depth(
    sphere: &SphereDescription,
    camera: &CameraDescription,
    d: [f64; 3],
) -> Option<f64> {
    let eye = sub(camera.eye, sphere.center);
    let along = -dot(eye, d);
    let nearest = [0, 1, 2].map(|i| eye[i] + along * d[i]);
    let rest = sphere.radius * sphere.radius - dot(nearest, nearest);
    (along > 0.0 && rest > 0.0).then(|| along - rest.sqrt())
}

fn plane_depth(plane: &PlaneDescription, camera: &CameraDescription, d: [f64; 3]) -> Option<f64> {
    let descent = -dot(plane.normal, d);
    let height = dot(sub(camera.eye, plane.point), plane.normal);
    (descent > 0.0).then(|| height / descent)
}
