//! The scene in double precision, by the reference's models.

use std::sync::Arc;

use microbrdf_reference::light::{Illumination, Light};
use microbrdf_reference::{Brdf, Direction, encode_srgb};
use microbrdf_scene::vector::{cross, dot, length, scaled};
use microbrdf_scene::{
    AlbedoTable, AnySamples, Description, LightDescription, LightKind, Material, PatchShape,
    PlaneDescription, camera_frame, half_pixel, plane_axes,
};
use rayon::prelude::*;

use crate::measure::{JUMP, SHADOW_JUMP};
use crate::picture::Picture;
use crate::progress::Progress;

/// A pixel of the reference.
#[derive(Clone, Copy, Debug)]
pub struct ExactPixel {
    /// Linear light, exposed and clamped.
    pub linear: [f64; 3],
    /// Distance to the nearest jump of the geometry (a silhouette, where two
    /// objects meet), of a model (the edge of a patch) or of a checker, in
    /// radii, in m, or as the angle by which the ray must turn.
    pub jump: f64,
    /// The angle in rad by which a light must turn for the nearest edge of a
    /// shadow to pass here.
    pub shadow: f64,
}

impl ExactPixel {
    /// Whether rounding may put it on the other side of a jump.
    pub fn may_flip(&self) -> bool {
        self.jump <= JUMP || self.shadow <= SHADOW_JUMP
    }

    /// The sRGB code as a real number, 0 … 255.
    pub fn code(&self) -> [f64; 3] {
        self.linear.map(|linear| 255.0 * encode_srgb(linear))
    }
}

/// The whole picture.
pub struct Exact {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Pixels from the top left.
    pub pixels: Vec<ExactPixel>,
}

struct Surface {
    model: Model,
    albedo: Option<Arc<AlbedoTable>>,
    /// The patch radius or lobe cut at which the model jumps.
    patch: Option<f64>,
}

/// Renders the scene exactly.
pub fn render(description: &Description) -> Exact {
    render_as(description, &Material::reference)
}

/// What a material reflects, in double precision.
type Model = Box<dyn Brdf + Send + Sync>;

/// Renders the scene with a model of one's own for each material; daylight
/// remains the material's.
pub fn render_as(description: &Description, model: &dyn Fn(&Material) -> Model) -> Exact {
    let camera = &description.camera;
    let (width, height) = (usize::from(camera.width), usize::from(camera.height));
    let surfaces: Vec<_> = description
        .materials
        .iter()
        .map(|(_, material)| surface(material, model, description.daylight.is_some()))
        .collect();
    let lights: Vec<_> = description
        .lights
        .iter()
        .map(LightDescription::reference)
        .collect();
    let progress = Progress::new("reference", height);
    let rows = (0..height).into_par_iter().map(|y| {
        let row: Vec<_> = (0..width)
            .map(|x| pixel(description, &surfaces, &lights, x, y))
            .collect();
        progress.step();
        row
    });
    Exact {
        width,
        height,
        pixels: rows.flatten_iter().collect(),
    }
}

impl Exact {
    /// The picture in 8-bit sRGB, rounded.
    pub fn srgb(&self) -> Picture {
        let pixels = self
            .pixels
            .par_iter()
            .map(|pixel| pixel.code().map(|code| code.round() as u8))
            .collect();
        Picture {
            width: self.width,
            height: self.height,
            pixels,
        }
    }
}

fn surface(material: &Material, model: &dyn Fn(&Material) -> Model, daylight: bool) -> Surface {
    let model = model(material);
    let albedo = daylight.then(|| AlbedoTable::of(material));
    let patch = match material {
        // R = 2 covers every pair.
        Material::Patch { radius }
        | Material::PatchMetal {
            shape: PatchShape::Basic { radius },
            ..
        } if *radius < 2.0 => Some(*radius),
        _ => None,
    };
    Surface {
        model,
        albedo,
        patch,
    }
}

/// The mean of the pixel's rays, each clamped.
fn pixel(
    description: &Description,
    surfaces: &[Surface],
    lights: &[Light],
    x: usize,
    y: usize,
) -> ExactPixel {
    let rays: &[[f64; 2]] = match description.samples {
        AnySamples::One => &[[0.0, 0.0]],
        AnySamples::Four => &FOUR,
    };
    let mut mean = ExactPixel {
        linear: [0.0; 3],
        jump: f64::INFINITY,
        shadow: f64::INFINITY,
    };
    for offset in rays {
        let ray = ray(description, surfaces, lights, [x, y], *offset);
        for (mean, linear) in mean.linear.iter_mut().zip(ray.linear) {
            *mean += linear / rays.len() as f64;
        }
        mean.jump = mean.jump.min(ray.jump);
        mean.shadow = mean.shadow.min(ray.shadow);
    }
    mean
}

/// Four places in a pixel, to the right of its middle and below it, in half
/// pixels.
const FOUR: [[f64; 2]; 4] = [[-0.25, -0.75], [0.75, -0.25], [-0.75, 0.25], [0.25, 0.75]];

