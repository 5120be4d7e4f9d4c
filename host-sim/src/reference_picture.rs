//! The scene in double precision, by the reference's models.

use std::sync::Arc;

use microbrdf_reference::{Brdf, Direction, encode_srgb};
use microbrdf_scene::{AlbedoTable, Description, Material, camera_frame, half_pixel};
use rayon::prelude::*;

use crate::picture::Picture;
use crate::progress::Progress;

/// A pixel of the reference.
#[derive(Clone, Copy, Debug)]
pub struct ExactPixel {
    /// Linear light, exposed and clamped.
    pub linear: [f64; 3],
    /// Distance to the nearest jump of the geometry (a silhouette, where two
    /// objects meet) or of a model (the edge of a patch), in radii or in m.
    pub jump: f64,
}

impl ExactPixel {
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
    model: Box<dyn Brdf + Send + Sync>,
    albedo: Option<Arc<AlbedoTable>>,
    /// The patch radius or lobe cut at which the model jumps.
    patch: Option<f64>,
}

/// Renders the scene exactly.
pub fn render(description: &Description) -> Exact {
    let camera = &description.camera;
    let (width, height) = (usize::from(camera.width), usize::from(camera.height));
    let surfaces: Vec<_> = description
        .materials
        .iter()
        .map(|(_, material)| surface(material, description.daylight.is_some()))
        .collect();
    let progress = Progress::new("reference", height);
    let rows = (0..height).into_par_iter().map(|y| {
        let row: Vec<_> = (0..width)
            .map(|x| pixel(description, &surfaces, x, y))
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
            .iter()
            .map(|pixel| pixel.code().map(|code| code.round() as u8))
            .collect();
        Picture {
            width: self.width,
            height: self.height,
            pixels,
        }
    }
}

fn surface(material: &Material, daylight: bool) -> Surface {
    let model = material.reference();
    let albedo = daylight.then(|| AlbedoTable::of(material));
    let patch = match material {
        // R = 2 covers every pair.
        Material::Patch { radius } if *radius < 2.0 => Some(*radius),
        _ => None,
    };
    Surface {
        model,
        albedo,
        patch,
    }
}

fn pixel(description: &Description, surfaces: &[Surface], x: usize, y: usize) -> ExactPixel {
    let camera = &description.camera;
    let [ahead, right, up] = camera_frame(camera);
    let step = half_pixel(camera);
    let column = (2 * x + 1) as f64 - f64::from(camera.width);
    let row = f64::from(camera.height) - (2 * y + 1) as f64;
    let ray = [0, 1, 2].map(|i| ahead[i] + step * (column * right[i] + row * up[i]));
    let d = scaled(ray, 1.0 / dot(ray, ray).sqrt());
    let mut jump = f64::INFINITY;
    let mut hits: Vec<(f64, [f64; 3], usize)> = Vec::new();
    for sphere in &description.spheres {
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
            hits.push((sphere.radius * (along - half), normal, sphere.material));
        }
    }
    for plane in &description.planes {
        let descent = -dot(plane.normal, d);
        jump = jump.min(descent.abs());
        if descent > 0.0 {
            let offset = [0, 1, 2].map(|i| camera.eye[i] - plane.point[i]);
            hits.push((
                dot(offset, plane.normal) / descent,
                plane.normal,
                plane.material,
            ));
        }
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let [first, second, ..] = hits[..] {
        jump = jump.min((second.0 - first.0) / first.0);
    }
    let exposed = |light: [f64; 3]| light.map(|l| (l * description.exposure).clamp(0.0, 1.0));
    let Some(&(_, normal, material)) = hits.first() else {
        return ExactPixel {
            linear: exposed(description.background),
            jump,
        };
    };
    let surface = &surfaces[material];
    let v = scaled(d, -1.0);
    let mut light = [0.0; 3];
    if let (Some(table), Some(sky)) = (&surface.albedo, description.daylight) {
        let albedo = table.at(dot(normal, v));
        for i in 0..3 {
            light[i] += albedo[i] * sky[i];
        }
    }
    for source in &description.lights {
        let (l, v) = to_frame(normal, source.direction, v);
        let reflected = surface.model.reflect(&l, &v);
        for i in 0..3 {
            light[i] += reflected[i] * source.color[i];
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
    }
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
    let tangent = scaled(tangent, 1.0 / dot(tangent, tangent).sqrt());
    let bitangent = cross(normal, tangent);
    let frame = |a: [f64; 3]| Direction::new(dot(a, tangent), dot(a, bitangent), dot(a, normal));
    (frame(l), frame(v))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn scaled(a: [f64; 3], factor: f64) -> [f64; 3] {
    a.map(|c| c * factor)
}
