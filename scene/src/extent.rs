//! Where in the picture a sphere is seen.

use std::f64::consts::FRAC_PI_2;

use microbrdf::shade::Extent;

use crate::description::{CameraDescription, SphereDescription};
use crate::prepare::{camera_frame, half_pixel};
use crate::vector::{dot, sub};

/// Pixels that are added at each side: rays are rounded, by far less.
const MARGIN: f64 = 1.0;

/// Columns and rows, `side` for each of the picture's, between the planes
/// through the eye that touch the sphere.
pub(crate) fn extent(camera: &CameraDescription, sphere: &SphereDescription, side: u16) -> Extent {
    let [ahead, right, up] = camera_frame(camera);
    let centre = sub(sphere.center, camera.eye);
    let half = half_pixel(camera) / f64::from(side);
    let ahead = dot(centre, ahead);
    let along = |axis: [f64; 3], pixels: u16| {
        let slopes = slopes(ahead, dot(centre, axis), sphere.radius);
        range(slopes.map(|slope| slope / half), pixels * side)
    };
    Extent {
        columns: along(right, camera.width),
        // Rows are counted downwards.
        rows: along(up.map(|c| -c), camera.height),
    }
}

/// Slopes between which a circle is seen from the origin.
fn slopes(ahead: f64, aside: f64, radius: f64) -> [f64; 2] {
    let distance = ahead.hypot(aside);
    if distance <= radius {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    let (middle, half) = (aside.atan2(ahead), (radius / distance).asin());
    let slope = |angle: f64| {
        if angle <= -FRAC_PI_2 {
            f64::NEG_INFINITY
        } else if angle >= FRAC_PI_2 {
            f64::INFINITY
        } else {
            angle.tan()
        }
    };
    [slope(middle - half), slope(middle + half)]
}

/// Pixels whose middles lie between two numbers of half pixels from the
/// picture's middle, and `MARGIN` more.
fn range(half_pixels: [f64; 2], pixels: u16) -> [u16; 2] {
    let index = |half_pixels: f64| 0.5 * (half_pixels + f64::from(pixels) - 1.0);
    let [first, last] = half_pixels.map(index);
    // A float's conversion clamps to the range of the integer.
    let first = (first - MARGIN).ceil().max(0.0) as u16;
    let end = (last + MARGIN).floor() as u16;
    if last + MARGIN < 0.0 {
        return [0, 0];
    }
    [first, end.saturating_add(1).min(pixels)]
}
