//! The renderer that one would write without this project: single precision,
//! `powf`, R·V, Schlick's approximation.

use microbrdf_scene::{
    AlbedoTable, AnySamples, Description, LightKind, Material, camera_frame, half_pixel,
};
use rayon::prelude::*;

type Vector = [f32; 3];

/// A scene in single precision.
#[derive(Debug)]
pub struct Plain {
    width: usize,
    height: usize,
    /// Ahead; to the right and up by half a pixel.
    frame: [Vector; 3],
    eye: Vector,
    /// Centre, radius, material.
    spheres: Vec<(Vector, f32, usize)>,
    /// Point, normal, material.
    planes: Vec<(Vector, Vector, usize)>,
    /// Unit vector to the light, irradiance.
    lights: Vec<(Vector, Vector)>,
    coats: Vec<Coat>,
    background: Vector,
}

#[derive(Debug)]
struct Coat {
    model: Model,
    /// Sky times albedo over the cosine.
    sky: Option<Vec<Vector>>,
}

#[derive(Debug)]
enum Model {
    Matt(Vector),
    /// Exponent, peak, whether it divides by cosΘmin, reflectance at the
    /// normal where that is coloured.
    Lobe(f32, f32, bool, Option<Vector>),
    /// R², 1/(π min(1, R²)).
    Patch(f32, f32),
    /// s, C(s).
    Exponential(f32, f32),
}

/// Entries of the table of albedos.
const ALBEDOS: usize = 257;

impl Plain {
    /// The scene in this renderer's numbers.
    ///
    /// # Errors
    /// What it does not know.
    pub fn new(scene: &Description) -> Result<Self, String> {
        let single = |vector: [f64; 3]| vector.map(|c| c as f32);
        let exposed = |vector: [f64; 3]| single(vector.map(|c| c * scene.exposure));
        let [ahead, right, up] = camera_frame(&scene.camera);
        let step = half_pixel(&scene.camera);
        let lights = scene.lights.iter().map(|light| match light.kind {
            LightKind::Directional { direction } => Ok((single(direction), exposed(light.color))),
            _ => Err("lights are directional in the plain renderer".to_owned()),
        });
        if scene.planes.iter().any(|plane| plane.checker.is_some()) {
            return Err("no plane has a checker in the plain renderer".to_owned());
        }
        if scene.view.is_some() {
            return Err("there is no mesh in the plain renderer".to_owned());
        }
        if scene.shadows || scene.samples != AnySamples::One {
            return Err("there are no shadows and one sample in the plain renderer".to_owned());
        }
        let coats = scene.materials.iter().map(|(name, material)| {
            let model = model(material)
                .ok_or_else(|| format!("the plain renderer has no model for material.{name}"))?;
            let sky = scene.daylight.map(|sky| {
                let albedo = AlbedoTable::of(material);
                let entry = |i: usize| {
                    let albedo = albedo.at(i as f64 / (ALBEDOS - 1) as f64);
                    exposed([0, 1, 2].map(|c| sky[c] * albedo[c]))
                };
                (0..ALBEDOS).map(entry).collect()
            });
            Ok(Coat { model, sky })
        });
        Ok(Self {
            width: scene.camera.width.into(),
            height: scene.camera.height.into(),
            frame: [ahead, right.map(|c| c * step), up.map(|c| c * step)].map(single),
            eye: single(scene.camera.eye),
            spheres: scene
                .spheres
                .iter()
                .map(|s| (single(s.center), s.radius as f32, s.material))
                .collect(),
            planes: scene
                .planes
                .iter()
                .map(|p| (single(p.point), single(p.normal), p.material))
                .collect(),
            lights: lights.collect::<Result<_, _>>()?,
            coats: coats.collect::<Result<_, String>>()?,
            background: exposed(scene.background),
        })
    }

    /// The picture in 8-bit sRGB.
    pub fn render(&self) -> Vec<[u8; 3]> {
        let rows = (0..self.height).into_par_iter().map(|y| {
            let row: Vec<_> = (0..self.width)
                .map(|x| self.pixel(x, y).map(encoded))
                .collect();
            row
        });
        rows.flatten_iter().collect()
    }

    fn pixel(&self, x: usize, y: usize) -> Vector {
        let column = (2 * x + 1) as f32 - self.width as f32;
        let row = self.height as f32 - (2 * y + 1) as f32;
        let [ahead, right, up] = self.frame;
        let ray = unit([0, 1, 2].map(|i| ahead[i] + column * right[i] + row * up[i]));
        let mut nearest = f32::INFINITY;
        let mut hit = None;
        for &(center, radius, material) in &self.spheres {
            let from = [0, 1, 2].map(|i| self.eye[i] - center[i]);
            let along = dot(from, ray);
            let root = along * along - dot(from, from) + radius * radius;
            if root > 0.0 {
                let depth = -along - root.sqrt();
                if depth > 0.0 && depth < nearest {
                    nearest = depth;
                    let normal = [0, 1, 2].map(|i| (from[i] + depth * ray[i]) / radius);
                    hit = Some((normal, material));
                }
            }
        }
        for &(point, normal, material) in &self.planes {
            let descent = -dot(normal, ray);
            if descent > 0.0 {
                let height = dot([0, 1, 2].map(|i| self.eye[i] - point[i]), normal);
                let depth = height / descent;
                if depth < nearest {
                    nearest = depth;
                    hit = Some((normal, material));
                }
            }
        }
        let Some((n, material)) = hit else {
            return self.background;
        };
        self.coats[material].light(n, ray.map(|c| -c), &self.lights)
    }
}

