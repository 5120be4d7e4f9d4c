//! The scene in double precision, by the reference's models.

mod hit;
mod shadow;

use std::sync::Arc;

use microbrdf_reference::light::{Illumination, Light};
use microbrdf_reference::{Brdf, Direction, encode_srgb};
use microbrdf_scene::vector::{cross, dot, length, scaled, sub};
use microbrdf_scene::{
    AlbedoTable, AnySamples, Description, LightDescription, LightKind, Material, PatchShape,
    camera_frame, half_pixel,
};
use rayon::prelude::*;

use crate::measure::{JUMP, SHADOW_JUMP};
use crate::picture::Picture;
use crate::progress::Progress;
use hit::Hit;
use shadow::hidden;

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

/// What a material reflects, in double precision.
type Model = Box<dyn Brdf + Send + Sync>;

/// A scene that is ready to be rendered.
pub struct Renderer<'a> {
    description: &'a Description,
    surfaces: Vec<Surface>,
    lights: Vec<Light>,
}

/// Renders the scene exactly.
pub fn render(description: &Description) -> Exact {
    Renderer::new(description).render()
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

impl<'a> Renderer<'a> {
    /// The scene with the reference's models.
    pub fn new(description: &'a Description) -> Self {
        Self::with_models(description, &Material::reference)
    }

    /// The scene with a model of one's own for each material; daylight remains
    /// the material's.
    pub fn with_models(description: &'a Description, model: &dyn Fn(&Material) -> Model) -> Self {
        let daylight = description.daylight.is_some();
        let materials = description.materials.iter();
        let lights = description.lights.iter();
        Self {
            description,
            surfaces: materials
                .map(|(_, material)| surface(material, model, daylight))
                .collect(),
            lights: lights.map(LightDescription::reference).collect(),
        }
    }

    /// The whole picture.
    pub fn render(&self) -> Exact {
        let camera = &self.description.camera;
        let (width, height) = (usize::from(camera.width), usize::from(camera.height));
        let progress = Progress::new("reference", height);
        let rows = (0..height).into_par_iter().map(|y| {
            let row: Vec<_> = (0..width).map(|x| self.pixel(x, y)).collect();
            progress.step();
            row
        });
        Exact {
            width,
            height,
            pixels: rows.flatten_iter().collect(),
        }
    }

    /// The mean of the pixel's rays, each clamped.
    fn pixel(&self, x: usize, y: usize) -> ExactPixel {
        let rays: &[[f64; 2]] = match self.description.samples {
            AnySamples::One => &[[0.0, 0.0]],
            AnySamples::Four => &FOUR,
        };
        let mut mean = ExactPixel {
            linear: [0.0; 3],
            jump: f64::INFINITY,
            shadow: f64::INFINITY,
        };
        for offset in rays {
            let ray = self.ray([x, y], *offset);
            for (mean, linear) in mean.linear.iter_mut().zip(ray.linear) {
                *mean += linear / rays.len() as f64;
            }
            mean.jump = mean.jump.min(ray.jump);
            mean.shadow = mean.shadow.min(ray.shadow);
        }
        mean
    }

    /// What a ray sees that passes a place in a pixel.
    fn ray(&self, [x, y]: [usize; 2], [right_of, below]: [f64; 2]) -> ExactPixel {
        let camera = &self.description.camera;
        let [ahead, right, up] = camera_frame(camera);
        let step = half_pixel(camera);
        let column = (2 * x + 1) as f64 - f64::from(camera.width) + right_of;
        let row = f64::from(camera.height) - (2 * y + 1) as f64 - below;
        let ray = [0, 1, 2].map(|i| ahead[i] + step * (column * right[i] + row * up[i]));
        let d = scaled(ray, 1.0 / length(ray));
        let (hit, jump) = hit::first(self.description, d, [x, y]);
        let mut pixel = ExactPixel {
            linear: self.description.background,
            jump,
            shadow: f64::INFINITY,
        };
        if let Some(hit) = hit {
            self.light(&hit, d, &mut pixel);
        }
        let exposure = self.description.exposure;
        pixel.linear = pixel.linear.map(|l| (l * exposure).clamp(0.0, 1.0));
        pixel
    }

    /// What is seen, in the direction `d`, of what was hit.
    fn light(&self, hit: &Hit, d: [f64; 3], pixel: &mut ExactPixel) {
        let description = self.description;
        let normal = hit.normal;
        let place = [0, 1, 2].map(|i| description.camera.eye[i] + hit.depth * d[i]);
        let surface = &self.surfaces[hit.material];
        let v = scaled(d, -1.0);
        let mut light = [0.0; 3];
        if let (Some(table), Some(sky)) = (&surface.albedo, description.daylight) {
            let albedo = table.at(dot(normal, v));
            for i in 0..3 {
                light[i] += albedo[i] * sky[i];
            }
        }
        for (source, described) in self.lights.iter().zip(&description.lights) {
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
                        length(sub(position, place))
                    }
                };
                let (hidden, angle) = hidden(description, hit.object, place, [x, y, z], reach);
                pixel.shadow = pixel.shadow.min(angle);
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
                let m = (l.x + v.x).hypot(l.y + v.y);
                pixel.jump = pixel.jump.min((m - radius).abs());
            }
        }
        pixel.linear = light;
    }
}

/// Four places in a pixel, to the right of its middle and below it, in half
/// pixels.
const FOUR: [[f64; 2]; 4] = [[-0.25, -0.75], [0.75, -0.25], [-0.75, 0.25], [0.25, 0.75]];

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
