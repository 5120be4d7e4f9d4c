//! A description in one arithmetic's numbers.

use microbrdf::ParameterError;
use microbrdf::shade::{Camera, Checker, LINEAR_ONE, Linear, Plane, Samples as _, Sphere};
use microbrdf::table::CosineCurve;
use microbrdf_reference as reference;

use crate::albedo::AlbedoTable;
use crate::curve::cosine_curve;
use crate::description::{
    CameraDescription, Description, LightDescription, LightKind, PlaneDescription,
};
use crate::extent::extent;
use crate::host::HostArithmetic;
use crate::lamp::{AnyLight, rounded};
use crate::material::{Material, Reflectance};
use crate::mesh::PreparedView;
use crate::model::AnyModel;
use crate::quality::{AnySamples, AnyShadows};
use crate::reader::Colour;
use crate::vector::{cross, dot, length, sub, unit};

/// A scene as the core takes it, owned.
#[derive(Clone, Debug)]
pub struct Prepared<A: HostArithmetic> {
    /// Where it is seen from.
    pub camera: Camera<A>,
    /// What is seen of its meshes.
    pub view: Option<PreparedView<A>>,
    /// Its spheres.
    pub spheres: Vec<Sphere<A>>,
    /// Its planes, those of one material as a checker of twice the same.
    pub planes: Vec<Checker<A>>,
    /// Its lights.
    pub lights: Vec<AnyLight<A>>,
    /// Its materials.
    pub coats: Vec<PreparedCoat<A>>,
    /// What a ray that meets nothing sees.
    pub background: Linear,
    /// Whether its spheres throw shadows.
    pub shadows: AnyShadows,
    /// How many rays a pixel is made of.
    pub samples: AnySamples,
}

/// A material under the scene's lights.
#[derive(Clone, Debug)]
pub struct PreparedCoat<A: HostArithmetic> {
    /// Its parts, whose light is added: one, or two for a plastic.
    pub parts: Vec<PreparedPart<A>>,
    /// The albedo of the whole, and the gain of the sky.
    pub daylight: Option<(CosineCurve, [f64; 3])>,
}

/// One model of a material.
#[derive(Clone, Debug)]
pub struct PreparedPart<A: HostArithmetic> {
    /// The material that is just this part.
    pub material: Material,
    /// Its model.
    pub model: AnyModel<A>,
    /// Gain per light and channel.
    pub gains: Vec<[f64; 3]>,
}

impl Description {
    /// The scene in the numbers of `A`.
    ///
    /// # Errors
    /// A material that this arithmetic does not take, by name.
    pub fn prepare<A: HostArithmetic>(&self) -> Result<Prepared<A>, String> {
        let eye = self.camera.eye;
        let linear = |value: f64| {
            (value * self.exposure * f64::from(LINEAR_ONE))
                .round()
                .min(f64::from(u32::MAX)) as u32
        };
        let [r, g, b] = self.background.map(linear);
        let mut lights = Vec::new();
        let mut irradiances = Vec::new();
        for (index, light) in self.lights.iter().enumerate() {
            if self.shadows && self.behind_a_plane(light) {
                continue;
            }
            let (prepared, factor) = light
                .prepare::<A>(eye)
                .map_err(|error| format!("light[{}]: {error}", index + 1))?;
            lights.push(prepared);
            irradiances.push(light.color.map(|c| c * factor));
        }
        Ok(Prepared {
            camera: camera(&self.camera, self.samples.side()),
            view: self.view.as_ref().map(|view| {
                let lamp = |kind| !matches!(kind, LightKind::Directional { .. });
                let places = self.shadows || self.lights.iter().any(|light| lamp(light.kind));
                PreparedView::new(view, &self.materials, places)
            }),
            spheres: self
                .spheres
                .iter()
                .map(|sphere| Sphere {
                    eye: sub(eye, sphere.center).map(|c| A::length(c / sphere.radius)),
                    radius: A::length(sphere.radius),
                    material: sphere.material as u8,
                    extent: extent(&self.camera, sphere, self.samples.side()),
                })
                .collect(),
            planes: self.planes.iter().map(|p| checker(p, eye)).collect(),
            lights,
            coats: self
                .materials
                .iter()
                .map(|(name, material)| {
                    self.coat(material, &irradiances)
                        .map_err(|error| format!("material.{name}: {error} in {}", A::NAME))
                })
                .collect::<Result<_, _>>()?,
            background: Linear::from_raw(r, g, b),
            shadows: AnyShadows(self.shadows),
            samples: self.samples,
        })
    }

