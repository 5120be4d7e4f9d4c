//! Highlights narrower than a pixel, widened so that none falls between
//! pixels.
//!
//! A lobe cosⁿα has the variance 1/n in each of its two directions, a patch of
//! radius R has R²/4, an exponential mixture 3/s². A light of some size adds its
//! own. What then is too narrow for samples a pixel apart, by the spectrum of
//! its shape, gets the least width that is not: `tests/tests/flicker.rs`.

use std::collections::BTreeMap;

use crate::description::{Description, LightDescription, LightKind};
use crate::material::{Material, PatchShape};
use crate::mesh::Mirrored;
use crate::prepare::half_pixel;
use crate::vector::{dot, length, sub};

/// Least σ of a lobe in pixels. It is a bell, whose spectrum e^(−2π²σ²) is
/// below 1 % at the samples' frequency.
const LEAST_LOBE: f64 = 0.5;
/// Least radius of a disc in pixels: the second zero of its spectrum, that of
/// J₁ at 7.016, lies at the samples' frequency.
const LEAST_DISC: f64 = 1.117;
/// Least radius 1/s of an exponential mixture in pixels: its spectrum
/// (1 + (2π/s)²)^−1.5 is below 1 % there.
const LEAST_EXPONENTIAL: f64 = 0.75;
/// At most this factor is a pixel stretched where light grazes: beyond 60°.
const GREATEST_STRETCH: f64 = 2.0;
/// Greatest number of materials: their numbers are bytes.
const GREATEST_COUNT: usize = 255;

/// What highlights are seen through: angles in rad.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// What α changes by from one pixel to the next.
    pixel: f64,
    /// The same about L, where a curved surface changes nothing.
    retro: f64,
    /// The light's diameter.
    light: f64,
}

impl Description {
    /// Gives every object the material that its highlights are shaded with,
    /// which has a width and an energy of its own only where light's size or
    /// the pixels ask for it.
    ///
    /// # Errors
    /// The number of materials, if it passes 255.
    pub(crate) fn widen_highlights(&mut self) -> Result<(), usize> {
        let spheres: Vec<_> = (0..self.spheres.len()).map(|i| self.on_sphere(i)).collect();
        let planes: Vec<_> = (0..self.planes.len()).map(|i| self.on_plane(i)).collect();
        let meshes = self.on_meshes();
        let mut widened = Widened::default();
        for (sphere, seen) in self.spheres.iter_mut().zip(spheres) {
            sphere.material = widened.index(&self.materials, sphere.material, seen);
        }
        for (plane, seen) in self.planes.iter_mut().zip(planes) {
            plane.material = widened.index(&self.materials, plane.material, seen);
            if let Some(checker) = &mut plane.checker {
                checker.material = widened.index(&self.materials, checker.material, seen);
            }
        }
        let renumbered: BTreeMap<_, _> = meshes
            .into_iter()
            .map(|(material, seen)| (material, widened.index(&self.materials, material, seen)))
            .collect();
        if let Some(view) = &mut self.view {
            for pixel in view.pixels.iter_mut().flatten() {
                pixel.material = renumbered[&pixel.material];
            }
        }
        if widened.materials.len() > GREATEST_COUNT {
            return Err(widened.materials.len());
        }
        self.materials = widened.materials;
        Ok(())
    }

    /// On what is seen of meshes, for each of their materials.
    fn on_meshes(&self) -> BTreeMap<usize, Seen> {
        let Some(view) = &self.view else {
            return BTreeMap::new();
        };
        let mirrored = view.mirrored(&self.camera);
        let used: BTreeMap<_, _> = mirrored
            .iter()
            .flatten()
            .map(|at| (at.material, Seen::default()))
            .collect();
        let on = |material| self.through(|light| self.on_mesh(light, &mirrored, material));
        used.into_keys().map(|key| (key, on(key))).collect()
    }