impl Coat {
    fn light(&self, n: Vector, v: Vector, lights: &[(Vector, Vector)]) -> Vector {
        let n_dot_v = dot(n, v);
        let mut light = match &self.sky {
            Some(sky) => {
                let position = n_dot_v.clamp(0.0, 1.0) * (ALBEDOS - 1) as f32;
                let cell = (position as usize).min(ALBEDOS - 2);
                let part = position - cell as f32;
                [0, 1, 2].map(|c| sky[cell][c] + (sky[cell + 1][c] - sky[cell][c]) * part)
            }
            None => [0.0; 3],
        };
        for &(l, irradiance) in lights {
            let n_dot_l = dot(n, l);
            if n_dot_l <= 0.0 || n_dot_v <= 0.0 {
                continue;
            }
            let r = [0, 1, 2].map(|i| 2.0 * n_dot_l * n[i] - l[i]);
            let reflected = self.model.reflect(n_dot_l, n_dot_v, r, v, n);
            for c in 0..3 {
                light[c] += reflected[c] * irradiance[c];
            }
        }
        light
    }
}

impl Model {
    fn reflect(&self, n_dot_l: f32, n_dot_v: f32, r: Vector, v: Vector, n: Vector) -> Vector {
        match *self {
            Self::Matt(value) => value.map(|c| c * n_dot_l),
            Self::Lobe(exponent, peak, metallic, normal) => {
                let greater = n_dot_l.max(n_dot_v);
                let factor = if metallic { n_dot_l / greater } else { n_dot_l };
                let lobe = peak * dot(r, v).max(0.0).powf(exponent) * factor;
                match normal {
                    None => [lobe; 3],
                    Some(normal) => {
                        let rest = (1.0 - greater).powi(5);
                        normal.map(|f| lobe * (f + (1.0 - f) * rest))
                    }
                }
            }
            Self::Patch(square, peak) => {
                let inside = separation(r, v, n) < square;
                [if inside { peak * n_dot_l } else { 0.0 }; 3]
            }
            Self::Exponential(sharpness, peak) => {
                [peak * n_dot_l * (-sharpness * separation(r, v, n).sqrt()).exp(); 3]
            }
        }
    }
}

/// Squared distance of the projections of R and V on the base plane.
fn separation(r: Vector, v: Vector, n: Vector) -> f32 {
    let apart = [0, 1, 2].map(|i| r[i] - v[i]);
    let along = dot(apart, n);
    dot(apart, apart) - along * along
}

fn model(material: &Material) -> Option<Model> {
    let peak = material.reference().peak() as f32;
    Some(match material {
        Material::Lambert { albedo } => Model::Matt(
            albedo
                .rgb()
                .map(|c| (c * std::f64::consts::FRAC_1_PI) as f32),
        ),
        Material::Phong {
            exponent,
            p,
            retro: false,
            ..
        } if *p == 0.0 || *p == 1.0 => Model::Lobe(*exponent as f32, peak, *p == 1.0, None),
        Material::Metal {
            exponent,
            reflectance,
        } => {
            let last = reflectance.curve().entries().last().copied()?;
            let normal = last.map(|entry| f32::from(entry) / 32768.0);
            Model::Lobe(*exponent as f32, peak, true, Some(normal))
        }
        Material::Patch { radius } => Model::Patch((radius * radius) as f32, peak),
        Material::PatchExponential { sharpness } => Model::Exponential(*sharpness as f32, peak),
        _ => return None,
    })
}

/// sRGB, 8 bits.
fn encoded(light: f32) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let code = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * code + 0.5) as u8
}

fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Vector) -> Vector {
    let factor = 1.0 / dot(a, a).sqrt();
    a.map(|c| c * factor)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use microbrdf_scene::Description;

    use super::Plain;
    use crate::reference_picture;

    /// It has to do the same work to be worth a comparison; Schlick's
    /// approximation is not Fresnel's factor, and f32 has R·V only so well.
    #[test]
    fn it_renders_the_same_picture() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/demo.toml");
        let scene = Description::from_file(&path).expect("the demo");
        let exact = reference_picture::render(&scene).srgb().pixels;
        let plain = Plain::new(&scene).expect("what it knows").render();
        let pairs = exact.as_flattened().iter().zip(plain.as_flattened());
        let apart: Vec<_> = pairs.map(|(a, b)| a.abs_diff(*b)).collect();
        let far = apart.iter().filter(|apart| **apart > 6).count();
        assert!(200 * far < apart.len(), "{far} codes of {}", apart.len());
    }
}