    /// Whether a plane keeps the light from everything: the eye, and so
    /// whatever it sees, is before every plane.
    fn behind_a_plane(&self, light: &LightDescription) -> bool {
        self.planes.iter().any(|plane| match light.kind {
            LightKind::Directional { direction } => dot(direction, plane.normal) < 0.0,
            LightKind::Point { position, .. } | LightKind::Flood { position, .. } => {
                dot(sub(position, plane.point), plane.normal) < 0.0
            }
        })
    }

    fn coat<A: HostArithmetic>(
        &self,
        material: &Material,
        irradiances: &[[f64; 3]],
    ) -> Result<PreparedCoat<A>, ParameterError> {
        let parts = material
            .parts()
            .into_iter()
            .map(|(part, tint)| {
                let peak = part.reference().peak();
                let gain =
                    |color: [f64; 3]| [0, 1, 2].map(|c| peak * tint[c] * color[c] * self.exposure);
                Ok(PreparedPart {
                    model: part.model()?,
                    gains: irradiances.iter().map(|color| gain(*color)).collect(),
                    material: part,
                })
            })
            .collect::<Result<_, _>>()?;
        let daylight = self.daylight.map(|sky| {
            let albedo = AlbedoTable::of(material);
            let curve = cosine_curve(&|cosine| albedo.at(cosine));
            (curve, sky.map(|channel| channel * self.exposure))
        });
        Ok(PreparedCoat { parts, daylight })
    }
}

impl Material {
    /// The elementary models that it is the sum of, each with the tint that
    /// its light is multiplied by.
    #[must_use]
    pub fn parts(&self) -> Vec<(Self, [f64; 3])> {
        let white = Self::Lambert {
            albedo: Colour::Grey(1.0),
        };
        match self {
            Self::Lambert { albedo } => vec![(white, albedo.rgb())],
            Self::GeneralisedLambert {
                albedo,
                smoothness,
                clip,
            } => vec![(
                Self::GeneralisedLambert {
                    albedo: Colour::Grey(1.0),
                    smoothness: *smoothness,
                    clip: *clip,
                },
                albedo.rgb(),
            )],
            Self::Plastic {
                albedo,
                specular,
                exponent,
                index,
            } => {
                let highlight = match index {
                    None => Self::Phong {
                        exponent: *exponent,
                        p: 1.0,
                        retro: false,
                        energy: reference::Energy::Published,
                    },
                    Some(index) => Self::Metal {
                        exponent: *exponent,
                        reflectance: Reflectance::dielectric(*index),
                    },
                };
                vec![(white, albedo.rgb()), (highlight, specular.rgb())]
            }
            _ => vec![(self.clone(), [1.0; 3])],
        }
    }
}

/// The camera's unit vectors: ahead, to the right and up.
#[must_use]
pub fn camera_frame(camera: &CameraDescription) -> [[f64; 3]; 3] {
    let ahead = unit(sub(camera.target, camera.eye));
    let right = unit(cross(ahead, [0.0, 0.0, 1.0]));
    [ahead, right, cross(right, ahead)]
}

/// Unit vectors along which the squares of a checker are counted: the x axis
/// as near as the plane comes to it (y where that is the normal), and at a
/// right angle.
#[must_use]
pub fn plane_axes(normal: [f64; 3]) -> [[f64; 3]; 2] {
    let axis = if normal[0].abs() < 0.9 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let along = dot(axis, normal);
    let first = sub(axis, normal.map(|c| c * along));
    let first = first.map(|c| c / length(first));
    [first, cross(normal, first)]
}

fn checker<A: HostArithmetic>(plane: &PlaneDescription, eye: [f64; 3]) -> Checker<A> {
    let from = sub(eye, plane.point);
    let (odd, size) = match plane.checker {
        Some(checker) => (checker.material, checker.size),
        None => (plane.material, 1.0),
    };
    let axes = plane_axes(plane.normal);
    Checker {
        plane: Plane {
            normal: rounded(plane.normal),
            height: A::length(dot(from, plane.normal)),
            material: plane.material as u8,
        },
        odd: odd as u8,
        // Two squares on is the same colour again.
        eye: axes.map(|axis| A::fine((dot(from, axis) / size).rem_euclid(2.0))),
        across: axes.map(|axis| axis.map(|c| A::fine(c / size))),
    }
}

/// Half a pixel at distance 1.
#[must_use]
pub fn half_pixel(camera: &CameraDescription) -> f64 {
    (0.5 * camera.fov.to_radians()).tan() / f64::from(camera.height)
}

/// `side` columns and rows for each of the picture's.
fn camera<A: HostArithmetic>(camera: &CameraDescription, side: u16) -> Camera<A> {
    let [ahead, right, up] = camera_frame(camera);
    let step = half_pixel(camera) / f64::from(side);
    Camera {
        width: camera.width * side,
        height: camera.height * side,
        forward: ahead.map(A::fine),
        right: right.map(|c| A::fine(c * step)),
        up: up.map(|c| A::fine(c * step)),
    }
}
