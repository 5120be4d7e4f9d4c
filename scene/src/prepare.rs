//! A description in one arithmetic's numbers.

use microbrdf::ParameterError;
use microbrdf::geometry::Direction;
use microbrdf::shade::{Camera, LINEAR_ONE, Linear, Plane, Sphere};
use microbrdf::table::CosineCurve;
use microbrdf_reference as reference;

use crate::albedo::AlbedoTable;
use crate::curve::cosine_curve;
use crate::description::{CameraDescription, Description, cross, dot, length, sub};
use crate::host::HostArithmetic;
use crate::material::Material;
use crate::model::AnyModel;
use crate::reader::Colour;

/// A scene as the core takes it, owned.
#[derive(Clone, Debug)]
pub struct Prepared<A: HostArithmetic> {
    /// Where it is seen from.
    pub camera: Camera<A>,
    /// Its spheres.
    pub spheres: Vec<Sphere<A>>,
    /// Its planes.
    pub planes: Vec<Plane<A>>,
    /// Directions to its lights.
    pub lights: Vec<Direction<A>>,
    /// Its materials.
    pub coats: Vec<PreparedCoat<A>>,
    /// What a ray that meets nothing sees.
    pub background: Linear,
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
        let direction = |vector: [f64; 3]| {
            let [x, y, z] = vector.map(A::component);
            Direction::new(x, y, z)
        };
        let linear = |value: f64| {
            (value * self.exposure * f64::from(LINEAR_ONE))
                .round()
                .min(f64::from(u32::MAX)) as u32
        };
        let [r, g, b] = self.background.map(linear);
        Ok(Prepared {
            camera: camera(&self.camera),
            spheres: self
                .spheres
                .iter()
                .map(|sphere| Sphere {
                    eye: sub(eye, sphere.center).map(|c| A::length(c / sphere.radius)),
                    radius: A::length(sphere.radius),
                    material: sphere.material as u8,
                })
                .collect(),
            planes: self
                .planes
                .iter()
                .map(|plane| Plane {
                    normal: direction(plane.normal),
                    height: A::length(dot(sub(eye, plane.point), plane.normal)),
                    material: plane.material as u8,
                })
                .collect(),
            lights: self
                .lights
                .iter()
                .map(|light| direction(light.direction))
                .collect(),
            coats: self
                .materials
                .iter()
                .map(|(name, material)| {
                    self.coat(material)
                        .map_err(|error| format!("material.{name}: {error}"))
                })
                .collect::<Result<_, _>>()?,
            background: Linear::from_raw(r, g, b),
        })
    }

    fn coat<A: HostArithmetic>(
        &self,
        material: &Material,
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
                    gains: self.lights.iter().map(|light| gain(light.color)).collect(),
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
            Self::Plastic {
                albedo,
                specular,
                exponent,
            } => vec![
                (white, albedo.rgb()),
                (
                    Self::Phong {
                        exponent: *exponent,
                        p: 1.0,
                        retro: false,
                        energy: reference::Energy::Published,
                    },
                    specular.rgb(),
                ),
            ],
            _ => vec![(self.clone(), [1.0; 3])],
        }
    }
}

/// The camera's unit vectors: ahead, to the right and up.
#[must_use]
pub fn camera_frame(camera: &CameraDescription) -> [[f64; 3]; 3] {
    let unit = |vector: [f64; 3]| vector.map(|c| c / length(vector));
    let ahead = unit(sub(camera.target, camera.eye));
    let right = unit(cross(ahead, [0.0, 0.0, 1.0]));
    [ahead, right, cross(right, ahead)]
}

/// Half a pixel at distance 1.
#[must_use]
pub fn half_pixel(camera: &CameraDescription) -> f64 {
    (0.5 * camera.fov.to_radians()).tan() / f64::from(camera.height)
}

fn camera<A: HostArithmetic>(camera: &CameraDescription) -> Camera<A> {
    let [ahead, right, up] = camera_frame(camera);
    let step = half_pixel(camera);
    Camera {
        width: camera.width,
        height: camera.height,
        forward: ahead.map(A::fine),
        right: right.map(|c| A::fine(c * step)),
        up: up.map(|c| A::fine(c * step)),
    }
}
