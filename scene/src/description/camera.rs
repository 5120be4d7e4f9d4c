//! `[camera]`.

use super::COORDINATE;
use crate::error::Fault;
use crate::reader::Table;
use crate::vector::{length, sub};

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

pub(super) fn read_camera(table: &Table<'_, '_>) -> Result<CameraDescription, Fault> {
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
