//! `[[mesh]]`.

use std::path::Path;

use super::camera::CameraDescription;
use super::{COORDINATE, Materials};
use crate::error::Fault;
use crate::mesh::{Obj, Placed};
use crate::reader::{Table, list};
use crate::vector::{cross, length, sub};

/// Greatest size of an OBJ file.
const GREATEST_SIZE: u64 = 4 << 20;

/// Reads a mesh and places its triangles; files are sought in `folder`.
pub(super) fn read_mesh(
    table: &Table<'_, '_>,
    folder: &Path,
    camera: &CameraDescription,
    materials: &mut Materials,
) -> Result<Vec<Placed>, Fault> {
    let file = table.required("file")?;
    let name = file.string()?;
    let path = folder.join(name);
    let told = |message: String| Fault::new(file.offset, format!("{}: {message}", file.name));
    let text = crate::files::read_at_most(&path, GREATEST_SIZE)
        .map_err(|error| told(error.to_string()))?;
    let file_name = path.file_name().unwrap_or_default().to_string_lossy();
    let obj = Obj::read(&file_name, &text)
        .map_err(|error| told(format!("{}: {error}", path.display())))?;
    let used = used_materials(table, &obj, materials)?;
    let transform = Transform::read(table)?;
    let positions: Vec<_> = obj
        .positions
        .iter()
        .map(|position| sub(transform.place(*position), camera.eye))
        .collect();
    let smooth = smooth_normals(&obj);
    Ok(obj
        .triangles
        .iter()
        .map(|triangle| Placed {
            corners: triangle.corners.map(|corner| positions[corner]),
            normals: match triangle.normals {
                Some(normals) => normals.map(|index| transform.turn(obj.normals[index])),
                None => triangle
                    .corners
                    .map(|corner| transform.turn(smooth[corner])),
            },
            material: used[triangle.material.map_or(0, |index| index + 1)],
        })
        .collect())
}

/// The scene's material of faces without a name, then of each name.
fn used_materials(
    table: &Table<'_, '_>,
    obj: &Obj,
    materials: &mut Materials,
) -> Result<Vec<usize>, Fault> {
    let names: Vec<_> = obj.materials.iter().map(String::as_str).collect();
    let mut named = vec![None; names.len()];
    if let Some(given) = table.optional("materials") {
        for (name, value) in given.table()?.values() {
            let Some(index) = names.iter().position(|known| *known == name) else {
                return Err(Fault::new(
                    value.offset,
                    format!(
                        "{}: the file's faces have no such material, but {}",
                        value.name,
                        list(&names)
                    ),
                ));
            };
            named[index] = Some(materials.index_of(&value)?);
        }
    }
    let nameless = obj.triangles.iter().any(|t| t.material.is_none());
    let default = match table.optional("material") {
        Some(value) => Some(materials.index_of(&value)?),
        None if nameless => return Err(table.fault("the field `material` is missing")),
        None => None,
    };
    let mut used = vec![default.unwrap_or_default()];
    for (name, index) in names.iter().zip(named) {
        let index = index.or(default).ok_or_else(|| {
            table.fault(format!(
                "the file's material `{}` has no entry in `materials`, and there is no `material`",
                crate::error::shortened(name)
            ))
        })?;
        used.push(index);
    }
    Ok(used)
}

/// The mean of the adjoining faces' normals at each position, by their areas.
fn smooth_normals(obj: &Obj) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; obj.positions.len()];
    for triangle in &obj.triangles {
        let [a, b, c] = triangle.corners.map(|corner| obj.positions[corner]);
        let normal = cross(sub(b, a), sub(c, a));
        for corner in triangle.corners {
            for i in 0..3 {
                sums[corner][i] += normal[i];
            }
        }
    }
    // Where they cancel the triangle's own is taken, later.
    sums.into_iter()
        .map(|sum| sum.map(|c| c / length(sum).max(1e-30)))
        .collect()
}

/// Where a mesh stands: scaled, turned, moved.
struct Transform {
    /// Rows of the rotation.
    rotation: [[f64; 3]; 3],
    scale: f64,
    position: [f64; 3],
}

impl Transform {
    fn read(table: &Table<'_, '_>) -> Result<Self, Fault> {
        let triple = |field, range, default| match table.optional(field) {
            Some(value) => value.triple(range),
            None => Ok(default),
        };
        let [x, y, z] = triple("rotate", -360.0..=360.0, [0.0; 3])?
            .map(f64::to_radians)
            .map(f64::sin_cos);
        Ok(Self {
            rotation: rotation(x, y, z),
            scale: match table.optional("scale") {
                Some(scale) => scale.number(1e-6..=1e6)?,
                None => 1.0,
            },
            position: triple("position", COORDINATE, [0.0; 3])?,
        })
    }

    fn turn(&self, v: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| crate::vector::dot(row, v))
    }

    fn place(&self, v: [f64; 3]) -> [f64; 3] {
        let turned = self.turn(v.map(|c| c * self.scale));
        [0, 1, 2].map(|i| turned[i] + self.position[i])
    }
}

/// About x, then y, then z, each given by sine and cosine.
fn rotation((sx, cx): (f64, f64), (sy, cy): (f64, f64), (sz, cz): (f64, f64)) -> [[f64; 3]; 3] {
    [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
}
