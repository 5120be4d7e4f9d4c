//! Scene files.

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::{Fault, SceneError};
use crate::material::{Material, parse};
use crate::reader::{Table, Value, list};

/// A scene as its file gives it, every value within its range and every name
/// resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Name, at most 32 ASCII characters.
    pub name: String,
    /// Where it is seen from.
    pub camera: CameraDescription,
    /// Its spheres.
    pub spheres: Vec<SphereDescription>,
    /// Its planes.
    pub planes: Vec<PlaneDescription>,
    /// Its lights.
    pub lights: Vec<LightDescription>,
    /// Radiance of a uniform sky, in linear RGB.
    pub daylight: Option<[f64; 3]>,
    /// Radiance of what a ray that meets nothing sees, in linear RGB.
    pub background: [f64; 3],
    /// What radiance is multiplied by.
    pub exposure: f64,
    /// Whether displays of few levels dither.
    pub dither: bool,
    /// The materials that an object uses, in the order of their names.
    pub materials: Vec<(String, Material)>,
}

/// A pinhole camera, upright (+z is up).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraDescription {
    /// Columns.
    pub width: u16,
    /// Rows.
    pub height: u16,
    /// Position.
    pub eye: [f64; 3],
    /// What the middle of the picture shows.
    pub target: [f64; 3],
    /// Vertical field of view in degrees.
    pub fov: f64,
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereDescription {
    /// Position.
    pub center: [f64; 3],
    /// Radius.
    pub radius: f64,
    /// Index into the scene's materials.
    pub material: usize,
}

/// A plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneDescription {
    /// Any of its points.
    pub point: [f64; 3],
    /// Unit normal, towards the eye.
    pub normal: [f64; 3],
    /// Index into the scene's materials.
    pub material: usize,
    /// What every second square has in place of it.
    pub checker: Option<CheckerDescription>,
}

/// The squares of a plane; a corner of four lies at the plane's point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckerDescription {
    /// Index into the scene's materials.
    pub material: usize,
    /// Length of a side.
    pub size: f64,
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Where it is and how it shines.
    pub kind: LightKind,
    /// Normal irradiance of a light at infinity, in linear RGB; of a lamp its
    /// intensity, which is the irradiance at distance 1, for a flood on its axis.
    pub color: [f64; 3],
}

/// Where a light is and how it shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// At infinity.
    Directional {
        /// Unit vector to it.
        direction: [f64; 3],
    },
    /// Alike in all directions.
    Point {
        /// Position.
        position: [f64; 3],
        /// Least distance to anything in the scene.
        near: f64,
    },
    /// As cosⁿξ about an axis.
    Flood {
        /// Position.
        position: [f64; 3],
        /// Least distance to anything in the scene.
        near: f64,
        /// Unit vector in which it shines.
        axis: [f64; 3],
        /// n.
        exponent: f64,
    },
}

/// Coordinates, well within what a microcontroller's numbers hold.
const COORDINATE: std::ops::RangeInclusive<f64> = -1000.0..=1000.0;
/// Greatest distance of the eye from a sphere's centre, in its radii, and of
/// anything from the eye.
const GREATEST_LENGTH: f64 = 127.0;
/// Least distance of a lamp from a surface.
const LEAST_LAMP_DISTANCE: f64 = 0.01;
/// What radiance may be multiplied by.
const EXPOSURE: std::ops::RangeInclusive<f64> = 1e-6..=1e6;
/// Greatest number of objects of a kind.
const GREATEST_COUNT: usize = 255;

