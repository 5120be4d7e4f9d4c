//! One picture of values and one of errors.

use microbrdf::ParameterError;
use microbrdf::Rgb;
use microbrdf::brdf::Brdf as _;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_reference as reference;
use microbrdf_scene::{HostArithmetic, Material};
use rayon::prelude::*;

use super::band::{Across, Band};
use super::pair::{Plane, pair};
use crate::picture::Picture;

/// Columns: an odd number, so that the middle is exactly the mirror direction.
pub const WIDTH: usize = 481;
/// Rows: 16 for each of 8 decades, and the last.
pub const HEIGHT: usize = 129;

/// Where no two directions are so far apart, in stripes.
const NOWHERE: [[u8; 3]; 2] = [[96; 3], [72; 3]];
/// Where one direction lies below the horizon and nothing shows.
const BELOW: [u8; 3] = [28, 28, 48];

/// The greatest error, and where.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// |code − exact code| in 8-bit sRGB codes.
    pub lsb: f64,
    /// The number across.
    pub across: f64,
    /// The larger cosine.
    pub cosine: f64,
}

/// What a band shows in a plane.
pub struct Panel {
    /// The pixels as displayed.
    pub value: Picture,
    /// Their errors, by colour.
    pub error: Picture,
    /// The greatest error.
    pub worst: Worst,
    /// Pixels that show a pair of directions above the horizon.
    pub shown: usize,
}

/// The colour of an error in codes: grey within perfect rounding, then blue to
/// 0.6, green to 0.75, yellow to 1, orange to 2, red.
#[must_use]
pub fn error_colour(lsb: f64) -> [u8; 3] {
    // What f64's own rounding leaves.
    if lsb <= 0.500_001 {
        [(lsb * 180.0) as u8; 3]
    } else if lsb <= 0.6 {
        [70, 110, 255]
    } else if lsb <= 0.75 {
        [0, 190, 120]
    } else if lsb <= 1.0 {
        [255, 230, 0]
    } else if lsb <= 2.0 {
        [255, 140, 0]
    } else {
        [255, 0, 40]
    }
}

/// The number across of a column. A patch's edge is never met exactly: which
/// side a tie falls on is nobody's error.
fn number(across: Across, column: usize) -> f64 {
    let half = (WIDTH / 2) as f64;
    let step = match across {
        Across::Radius(_) => across.reach() / (half - 0.5),
        _ => across.reach() / half,
    };
    (column as f64 - half) * step
}

/// The larger cosine of a row.
fn cosine(row: usize) -> f64 {
    10f64.powf(-(row as f64) / 16.0)
}

/// Value and error of one pixel.
struct Pixel {
    value: [u8; 3],
    error: [u8; 3],
    worst: Worst,
    shown: bool,
}

/// Draws a band in a plane at exposure K: arithmetic error, against double
/// precision at the directions and parameters as rounded.
///
/// # Errors
/// A material that the arithmetic does not take.
pub fn panel<A: HostArithmetic>(
    band: &Band,
    plane: Plane,
    exposure: f64,
) -> Result<Panel, ParameterError> {
    let material = Material::from_argument(band.material)
        .expect("the card's own materials are well formed")
        .rounded::<A>();
    let (model, exact) = (material.model::<A>()?, material.reference());
    let gain = Rgb::grey(A::gain(exposure));
    let pixel = |row: usize, column: usize| {
        let (across, cosine) = (number(band.across, column), cosine(row));
        let Some(directions) = pair(band.across, across, cosine, plane) else {
            let stripe = NOWHERE[usize::from((row + column) % 12 < 6)];
            return Pixel {
                value: stripe,
                error: stripe,
                worst: Worst::default(),
                shown: false,
            };
        };
        let [l, v] = directions.map(|d| d.map(A::component));
        let geometry = ShadingFrame::new(
            Direction::<A>::new(l[0], l[1], l[2]),
            Direction::new(v[0], v[1], v[2]),
        );
        let code = A::linear(model.shade(&gain, &geometry)).srgb8();
        let [l, v] = [l, v].map(|d| reference::Direction::from(d.map(A::component_value)));
        let shares = exact.rho(&l, &v);
        let mut lsb = 0.0f64;
        for channel in 0..3 {
            let light = (exposure * shares[channel]).clamp(0.0, 1.0);
            let encoded = 255.0 * reference::encode_srgb(light);
            lsb = lsb.max((f64::from(code[channel]) - encoded).abs());
        }
        let below = l.z < 0.0 || v.z < 0.0;
        Pixel {
            value: if below && code == [0; 3] { BELOW } else { code },
            error: if below && lsb == 0.0 {
                BELOW
            } else {
                error_colour(lsb)
            },
            worst: Worst {
                lsb,
                across,
                cosine,
            },
            shown: !below,
        }
    };
    let pixels: Vec<Pixel> = (0..WIDTH * HEIGHT)
        .into_par_iter()
        .map(|i| pixel(i / WIDTH, i % WIDTH))
        .collect();
    let picture = |colour: &dyn Fn(&Pixel) -> [u8; 3]| Picture {
        width: WIDTH,
        height: HEIGHT,
        pixels: pixels.iter().map(colour).collect(),
    };
    let worst = pixels
        .iter()
        .map(|pixel| pixel.worst)
        .fold(Worst::default(), |a, b| if b.lsb > a.lsb { b } else { a });
    Ok(Panel {
        value: picture(&|pixel| pixel.value),
        error: picture(&|pixel| pixel.error),
        worst,
        shown: pixels.iter().filter(|pixel| pixel.shown).count(),
    })
}
