//! A scene, shaded eight pixels at a time.

use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic, Float};
use microbrdf::brdf::Brdf;
use microbrdf::geometry::Direction;
use microbrdf::shade::{
    AlbedoDaylight, Camera, Checker, Daylight, Ground, Linear, Plane, Sphere, Tracing,
};

use super::arithmetic::clamped;
use super::geometry::Lit;
use super::lanes::{One, Which, all};
use super::{Lanes, WIDTH, Wide};
use crate::host::{HostArithmetic, Native};
use crate::lamp::AnyLight;
use crate::model::AnyModel;
use crate::prepare::{Prepared, PreparedCoat};
use crate::quality::{AnySamples, AnyShadows};

/// The index of no material, and that of a pixel that is done. (Indices are
/// chosen beside depths, and so are of their type.)
const NOTHING: f32 = -1.0;
const SHOWN: f32 = -2.0;

/// A scene of spheres and planes under distant lights, in single precision: its
/// rows have the bits of the core's (`tests/tests/wide.rs`), and come several times
/// sooner (`microbrdf bench`).
#[derive(Debug)]
pub struct WideScene {
    camera: Camera<Wide>,
    spheres: Vec<Sphere<Wide>>,
    planes: Vec<Plane<Wide>>,
    lights: Vec<Direction<Wide>>,
    materials: Vec<Vec<Coat>>,
    background: Linear,
}

/// One of a material's parts.
#[derive(Debug)]
struct Coat {
    model: AnyModel<Wide>,
    gains: Vec<Rgb<f32>>,
    daylight: Option<AlbedoDaylight<Wide>>,
}

/// What eight pixels see.
struct Seen {
    depths: Lanes,
    normals: Direction<Wide>,
    materials: Lanes,
}

impl WideScene {
    /// The prepared scene; `None` for what decides by the place or by several
    /// rays: lamps, checkers, meshes, shadows, samples.
    #[must_use]
    pub fn new(scene: &Prepared<Float<Native>>) -> Option<Self> {
        if scene.view.is_some()
            || scene.shadows != AnyShadows(false)
            || scene.samples != AnySamples::One
        {
            return None;
        }
        let lights = scene.lights.iter().map(|light| match light {
            AnyLight::Directional(direction) => Some(all(*direction)),
            _ => None,
        });
        let camera = &scene.camera;
        Some(Self {
            camera: Camera {
                width: camera.width,
                height: camera.height,
                forward: camera.forward,
                right: camera.right,
                up: camera.up,
            },
            spheres: scene.spheres.iter().map(sphere).collect(),
            planes: scene.planes.iter().map(plane).collect::<Option<_>>()?,
            lights: lights.collect::<Option<_>>()?,
            materials: scene.coats.iter().map(coats).collect::<Option<_>>()?,
            background: scene.background,
        })
    }

    /// Shades row `y`, counted from the top; `row` is as long as the camera is wide.
    pub fn shade_row(&self, y: usize, row: &mut [Linear]) {
        for (index, pixels) in row.chunks_mut(WIDTH).enumerate() {
            self.shade(index * WIDTH, y, pixels);
        }
    }

    /// Up to eight pixels, from column `x` on.
    fn shade(&self, x: usize, y: usize, pixels: &mut [Linear]) {
        if self.planes.is_empty() && !self.spheres.iter().any(|sphere| near(sphere, x, y)) {
            pixels.fill(self.background);
            return;
        }
        let d = Wide::ray(&self.camera, x, y);
        let Seen {
            normals, materials, ..
        } = self.first_hit(&d, x, y);
        let v = Wide::reverse(&d);
        let mut each = materials.array();
        // As a rule they are all of one material.
        if each == [each[0]; WIDTH] {
            let lit = self.lit(each[0], &normals, &v);
            match pixels.first_chunk_mut() {
                Some(pixels) => *pixels = lit,
                None => pixels.copy_from_slice(&lit[..pixels.len()]),
            }
            return;
        }
        for i in 0..pixels.len() {
            let material = each[i];
            if material == SHOWN {
                continue;
            }
            let lit = self.lit(material, &normals, &v);
            let rest = pixels.iter_mut().zip(&mut each).zip(lit).skip(i);
            for ((shown, other), lit) in rest {
                if *other == material {
                    *shown = lit;
                    *other = SHOWN;
                }
            }
        }
    }