impl Description {
    /// Reads a scene file.
    ///
    /// # Errors
    /// The first mistake, with its place; a file that can't be read.
    pub fn from_file(path: &Path) -> Result<Self, SceneError> {
        let text = crate::files::read(path)?;
        let stem = path
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into());
        Self::from_toml(&path.display().to_string(), &stem, &text)
    }

    /// Reads a scene from the text of a file; `name` is what it is called if
    /// the text does not say.
    ///
    /// # Errors
    /// The first mistake, with its place.
    pub fn from_toml(source_name: &str, name: &str, text: &str) -> Result<Self, SceneError> {
        let read = || Self::read(name, &Table::new("", &parse(text)?));
        read().map_err(|fault| fault.within(source_name, text))
    }

    fn read(name: &str, table: &Table<'_, '_>) -> Result<Self, Fault> {
        let name = match table.optional("name") {
            Some(value) => {
                let name = value.string()?;
                if name.is_empty() || name.len() > 32 || !name.is_ascii() {
                    return Err(value.fault("1 to 32 ASCII characters"));
                }
                name.to_owned()
            }
            None => name.chars().filter(char::is_ascii).take(32).collect(),
        };
        let camera = read_camera(&table.required("camera")?.table()?)?;
        let mut names = Materials::read(table.optional("material"))?;
        let spheres = read_all(table.optional("sphere"), |sphere| {
            read_sphere(sphere, &camera, &mut names)
        })?;
        let planes = read_all(table.optional("plane"), |plane| {
            read_plane(plane, &camera, &mut names)
        })?;
        let lights = read_all(table.optional("light"), |light| {
            read_light(light, &camera, &spheres, &planes)
        })?;
        let daylight = match table.optional("daylight") {
            None => None,
            Some(daylight) => {
                let daylight = daylight.table()?;
                let color = daylight.required("color")?.colour(0.0..=1e6)?.rgb();
                daylight.finish()?;
                Some(color)
            }
        };
        let background = match table.optional("background") {
            Some(color) => color.colour(0.0..=1e6)?.rgb(),
            None => [0.0; 3],
        };
        let exposure = table.optional("exposure");
        let by_grey = exposure.as_ref().filter(|value| value.is("auto"));
        let dither = match table.optional("dither") {
            Some(dither) => dither.boolean()?,
            None => true,
        };
        table.finish()?;
        let mut scene = Self {
            name,
            dither,
            camera,
            spheres,
            planes,
            lights,
            daylight,
            background,
            exposure: match &exposure {
                Some(number) if by_grey.is_none() => number
                    .number(EXPOSURE)
                    .map_err(|fault| fault.or(", or \"auto\""))?,
                _ => 1.0,
            },
            materials: names.used,
        };
        if let Some(value) = by_grey {
            let found = scene.grey_sphere_exposure();
            scene.exposure = found
                .filter(|found| EXPOSURE.contains(found))
                .ok_or_else(|| value.fault("a number here: too little light reaches the target"))?;
        }
        Ok(scene)
    }
}

/// The file's materials, and those of them that an object has named.
struct Materials {
    all: BTreeMap<String, Material>,
    used: Vec<(String, Material)>,
}

impl Materials {
    fn read(value: Option<Value<'_, '_>>) -> Result<Self, Fault> {
        let mut all = BTreeMap::new();
        if let Some(value) = value {
            for (name, member) in value.table()?.members()? {
                all.insert(name, Material::read(&member)?);
            }
        }
        Ok(Self {
            all,
            used: Vec::new(),
        })
    }

    /// Index of the material that an object names.
    fn index(&mut self, object: &Table<'_, '_>) -> Result<usize, Fault> {
        let value = object.required("material")?;
        let name = value.string()?;
        if let Some(index) = self.used.iter().position(|(used, _)| used == name) {
            return Ok(index);
        }
        let Some(material) = self.all.get(name) else {
            let names: Vec<_> = self.all.keys().map(String::as_str).collect();
            return Err(value.fault(format!("a [material.NAME] of the file: {}", list(&names))));
        };
        self.used.push((name.to_owned(), material.clone()));
        Ok(self.used.len() - 1)
    }
}

fn read_all<T>(
    value: Option<Value<'_, '_>>,
    mut read: impl FnMut(&Table<'_, '_>) -> Result<T, Fault>,
) -> Result<Vec<T>, Fault> {
    let Some(value) = value else {
        return Ok(Vec::new());
    };
    let tables = value.tables()?;
    if tables.len() > GREATEST_COUNT {
        return Err(Fault::new(
            value.offset,
            format!(
                "{} [[{}]]: must be at most {GREATEST_COUNT}",
                tables.len(),
                value.name
            ),
        ));
    }
    tables
        .iter()
        .map(|table| {
            let item = read(table)?;
            table.finish()?;
            Ok(item)
        })
        .collect()
}

fn read_camera(table: &Table<'_, '_>) -> Result<CameraDescription, Fault> {
    let camera = CameraDescription {
        width: table.required("width")?.whole(1..=1024)? as u16,
        height: table.required("height")?.whole(1..=1024)? as u16,
        eye: table.required("eye")?.triple(COORDINATE)?,
        target: table.required("target")?.triple(COORDINATE)?,
        fov: table.required("fov")?.number(1.0..=90.0)?,
    };
    table.finish()?;
    let view = sub(camera.target, camera.eye);
    if length(view) < 1e-6 {
        return Err(table.fault("`eye` and `target` are the same point: must be apart"));
    }
    if view[0].hypot(view[1]) < 1e-6 * length(view) {
        return Err(table.fault("the camera looks straight up or down: +z must not be ahead of it"));
    }
    let slope =
        (0.5 * camera.fov.to_radians()).tan() * f64::from(camera.width) / f64::from(camera.height);
    if slope > 4.0 {
        return Err(table.fault(format!(
            "a picture {} times as wide as high at this `fov`: half its width must be seen at a \
             slope of at most 4, is {slope:.2}",
            f64::from(camera.width) / f64::from(camera.height)
        )));
    }
    Ok(camera)
}

