//! The pixels of a sphere, in a display's own levels.

use microbrdf_kernels::sphere::{LIGHT, TINT};
use microbrdf_kernels::sphere_row::{HIGH, STEP, WIDE};
use microbrdf_kernels::{Call, Input, Kernel};
use microbrdf_reference::models::{Energy, MetallicPhong};
use microbrdf_reference::{Brdf, Direction, encode_srgb};
use microbrdf_tests::domain::Pair;
use microbrdf_tests::frame::in_frame;

use crate::errors::{Errors, Tally};

/// Steps of the picture plane's grid from the centre to the edge.
const STEPS: i32 = 100;

/// What a point of the picture plane is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Within the lobe, down to τ = 9.
    Lobe,
    /// Lit, and beyond it.
    Beyond,
    /// Turned away from the light.
    Unlit,
}

/// Every point of a grid within the sphere's outline, of a kernel's place.
#[must_use]
pub fn points(kernel: &Kernel, place: Place) -> Vec<Input> {
    let step = (1 << 14) / STEPS;
    let mut found = Vec::new();
    for y in -STEPS..=STEPS {
        for x in -STEPS..=STEPS {
            let point = [x * step, y * step];
            let exact = point.map(|c| f64::from(c) / f64::from(1 << 14));
            if normal(exact).is_some_and(|normal| self::place(kernel, normal) == place) {
                let mut input = Input::default();
                let half = |c: i32| u32::from(c as i16 as u16);
                input.vectors[0][0] = half(point[0]) | half(point[1]) << 16;
                found.push(input);
            }
        }
    }
    found
}

/// As many of them as asked for, from all over.
#[must_use]
pub fn some(points: &[Input], count: usize) -> Vec<Input> {
    let count = count.min(points.len());
    (0..count)
        .map(|i| points[i * points.len() / count])
        .collect()
}

/// How far in cosα pixels are from the end of a lobe of exponent 0, where all of its light
/// ends: nearer ones are on either side of it, as rounding has it.
const FLAT_END: f64 = 4e-3;

/// Tiles of each place that a kernel of rows is graded on.
const TILES: usize = 200;

/// The errors of a kernel in levels of RGB565: over every point, or over all
/// pixels of many tiles.
///
/// # Panics
/// If the kernel's exponent is none.
#[must_use]
pub fn measure(kernel: &Kernel) -> Errors {
    let model = MetallicPhong::new(kernel.width, Energy::Published).expect("a kernel's exponent");
    let mut tally = Tally::new("lobe");
    let mut grade = |code: u32, point: [f64; 2]| {
        let [l, v] = frame(kernel, normal(point).expect("a point within the outline"));
        let mirrored = l[2] * v[2] - l[0] * v[0] - l[1] * v[1];
        if kernel.width == 0.0 && mirrored.abs() < FLAT_END {
            return;
        }
        let direction = |[x, y, z]: [f64; 3]| Direction::new(x, y, z);
        let rho = kernel.k * model.rho(&direction(l), &direction(v))[0];
        let levels = [code >> 11, (code >> 5) & 63, code & 31];
        for ((level, tint), greatest) in levels.into_iter().zip(TINT).zip([31.0, 63.0, 31.0]) {
            let linear = (rho * f64::from(tint) / f64::from(1 << 24)).clamp(0.0, 1.0);
            tally.add_level(level as u8, greatest * encode_srgb(linear), greatest as u8);
        }
    };
    for place in [Place::Lobe, Place::Beyond, Place::Unlit] {
        let points = points(kernel, place);
        if kernel.pixels() == 1 {
            for input in points {
                grade(kernel.run(&input, 0).results[0], position(&input));
            }
            continue;
        }
        for input in some(&points, TILES) {
            let words = kernel.run(&input, 0).results;
            for (index, code) in
                (words.iter().flat_map(|word| [word & 0xFFFF, word >> 16])).enumerate()
            {
                let point = in_tile(position(&input), index);
                // The tile's corners may be beside the sphere.
                if normal(point).is_some() {
                    grade(code, point);
                }
            }
        }
    }
    tally.errors()
}

/// Where a pixel of a tile about a point is.
fn in_tile([x, y]: [f64; 2], index: usize) -> [f64; 2] {
    let step = f64::from(STEP) / f64::from(1 << 30);
    let [column, row] = [index % WIDE, index / WIDE].map(|i| i as f64);
    [
        x + (column - WIDE as f64 / 2.0) * step,
        y - (row - HIGH as f64 / 2.0) * step,
    ]
}

fn place(kernel: &Kernel, normal: [f64; 3]) -> Place {
    let [l, v] = frame(kernel, normal);
    let square = (l[0] + v[0]).powi(2) + (l[1] + v[1]).powi(2) + (l[2] - v[2]).powi(2);
    if l[2] <= 0.0 {
        Place::Unlit
    } else if kernel.width * 0.5 * square <= 9.0 {
        Place::Lobe
    } else {
        Place::Beyond
    }
}

/// The exact normal of a point.
fn normal([x, y]: [f64; 2]) -> Option<[f64; 3]> {
    let square = 1.0 - x * x - y * y;
    (square > 0.0).then(|| [x, y, square.sqrt()])
}

/// A kernel's point in radii.
fn position(input: &Input) -> [f64; 2] {
    let point = input.vectors[0][0];
    [point, point >> 16].map(|bits| f64::from(bits as u16 as i16) / f64::from(1 << 14))
}

/// L and V of a kernel about a normal.
fn frame(kernel: &Kernel, normal: [f64; 3]) -> Pair {
    let light = match kernel.call {
        Call::Rows(_, light) => light,
        _ => LIGHT,
    };
    let light = light.map(|c| f64::from(c) / f64::from(1 << 14));
    in_frame(normal, light, [0.0, 0.0, 1.0])
}
