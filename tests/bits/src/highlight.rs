//! Highlights on spheres.

use fixed::types::{I2F30, U32F32};
use microbrdf::Rgb;
use microbrdf::arithmetic::Q31;
use microbrdf::geometry::Direction;
use microbrdf::shade::{LitSphere, LobeColours};

use crate::raw::Checksum;
use crate::samples::Samples;

/// Exponents and gains, 32 fraction bits.
const LOBES: [(u64, [u64; 3]); 8] = [
    (1 << 32, [1 << 32, 1 << 31, 1 << 30]),
    (3 << 31, [1 << 24, 1 << 40, 0]),
    (20 << 32, [3 << 32, 1 << 32, 1 << 31]),
    (500 << 32, [80 << 32, 33 << 32, 7 << 32]),
    (4_000 << 32, [1 << 32, 1 << 31, 1 << 30]),
    (100_000_000 << 32, [1 << 32; 3]),
    // Hardly seen, and not at all.
    (20 << 32, [1 << 22, 3 << 20, 1 << 21]),
    (20 << 32, [0; 3]),
];

/// Hands the name and the checksum of each lobe to `sink`: over a picture of
/// the whole sphere and one of the highlight, for each of `count` lights.
///
/// # Panics
/// If a constructor refuses a parameter that is within its range.
pub fn highlight_checksums(count: usize, sink: &mut dyn FnMut(&'static str, u64)) {
    const NAMES: [&str; 8] = [
        "n = 1", "n = 1.5", "n = 20", "n = 500", "n = 4e3", "n = 1e8", "faint", "dark",
    ];
    for (name, (n, gain)) in NAMES.into_iter().zip(LOBES) {
        let gain = Rgb::from_array(gain).map(U32F32::from_bits);
        let colours =
            LobeColours::<256>::new(U32F32::from_bits(n), gain).expect("an exponent from 1 on");
        sink(name, pictures(count, &colours));
    }
    let gain = Rgb::from_array(LOBES[0].1).map(U32F32::from_bits);
    sink(
        "n = 0",
        pictures(count, &LobeColours::<256, true>::flat(gain)),
    );
}

fn pictures<const FLAT: bool>(count: usize, colours: &LobeColours<256, FLAT>) -> u64 {
    let mut sum = Checksum::new();
    let mut samples = Samples::new(0x0916);
    for _ in 0..count {
        let [h, l] = samples.pair();
        // One of them from behind, too, and one from nearly straight behind.
        let behind = [l[0], l[1], -l[2].abs()];
        let far = [l[0] / 16, l[1] / 16, -l[2].abs()];
        for l in [h, l, behind, far] {
            lit(&mut sum, colours, l, h);
        }
    }
    sum.value()
}

/// A picture about `middle`, and one of all of it.
fn lit<const FLAT: bool>(
    sum: &mut Checksum,
    colours: &LobeColours<256, FLAT>,
    l: [i32; 3],
    middle: [i32; 3],
) {
    const WIDE: usize = 24;
    let [x, y, z] = l.map(I2F30::from_bits);
    let sphere = LitSphere::<256>::new(colours, Direction::<Q31>::new(x, y, z));
    for (middle, step) in [([0; 3], 1 << 27), (middle, 1 << 20)] {
        let half = step * (WIDE / 2) as i32;
        let start = [middle[0] / 2 - half, middle[1] / 2 + half].map(I2F30::from_bits);
        let mut rows = sphere.rows(colours, start, [step, -step].map(I2F30::from_bits));
        for _ in 0..WIDE {
            let mut pixels = [0; WIDE];
            rows.shade(&mut pixels);
            for pixel in pixels {
                sum.feed(u32::from(pixel));
            }
        }
    }
}
