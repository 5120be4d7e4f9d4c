//! `q15`'s error as a function of the larger cosine, from both calls.

use std::fmt::Write as _;

use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic, Q15};
use microbrdf::brdf::Brdf as _;
use microbrdf::geometry::{Direction, Geometry, ShortWorld, World};
use microbrdf_reference as reference;
use microbrdf_scene::HostArithmetic;

use crate::arithmetic::rounded;
use crate::domain::Set;
use crate::error::Subject;
use crate::frame::{Rotations, in_frame};
use crate::registry;

type A = Q15;

/// The larger cosine is at least this, and below the one before.
const LEAST: [f64; 4] = [1.0 / 64.0, 1.0 / 512.0, 1.0 / 4096.0, 1.0 / 16_384.0];
/// Pairs in each set, for each entry of the registry.
const SAMPLES: usize = 1000;
/// The greatest peak that is shown at K = c: that of n = 1e5.
const SHARPEST: f64 = 2e4;
/// The greatest peak that is shown in world space: that of n = 600.
const BROAD: f64 = 100.0;
/// Beyond it peaks are shown by themselves, up to each of these: of n = 600 to 1800,
/// 6000, 1e5.
const NARROW: [f64; 3] = [300.0, 1000.0, SHARPEST];

/// The greatest error in LSB, and in whole codes.
pub type Greatest = (f64, u8);

/// What is found, by the larger cosine.
#[derive(Debug, Default)]
pub struct Found {
    /// In the shading frame, in world space and by sums of products there, at K = 1
    /// and at K = c.
    pub by_cosine: [[Greatest; 6]; LEAST.len()],
    /// For peaks from 100 on, where the larger cosine is in the first range: both
    /// world spaces, at K = 1 and at K = c.
    pub by_peak: [[Greatest; 4]; NARROW.len()],
}

/// All of it, computed.
pub fn found() -> Found {
    let mut found = Found::default();
    let mut rotations = Rotations::new(0x6A2E);
    for entry in registry::all() {
        let subject = Subject::<A>::new(&entry.material());
        let peak = subject.exact.peak();
        // n = 0 ends at α = 90° as a patch does.
        let has_edge = entry.toml.contains("radius = ") || entry.toml.ends_with("exponent = 0");
        for (column, k) in [1.0, peak].into_iter().enumerate() {
            if column == 1 && !(1e-3..SHARPEST).contains(&peak) {
                continue;
            }
            for set in [Set::Lobe, Set::Mirror, Set::Grazing, Set::Random] {
                for pair in entry.pairs(set, 9.0 + k.max(1.0).ln(), SAMPLES) {
                    let frame = Subject::<A>::geometry(pair);
                    let exact = [value(&frame.l), value(&frame.v)];
                    let bin = bin(exact);
                    if let Some(bin) = bin {
                        let cell = &mut found.by_cosine[bin][column];
                        add(cell, &subject, k, &frame, exact);
                    }
                    let [n, l, v] = rotations.turn(pair).map(rounded::<A>);
                    let exact = in_frame(value(&n), value(&l), value(&v));
                    // A cosine that is rounded over the horizon is another question.
                    let above = exact[0][2] > 0.0 && exact[1][2] > 0.0;
                    let Some(bin) = self::bin(exact).filter(|_| above && !has_edge) else {
                        continue;
                    };
                    let cells = if peak < BROAD {
                        &mut found.by_cosine[bin][2..]
                    } else if let (0, Some(peaks)) = (bin, NARROW.iter().position(|p| peak <= *p)) {
                        &mut found.by_peak[peaks][..]
                    } else {
                        continue;
                    };
                    let world = World::new(n, l, v);
                    add(&mut cells[column], &subject, k, &world, exact);
                    let world = ShortWorld::new(n, l, v);
                    add(&mut cells[column + 2], &subject, k, &world, exact);
                }
            }
        }
    }
    found
}

/// The range of the larger cosine.
fn bin(exact: [[f64; 3]; 2]) -> Option<usize> {
    let larger = exact[0][2].max(exact[1][2]);
    LEAST.iter().position(|least| larger >= *least)
}

fn value(direction: &Direction<A>) -> [f64; 3] {
    [direction.x, direction.y, direction.z].map(A::component_value)
}

fn add(
    (lsb, codes): &mut Greatest,
    subject: &Subject<A>,
    k: f64,
    geometry: &impl Geometry<A>,
    exact: [[f64; 3]; 2],
) {
    let shown = A::linear(subject.model.shade(&Rgb::grey(A::gain(k)), geometry)).srgb8();
    let [l, v] = exact.map(|[x, y, z]| reference::Direction::new(x, y, z));
    let rho = subject.exact.rho(&l, &v);
    for (code, rho) in shown.into_iter().zip(rho) {
        let exact = 255.0 * reference::encode_srgb((k * rho).clamp(0.0, 1.0));
        *lsb = lsb.max((f64::from(code) - exact).abs());
        *codes = (*codes).max(code.abs_diff(exact.round() as u8));
    }
}

/// The section of `docs/accuracy.md`.
pub fn section() -> String {
    let mut text = String::from(
        "\n## `q15` and the larger cosine\n\n\
         Greatest arithmetic error in LSB, in brackets in whole codes, where the larger of the two \
         cosines lies in a range: over every entry of the registry at K = 1, and over those of a peak \
         below 2e4 (n to 1e5) at K = c. A cosine and a quotient of two keep the digits that they have, so that \
         the error does not grow towards grazing. In world space entries of a peak below 100 (n to 600) and \
         without an edge are shown: the edge of a patch or of n = 0 lies where rounding puts it. `World` \
         takes L + V's part along N away to 18 bits, `ShortWorld` by sums of products that are exact. \
         Computed anew by `tests/tests/documents.rs`, which fails when a figure is out of date.\n\n\
         | larger cosine from | shading frame, K = 1 | K = c | `World`, K = 1 | K = c | `ShortWorld`, K = 1 | K = c |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    let found = found();
    for (least, columns) in LEAST.into_iter().zip(found.by_cosine) {
        row(&mut text, &format!("2^{:.0}", least.log2()), &columns);
    }
    text.push_str(
        "\nThe same of narrower lobes in world space, where the larger cosine is at least 2^-6.\n\n\
         | peak to | `World`, K = 1 | K = c | `ShortWorld`, K = 1 | K = c |\n\
         | --- | ---: | ---: | ---: | ---: |\n",
    );
    for (peak, columns) in NARROW.into_iter().zip(found.by_peak) {
        row(&mut text, &peak.to_string(), &columns);
    }
    text
}

fn row(text: &mut String, title: &str, columns: &[Greatest]) {
    let _ = write!(text, "| {title} |");
    for (lsb, codes) in columns {
        let _ = write!(text, " {lsb:.2} ({codes}) |");
    }
    text.push('\n');
}