    /// Where a mesh mirrors the light best: how fast what is mirrored turns
    /// from there to the next pixels, the median of them.
    fn on_mesh(
        &self,
        light: &LightDescription,
        mirrored: &[Option<Mirrored>],
        material: usize,
    ) -> Seen {
        let of_it = |index: usize| {
            let at = mirrored.get(index).copied().flatten();
            at.filter(|at| at.material == material)
        };
        let brightness = |at: &Mirrored| dot(at.direction, towards(light, at.place).0);
        let best = (0..mirrored.len())
            .filter_map(|index| Some((index, of_it(index)?)))
            .max_by(|(_, a), (_, b)| brightness(a).total_cmp(&brightness(b)));
        let Some((index, best)) = best else {
            return Seen::default();
        };
        let (_, lamp) = towards(light, best.place);
        let width = usize::from(self.camera.width);
        let mut turns: Vec<_> = [index.wrapping_sub(1), index + 1]
            .into_iter()
            // Not around the end of a row.
            .filter(|next| next / width == index / width)
            .chain([index.wrapping_sub(width), index + width])
            .filter_map(of_it)
            .map(|next| {
                length(sub(next.direction, best.direction))
                    + length(sub(next.place, best.place)) / lamp
            })
            .collect();
        turns.sort_by(f64::total_cmp);
        let across = self.pixel() * length(sub(best.place, self.camera.eye)) / lamp;
        let least = self.pixel() + across;
        Seen {
            pixel: turns
                .get(turns.len() / 2)
                .copied()
                .unwrap_or(least)
                .max(least),
            retro: least,
            light: angle(light, lamp),
        }
    }

    /// On a sphere.
    fn on_sphere(&self, index: usize) -> Seen {
        let sphere = &self.spheres[index];
        self.through(|light| {
            let mut normal = sub(self.camera.eye, sphere.center);
            let mut widest = Seen::default();
            // Towards the spot of a lamp: it sees the sphere from nearby.
            for _ in 0..4 {
                let norm = length(normal);
                if norm < 1e-9 {
                    // Light from straight behind: the eye sees no highlight.
                    break;
                }
                normal = normal.map(|c| c / norm);
                let spot = [0, 1, 2].map(|i| sphere.center[i] + sphere.radius * normal[i]);
                let to_eye = sub(self.camera.eye, spot);
                let (to_light, lamp) = towards(light, spot);
                let distance = length(to_eye);
                let stretch = 1.0 / dot(normal, to_light).max(1.0 / GREATEST_STRETCH);
                let pixel = self.pixel();
                let across = pixel * distance;
                widest = Seen {
                    pixel: pixel + 2.0 * across * stretch / sphere.radius + across / lamp,
                    retro: pixel + across / lamp,
                    light: angle(light, lamp),
                };
                normal = [0, 1, 2].map(|i| to_light[i] + to_eye[i] / distance);
            }
            widest
        })
    }

    /// On a plane.
    fn on_plane(&self, index: usize) -> Seen {
        let plane = &self.planes[index];
        let eye = dot(sub(self.camera.eye, plane.point), plane.normal);
        self.through(|light| match light.kind {
            LightKind::Directional { .. } => Seen {
                pixel: self.pixel(),
                retro: self.pixel(),
                light: light.size,
            },
            // From the spot it is as far to the eye and the lamp as they are
            // high above the plane, and together as far as to the lamp's image.
            LightKind::Point { position, .. } | LightKind::Flood { position, .. } => {
                let lamp = dot(sub(position, plane.point), plane.normal).abs();
                let apart = length(sub(self.camera.eye, position));
                let image = (apart * apart + 4.0 * eye * lamp).sqrt();
                let pixel = self.pixel() * (1.0 + eye / lamp);
                Seen {
                    pixel,
                    retro: pixel,
                    light: angle(light, image * lamp / (eye + lamp)),
                }
            }
        })
    }

    /// Of all lights the widest pixel, and the smallest light.
    fn through(&self, seen: impl Fn(&LightDescription) -> Seen) -> Seen {
        let all = self.lights.iter().map(seen);
        all.reduce(|a, b| Seen {
            pixel: a.pixel.max(b.pixel),
            retro: a.retro.max(b.retro),
            light: a.light.min(b.light),
        })
        .unwrap_or_default()
    }

    /// Angle between two pixels in the middle of the picture.
    fn pixel(&self) -> f64 {
        2.0 * half_pixel(&self.camera)
    }
}

/// A light's angular diameter from a distance.
fn angle(light: &LightDescription, distance: f64) -> f64 {
    match light.kind {
        LightKind::Directional { .. } => light.size,
        LightKind::Point { .. } | LightKind::Flood { .. } => light.size / distance,
    }
}

