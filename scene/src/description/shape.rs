//! `[[sphere]]` and `[[plane]]`.

use super::camera::CameraDescription;
use super::{COORDINATE, GREATEST_LENGTH, Materials, read_unit};
use crate::error::Fault;
use crate::reader::Table;
use crate::vector::{dot, length, sub};

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

pub(super) fn read_sphere(
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

pub(super) fn read_plane(
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
