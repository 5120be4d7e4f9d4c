//! `[[light]]`.

use super::camera::CameraDescription;
use super::shape::{PlaneDescription, SphereDescription};
use super::{COORDINATE, GREATEST_LENGTH, read_unit};
use crate::error::Fault;
use crate::mesh::SeenView;
use crate::reader::Table;
use crate::vector::{dot, length, sub};

/// Least distance of a lamp from a surface.
const LEAST_LAMP_DISTANCE: f64 = 0.01;

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Where it is and how it shines.
    pub kind: LightKind,
    /// Normal irradiance of a light at infinity, in linear RGB; of a lamp its
    /// intensity, which is the irradiance at distance 1, for a flood on its axis.
    pub color: [f64; 3],
    /// How large it is: the angular diameter in rad of one at infinity, a
    /// lamp's diameter. It widens highlights and nothing else.
    pub size: f64,
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

pub(super) fn read_light(
    table: &Table<'_, '_>,
    camera: &CameraDescription,
    spheres: &[SphereDescription],
    planes: &[PlaneDescription],
    view: Option<&SeenView>,
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
            let near = lamp_distance(table, position, camera, spheres, planes)?
                .min(seen_distance(position, camera, view));
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
    let size = match (table.optional("size"), &kind) {
        (None, _) => 0.0,
        (Some(size), LightKind::Directional { .. }) => size.number(0.0..=20.0)?.to_radians(),
        (Some(size), _) => size.number(0.0..=10.0)?,
    };
    Ok(LightDescription {
        size,
        kind,
        color: color.rgb(),
    })
}

/// Least distance of a lamp from what the camera sees of meshes, 0.01 or more.
fn seen_distance(position: [f64; 3], camera: &CameraDescription, view: Option<&SeenView>) -> f64 {
    let Some(view) = view else {
        return f64::INFINITY;
    };
    view.mirrored(camera)
        .iter()
        .flatten()
        .map(|at| length(sub(position, at.place)))
        .fold(f64::INFINITY, f64::min)
        .max(LEAST_LAMP_DISTANCE)
}

/// Least distance of a lamp from anything else in the scene; 1 where it is empty.
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