/// Unit vector to a light, and its distance, above 0; no direction to a lamp
/// from where it stands.
fn towards(light: &LightDescription, from: [f64; 3]) -> ([f64; 3], f64) {
    match light.kind {
        LightKind::Directional { direction } => (direction, f64::INFINITY),
        LightKind::Point { position, .. } | LightKind::Flood { position, .. } => {
            let to_light = sub(position, from);
            let distance = length(to_light).max(f64::MIN_POSITIVE);
            (to_light.map(|c| c / distance), distance)
        }
    }
}

/// Materials in use, each once.
#[derive(Default)]
struct Widened {
    materials: Vec<(String, Material)>,
}

impl Widened {
    fn index(&mut self, given: &[(String, Material)], index: usize, seen: Seen) -> usize {
        let (name, material) = &given[index];
        let entry = (name.clone(), material.widened(seen));
        let known = self.materials.iter().position(|known| *known == entry);
        known.unwrap_or_else(|| {
            self.materials.push(entry);
            self.materials.len() - 1
        })
    }
}

impl Material {
    fn widened(&self, seen: Seen) -> Self {
        // What fixed point takes, and no lobe that is wider than that already.
        let lobe = |n: f64, pixel| {
            let variance = seen.variance(1.0 / n, LEAST_LOBE * pixel);
            (1.0 / variance).clamp(n.min(1.0), n)
        };
        let mut material = self.clone();
        match &mut material {
            Self::Phong {
                exponent,
                retro: true,
                ..
            } => *exponent = lobe(*exponent, seen.retro),
            Self::Phong { exponent, .. }
            | Self::Metal { exponent, .. }
            | Self::Plastic { exponent, .. } => *exponent = lobe(*exponent, seen.pixel),
            Self::Patch { radius }
            | Self::PatchMetal {
                shape: PatchShape::Basic { radius },
                ..
            } => {
                let least = 0.5 * LEAST_DISC * seen.pixel;
                let variance = seen.variance(0.25 * *radius * *radius, least);
                *radius = (4.0 * variance).sqrt().clamp(*radius, 2.0);
            }
            Self::PatchExponential { sharpness }
            | Self::MetallicPaint { sharpness, .. }
            | Self::PatchMetal {
                shape: PatchShape::Exponential { sharpness },
                ..
            } => {
                let least = 3f64.sqrt() * LEAST_EXPONENTIAL * seen.pixel;
                let variance = seen.variance(3.0 / (*sharpness * *sharpness), least);
                *sharpness = (3.0 / variance).sqrt().min(*sharpness);
            }
            Self::PatchProfile { .. } | Self::Lambert { .. } | Self::GeneralisedLambert { .. } => {}
        }
        material
    }
}

impl Seen {
    /// What becomes of a variance whose root is to be at least `least`.
    fn variance(self, own: f64, least: f64) -> f64 {
        // A light is a disc.
        let spread = own + (0.25 * self.light).powi(2);
        spread.max(least * least)
    }
}

#[cfg(test)]
mod tests {
    use super::{Description, towards};

    fn scene(light: &str) -> Description {
        let text = format!(
            "[camera]\nwidth = 64\nheight = 64\neye = [0, -9, 0]\ntarget = [0, 0, 0]\nfov = 20\n\
             [[light]]\nsize = 1\n{light}\n\
             [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"it\"\n\
             [material.it]\nmodel = \"metallic-phong\"\nexponent = 1e5\n"
        );
        Description::from_toml("it.toml", "it", &text).expect("a scene")
    }

    #[test]
    fn light_from_straight_behind_is_as_light_from_nearly_there() {
        for light in [
            "kind = \"point\"\nposition = [X, 9, 0]\nintensity = 50",
            "kind = \"directional\"\ndirection = [X, 9, 0]\ncolor = 1",
        ] {
            let peak = |x| {
                scene(&light.replace('X', x)).materials[0]
                    .1
                    .reference()
                    .peak()
            };
            let (behind, nearly) = (peak("0"), peak("0.1"));
            assert!((0.5..2.0).contains(&(behind / nearly)), "{behind} {nearly}");
        }
    }

    #[test]
    fn a_lamp_where_it_shines_is_a_distance_away() {
        let scene = scene("kind = \"point\"\nposition = [0, 9, 0]\nintensity = 50");
        let (direction, distance) = towards(&scene.lights[0], [0.0, 9.0, 0.0]);
        assert_eq!(direction, [0.0; 3]);
        assert!(distance > 0.0);
    }
}