/// What a ray was traced to.
struct Hit {
    depth: f64,
    normal: [f64; 3],
    material: usize,
    /// Distance to an edge of a checker, as an angle.
    edge: f64,
    /// What throws no shadow on itself.
    object: Object,
}

#[derive(Clone, Copy, PartialEq)]
enum Object {
    Sphere(usize),
    Plane(usize),
    Mesh,
}

/// What a ray sees that passes a place in a pixel.
fn ray(
    description: &Description,
    surfaces: &[Surface],
    lights: &[Light],
    [x, y]: [usize; 2],
    [right_of, below]: [f64; 2],
) -> ExactPixel {
    let camera = &description.camera;
    let [ahead, right, up] = camera_frame(camera);
    let step = half_pixel(camera);
    let column = (2 * x + 1) as f64 - f64::from(camera.width) + right_of;
    let row = f64::from(camera.height) - (2 * y + 1) as f64 - below;
    let ray = [0, 1, 2].map(|i| ahead[i] + step * (column * right[i] + row * up[i]));
    let d = scaled(ray, 1.0 / length(ray));
    let mut jump = f64::INFINITY;
    let mut hits: Vec<Hit> = Vec::new();
    for (index, sphere) in description.spheres.iter().enumerate() {
        let eye = [0, 1, 2].map(|i| (camera.eye[i] - sphere.center[i]) / sphere.radius);
        let along = -dot(eye, d);
        let nearest = [0, 1, 2].map(|i| eye[i] + along * d[i]);
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
            let offset = [0, 1, 2].map(|i| camera.eye[i] - plane.point[i]);
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
    // What is seen of a mesh was resolved when the scene was read, for all
    // arithmetics alike: there it jumps nowhere.
    if let Some(seen) = description.view.as_ref().and_then(|view| view.at(x, y)) {
        hits = vec![Hit {
            depth: seen.depth,
            normal: seen.normal,
            material: seen.material,
            edge: f64::INFINITY,
            object: Object::Mesh,
        }];
        jump = f64::INFINITY;
    }
    hits.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    if let [first, second, ..] = &hits[..] {
        jump = jump.min((second.depth - first.depth) / first.depth);
    }
    let exposed = |light: [f64; 3]| light.map(|l| (l * description.exposure).clamp(0.0, 1.0));
    let Some(&Hit {
        depth,
        normal,
        material,
        edge,
        object,
    }) = hits.first()
    else {
        return ExactPixel {
            linear: exposed(description.background),
            jump,
            shadow: f64::INFINITY,
        };
    };
    jump = jump.min(edge);
    let place = [0, 1, 2].map(|i| camera.eye[i] + depth * d[i]);
    let surface = &surfaces[material];
    let v = scaled(d, -1.0);
    let mut light = [0.0; 3];
    let mut shadow = f64::INFINITY;
    if let (Some(table), Some(sky)) = (&surface.albedo, description.daylight) {
        let albedo = table.at(dot(normal, v));
        for i in 0..3 {
            light[i] += albedo[i] * sky[i];
        }
    }
    for (source, described) in lights.iter().zip(&description.lights) {
        let Illumination::Beam {
            to_light: Direction { x, y, z },
            normal_irradiance,
        } = source.at(place)
        else {
            continue;
        };
        if description.shadows && dot(normal, [x, y, z]) > 0.0 {
            let reach = match described.kind {
                LightKind::Directional { .. } => f64::INFINITY,
                LightKind::Point { position, .. } | LightKind::Flood { position, .. } => {
                    let to = [0, 1, 2].map(|i| position[i] - place[i]);
                    length(to)
                }
            };
            let (hidden, angle) = hidden(description, object, place, [x, y, z], reach);
            shadow = shadow.min(angle);
            if hidden {
                continue;
            }
        }
        let (l, v) = to_frame(normal, [x, y, z], v);
        let reflected = surface.model.reflect(&l, &v);
        for i in 0..3 {
            light[i] += reflected[i] * normal_irradiance[i];
        }
        if let Some(radius) = surface.patch
            && l.z > 0.0
        {
            jump = jump.min(((l.x + v.x).hypot(l.y + v.y) - radius).abs());
        }
    }
    ExactPixel {
        linear: exposed(light),
        jump,
        shadow,
    }
}

/// Whether anything but `own` stands within `reach` of a place in the
/// direction `l`, and the angle by which `l` must turn to pass the nearest
/// edge of a sphere.
fn hidden(
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
        let aside = cross(to, l);
        let aside = length(aside);
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

/// L and V in a shading frame of the normal.
fn to_frame(normal: [f64; 3], l: [f64; 3], v: [f64; 3]) -> (Direction, Direction) {
    // Any tangent will do: the models are isotropic.
    let axis = if normal[2].abs() < 0.9 {
        [0.0, 0.0, 1.0]
    } else {
        [1.0, 0.0, 0.0]
    };
    let tangent = cross(axis, normal);
    let tangent = scaled(tangent, 1.0 / length(tangent));
    let bitangent = cross(normal, tangent);
    let frame = |a: [f64; 3]| Direction::new(dot(a, tangent), dot(a, bitangent), dot(a, normal));
    (frame(l), frame(v))
}