    /// The pixels of a material, or of none, with these normals.
    #[inline(always)]
    fn lit(&self, material: f32, n: &Direction<Wide>, v: &Direction<Wide>) -> [Linear; WIDTH] {
        if material == NOTHING {
            return [self.background; WIDTH];
        }
        // A shape whose material is past the end is black.
        let Some(coats) = self.materials.get(material as usize) else {
            return Default::default();
        };
        clamped(&self.light(coats, n, v))
    }

    /// Depth, normal and material of what the rays meet first, in the core's
    /// order.
    fn first_hit(&self, d: &Direction<Wide>, x: usize, y: usize) -> Seen {
        let mut seen = Seen {
            depths: Lanes::ZERO,
            normals: Direction::new(Lanes::ZERO, Lanes::ZERO, Lanes::ZERO),
            materials: Lanes::all(NOTHING),
        };
        // As numbers they are exact.
        let columns = Lanes::of(|i| (x + i) as f32);
        for sphere in self.spheres.iter().filter(|sphere| near(sphere, x, y)) {
            if let Some(hit) = sphere.hit(d) {
                let [first, end] = sphere.extent.columns.map(|c| Lanes::all(c.into()));
                let within = columns.at_least(first).and(columns.below(end));
                seen.meet(&hit, within);
            }
        }
        for plane in &self.planes {
            if let Some(hit) = plane.hit(d) {
                seen.meet(&hit, columns.numbers());
            }
        }
        seen
    }

    /// The light of a material's parts with these normals.
    #[inline(always)]
    fn light(&self, coats: &[Coat], n: &Direction<Wide>, v: &Direction<Wide>) -> Rgb<Lanes> {
        let n_dot_v = Wide::dot(n, v);
        let mut total = Rgb::default();
        for (index, coat) in coats.iter().enumerate() {
            let mut sum = match &coat.daylight {
                Some(sky) => sky.light(n_dot_v),
                None => Rgb::default(),
            };
            for (l, gain) in self.lights.iter().zip(&coat.gains) {
                let geometry = Lit::new(*n, *l, *v, n_dot_v);
                sum = sum.zip(coat.model.shade(gain, &geometry), Wide::add_light);
            }
            total = if index == 0 {
                sum
            } else {
                total.zip(sum, Wide::add_light)
            };
        }
        total
    }
}

impl Seen {
    /// Takes a shape where it is the nearest so far, of pixels that `may` see it.
    #[inline(always)]
    fn meet(&mut self, (depths, normals, material): &(Lanes, Direction<Wide>, u8), may: Which) {
        let first = self.materials.below(Lanes::ZERO).and(depths.numbers());
        let taken = first.or(depths.below(self.depths)).and(may);
        self.depths = taken.choose(*depths, self.depths);
        self.normals.x = taken.choose(normals.x, self.normals.x);
        self.normals.y = taken.choose(normals.y, self.normals.y);
        self.normals.z = taken.choose(normals.z, self.normals.z);
        let material = Lanes::all((*material).into());
        self.materials = taken.choose(material, self.materials);
    }
}

/// Whether one of the pixels from column `x` of row `y` on may see a sphere.
fn near(sphere: &Sphere<Wide>, x: usize, y: usize) -> bool {
    let [first, end] = sphere.extent.columns.map(usize::from);
    let [above, below] = sphere.extent.rows.map(usize::from);
    (first < x + WIDTH) & (x < end) & (above <= y) & (y < below)
}

fn sphere(sphere: &Sphere<One>) -> Sphere<Wide> {
    Sphere {
        eye: sphere.eye.map(Lanes::all),
        radius: Lanes::all(sphere.radius),
        material: sphere.material,
        extent: sphere.extent,
    }
}

fn plane(ground: &Checker<One>) -> Option<Plane<Wide>> {
    let plane = &ground.plane;
    (ground.odd == plane.material).then_some(Plane {
        normal: all(plane.normal),
        height: Lanes::all(plane.height),
        material: plane.material,
    })
}

fn coats(coat: &PreparedCoat<One>) -> Option<Vec<Coat>> {
    let rgb = |gain: [f64; 3]| Rgb::from_array(gain.map(One::gain));
    let mut sky = coat.daylight.map(|(albedo, gain)| AlbedoDaylight {
        albedo,
        gain: rgb(gain),
    });
    let coats = coat.parts.iter().map(|part| {
        Some(Coat {
            model: part.material.part().ok()?,
            gains: part.gains.iter().copied().map(rgb).collect(),
            // The sky answers to the whole: it is added once.
            daylight: sky.take(),
        })
    });
    coats.collect()
}
