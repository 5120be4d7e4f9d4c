//! Scene files.

mod camera;
mod light;
mod mesh;
mod shape;

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::{Fault, SceneError};
use crate::material::{Material, parse};
use crate::mesh::{Placed, SeenView, look};
use crate::quality::AnySamples;
use crate::reader::{Table, Value, list};
use crate::vector::length;

pub use camera::CameraDescription;
pub use light::{LightDescription, LightKind};
pub use shape::{CheckerDescription, PlaneDescription, SphereDescription};

use camera::read_camera;
use light::read_light;
use mesh::read_mesh;
use shape::{read_plane, read_sphere};

/// A scene as its file gives it, every value within its range and every name
/// resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Name, at most 32 printable ASCII characters.
    pub name: String,
    /// Where it is seen from.
    pub camera: CameraDescription,
    /// Its spheres.
    pub spheres: Vec<SphereDescription>,
    /// Its planes.
    pub planes: Vec<PlaneDescription>,
    /// What the camera sees of its meshes, where it has some.
    pub view: Option<SeenView>,
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
    /// Whether spheres and planes throw shadows.
    pub shadows: bool,
    /// How many rays a pixel is made of.
    pub samples: AnySamples,
    /// The materials that an object uses, in the order of their names.
    pub materials: Vec<(String, Material)>,
}

/// Coordinates, well within what a microcontroller's numbers hold.
const COORDINATE: std::ops::RangeInclusive<f64> = -1000.0..=1000.0;
/// Greatest distance of the eye from a sphere's centre, in its radii, and of
/// anything from the eye.
pub(crate) const GREATEST_LENGTH: f64 = 127.0;
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
    /// the text does not say. The files of meshes are sought beside
    /// `source_name`.
    ///
    /// # Errors
    /// The first mistake, with its place.
    pub fn from_toml(source_name: &str, name: &str, text: &str) -> Result<Self, SceneError> {
        let folder = Path::new(source_name).parent().unwrap_or(Path::new(""));
        let read = || Self::read(name, folder, &Table::new("", &parse(text)?));
        read().map_err(|fault| fault.within(source_name, text))
    }

    fn read(name: &str, folder: &Path, table: &Table<'_, '_>) -> Result<Self, Fault> {
        let name = match table.optional("name") {
            Some(value) => {
                let name = value.string()?;
                if name.is_empty() || name.len() > 32 || !name.chars().all(printable) {
                    return Err(value.fault("1 to 32 printable ASCII characters"));
                }
                name.to_owned()
            }
            None => name.chars().filter(|&c| printable(c)).take(32).collect(),
        };
        let camera = read_camera(&table.required("camera")?.table()?)?;
        let mut names = Materials::read(table.optional("material"))?;
        let spheres = read_all(table.optional("sphere"), |sphere| {
            read_sphere(sphere, &camera, &mut names)
        })?;
        let planes = read_all(table.optional("plane"), |plane| {
            read_plane(plane, &camera, &mut names)
        })?;
        let view = match table.optional("mesh") {
            None => None,
            Some(meshes) => {
                let (offset, name) = (meshes.offset, meshes.name.clone());
                let triangles: Vec<Placed> = read_all(Some(meshes), |mesh| {
                    read_mesh(mesh, folder, &camera, &mut names)
                })?
                .concat();
                let view = look(&camera, &triangles, &spheres, &planes)
                    .map_err(|message| Fault::new(offset, format!("{name}: {message}")))?;
                Some(view)
            }
        };
        let lights = read_all(table.optional("light"), |light| {
            read_light(light, &camera, &spheres, &planes, view.as_ref())
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
        let shadows = match table.optional("shadows") {
            Some(shadows) => shadows.boolean()?,
            None => false,
        };
        let samples = match table.optional("samples") {
            Some(value) => match value.whole(1..=4) {
                Ok(1) => AnySamples::One,
                Ok(4) if view.is_none() => AnySamples::Four,
                Ok(4) => return Err(value.fault("1 in a scene with a mesh")),
                _ => return Err(value.fault("1 or 4")),
            },
            None => AnySamples::One,
        };
        let widen = match table.optional("widen") {
            Some(widen) => widen.boolean()?,
            None => true,
        };
        table.finish()?;
        let mut scene = Self {
            name,
            dither,
            shadows,
            samples,
            camera,
            spheres,
            planes,
            view,
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
        if widen {
            scene.widen_highlights().map_err(|count| {
                let message = format!(
                    "highlights of {count} widths: must be at most {GREATEST_COUNT}, \
                     or with `widen = false`"
                );
                Fault::new(0, message)
            })?;
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
        self.index_of(&object.required("material")?)
    }

    /// Index of the material of this name.
    fn index_of(&mut self, value: &Value<'_, '_>) -> Result<usize, Fault> {
        let name = value.string()?;
        if let Some(index) = self.used.iter().position(|(used, _)| used == name) {
            return Ok(index);
        }
        let Some(material) = self.all.get(name) else {
            let names: Vec<_> = self.all.keys().map(String::as_str).collect();
            return Err(value.fault(format!("a [material.NAME] of the file: {}", list(&names))));
        };
        if self.used.len() == GREATEST_COUNT {
            return Err(value.fault(format!("among the first {GREATEST_COUNT} that are named")));
        }
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

/// Whether the wire takes a character of a name.
fn printable(c: char) -> bool {
    c == ' ' || c.is_ascii_graphic()
}