fn read_sphere(
    table: &Table<'_, '_>,
    camera: &CameraDescription,
    materials: &mut Materials,
) -> Result<SphereDescription, Fault> {
    let center = table.required("center")?.triple(COORDINATE)?;
    let radius = table.required("radius")?.number(1e-3..=100.0)?;
    let distance = length(sub(camera.eye, center)) / radius;
    if distance <= 1.001 {
        return Err(table.fault("the camera is inside this sphere: must be outside"));
    }
    if distance > GREATEST_LENGTH {
        return Err(table.fault(format!(
            "the camera is {distance:.1} radii from its center: must be at most {GREATEST_LENGTH}"
        )));
    }
    Ok(SphereDescription {
        center,
        radius,
        material: materials.index(table)?,
    })
}

fn read_plane(
    table: &Table<'_, '_>,
    camera: &CameraDescription,
    materials: &mut Materials,
) -> Result<PlaneDescription, Fault> {
    let point = table.required("point")?.triple(COORDINATE)?;
    let direction = read_unit(table, "normal")?;
    let height = dot(sub(camera.eye, point), direction);
    if height.abs() < 1e-3 || height.abs() > GREATEST_LENGTH {
        return Err(table.fault(format!(
            "the camera is {:.4} above this plane: must be from 0.001 to {GREATEST_LENGTH}",
            height.abs()
        )));
    }
    let normal = direction.map(|component| component * height.signum());
    let material = materials.index(table)?;
    let checker = match table.optional("checker") {
        None => None,
        Some(checker) => {
            let checker = checker.table()?;
            let squares = CheckerDescription {
                material: materials.index(&checker)?,
                size: checker.required("size")?.number(0.05..=1000.0)?,
            };
            checker.finish()?;
            Some(squares)
        }
    };
    Ok(PlaneDescription {
        point,
        normal,
        material,
        checker,
    })
}

fn read_light(
    table: &Table<'_, '_>,
    camera: &CameraDescription,
    spheres: &[SphereDescription],
    planes: &[PlaneDescription],
) -> Result<LightDescription, Fault> {
    let kind = table.required("kind")?;
    let color = |field| table.required(field)?.colour(0.0..=1e6);
    let (kind, color) = match kind.string()? {
        "directional" => {
            let direction = read_unit(table, "direction")?;
            (LightKind::Directional { direction }, color("color")?)
        }
        name @ ("point" | "flood") => {
            let position = table.required("position")?.triple(COORDINATE)?;
            let near = lamp_distance(table, position, camera, spheres, planes)?;
            let kind = if name == "point" {
                LightKind::Point { position, near }
            } else {
                LightKind::Flood {
                    position,
                    near,
                    axis: read_unit(table, "axis")?,
                    exponent: table.required("exponent")?.number(1.0..=1e4)?,
                }
            };
            (kind, color("intensity")?)
        }
        _ => return Err(kind.fault("\"directional\", \"point\" or \"flood\"")),
    };
    Ok(LightDescription {
        kind,
        color: color.rgb(),
    })
}

/// Least distance of a lamp from anything in the scene; 1 where it is empty.
fn lamp_distance(
    table: &Table<'_, '_>,
    position: [f64; 3],
    camera: &CameraDescription,
    spheres: &[SphereDescription],
    planes: &[PlaneDescription],
) -> Result<f64, Fault> {
    let from_eye = length(sub(position, camera.eye));
    if from_eye > GREATEST_LENGTH {
        return Err(table.fault(format!(
            "this lamp is {from_eye:.1} from the camera: must be at most {GREATEST_LENGTH}"
        )));
    }
    let spheres = spheres
        .iter()
        .map(|sphere| (length(sub(position, sphere.center)) - sphere.radius).abs());
    let planes = planes
        .iter()
        .map(|plane| dot(sub(position, plane.point), plane.normal).abs());
    let near = spheres.chain(planes).fold(f64::INFINITY, f64::min);
    if near < LEAST_LAMP_DISTANCE {
        return Err(table.fault(format!(
            "this lamp is {near:.4} from a surface: must be at least {LEAST_LAMP_DISTANCE}"
        )));
    }
    Ok(if near.is_finite() {
        near.min(GREATEST_LENGTH)
    } else {
        1.0
    })
}

/// A vector of any length but 0, normalised.
fn read_unit(table: &Table<'_, '_>, field: &'static str) -> Result<[f64; 3], Fault> {
    let value = table.required(field)?;
    let vector = value.triple(COORDINATE)?;
    let norm = length(vector);
    if norm < 1e-9 {
        Err(value.fault("longer than 0"))
    } else {
        Ok(vector.map(|c| c / norm))
    }
}

pub(crate) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
