//! The pixels of a sphere, in a display's own levels.

use microbrdf_kernels::sphere::{LIGHT, TINT};
use microbrdf_kernels::{Input, Kernel};
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
            if normal(point).is_some_and(|normal| self::place(kernel, normal) == place) {
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

/// The errors of a kernel over every point, in levels of RGB565.
///
/// # Panics
/// If the kernel's exponent is none.
#[must_use]
pub fn measure(kernel: &Kernel) -> Errors {
    let model = MetallicPhong::new(kernel.width, Energy::Published).expect("a kernel's exponent");
    let mut tally = Tally::new("lobe");
    for place in [Place::Lobe, Place::Beyond, Place::Unlit] {
        for input in points(kernel, place) {
            let [l, v] = pair(&input);
            let direction = |[x, y, z]: [f64; 3]| Direction::new(x, y, z);
            let rho = model.rho(&direction(l), &direction(v))[0].clamp(0.0, 1.0);
            let code = kernel.run(&input, 0).results[0];
            let levels = [code >> 11, (code >> 5) & 63, code & 31];
            for ((level, tint), greatest) in levels.into_iter().zip(TINT).zip([31.0, 63.0, 31.0]) {
                let linear = rho * f64::from(tint) / f64::from(1 << 24);
                tally.add_level(level as u8, greatest * encode_srgb(linear), greatest as u8);
            }
        }
    }
    tally.errors()
}

fn place(kernel: &Kernel, normal: [f64; 3]) -> Place {
    let [l, v] = frame(normal);
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
fn normal([x, y]: [i32; 2]) -> Option<[f64; 3]> {
    let [x, y] = [x, y].map(|c| f64::from(c) / f64::from(1 << 14));
    let square = 1.0 - x * x - y * y;
    (square > 0.0).then(|| [x, y, square.sqrt()])
}

fn pair(input: &Input) -> Pair {
    let point = input.vectors[0][0];
    let half = |bits: u32| i32::from(bits as u16 as i16);
    frame(normal([half(point), half(point >> 16)]).expect("a point within the outline"))
}

/// L and V about a normal.
fn frame(normal: [f64; 3]) -> Pair {
    let light = LIGHT.map(|c| f64::from(c) / f64::from(1 << 14));
    in_frame(normal, light, [0.0, 0.0, 1.0])
}
