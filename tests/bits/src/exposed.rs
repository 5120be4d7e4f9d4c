//! Lobes and patches with a light's gain in their tables.

use fixed::types::{I2F14, U2F30, U32F32};
use microbrdf::Rgb;
use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{
    DirectPhong, ExposedMetal, ExposedPatch, ExposedPhong, MetallicPhong, Patch,
};
use microbrdf::geometry::{Direction, ShadingFrame, ShortWorld, World};
use microbrdf::table::{COSINE_KNOTS, CosineCurve};

use crate::raw::Checksum;
use crate::samples::Samples;

/// Gains, 32 fraction bits: from less than a step of light to more than a
/// lobe's table resolves.
const GAINS: [[u64; 3]; 12] = [
    [0, 0, 0],
    [1, 2, 3],
    [1 << 15, 1 << 15, 1 << 15],
    [1 << 16, 3 << 16, 5 << 16],
    [1 << 31, 0, 1 << 30],
    [1 << 32, 1 << 32, 1 << 32],
    [(1 << 32) + 1, 1 << 32, 1 << 31],
    [15_040_000_000, 15_040_000_000, 15_040_000_000],
    [8 << 32, 1 << 32, 1 << 26],
    [80 << 32, 33 << 32, 7 << 32],
    [256 << 32, 256 << 32, 128 << 32],
    [1_000 << 32, 4_000 << 32, 16_000 << 32],
];

type Sink<'a> = &'a mut dyn FnMut(&'static str, u64);

/// Hands the name and the checksum of each kind to `sink`: over `count` pairs
/// for each of 48 models, in the shading frame and in world space.
///
/// # Panics
/// If a constructor refuses a parameter that is within its range.
pub fn exposed_checksums(count: usize, sink: Sink<'_>) {
    let lobe = |n: u64| MetallicPhong::<Q15>::new(U32F32::from_bits(n)).expect("an exponent");
    let lobes = [1 << 32, 20 << 32, 500 << 32, 100_000 << 32].map(lobe);
    let phong = over(count, |gain, k| {
        let model = ExposedPhong::new(lobes[k % lobes.len()], gain).expect("a gain");
        move |frame, world| [model.shade(frame), model.shade(world)]
    });
    sink("lobes", phong);
    let direct = in_space(count, ShortWorld::new, |gain, k| {
        let model = DirectPhong::<256>::new(&lobes[k % lobes.len()], gain).expect("a gain");
        move |frame, world| [model.shade(frame), model.shade(world)]
    });
    sink("lobes without interpolation", direct);
    sink("metals, 65 knots", metals::<65>(count, &lobes));
    sink("metals, 129 knots", metals::<129>(count, &lobes));
    sink("metals, 257 knots", metals::<257>(count, &lobes));
    let radii = [1 << 24, 1 << 28, 1 << 30, 2 << 30];
    let patch = over(count, |gain, k| {
        let radius = U2F30::from_bits(radii[k % radii.len()]);
        let patch = Patch::<Q15>::new(radius).expect("a radius");
        let model = ExposedPatch::new(patch, gain).expect("a gain");
        move |frame, world| [model.shade(frame), model.shade(world)]
    });
    sink("patches", patch);
}

fn metals<const KNOTS: usize>(count: usize, lobes: &[MetallicPhong<Q15>]) -> u64 {
    over(count, |gain, k| {
        let lobe = lobes[k % lobes.len()];
        let model = ExposedMetal::<129, KNOTS>::new(lobe, &bent(), gain).expect("a gain");
        move |frame, world| [model.shade(frame), model.shade(world)]
    })
}

/// A curve that bends in each channel, up or down, most near grazing.
fn bent() -> CosineCurve {
    let mut entries = [[0; 3]; COSINE_KNOTS];
    for (index, entry) in entries.iter_mut().enumerate() {
        let cosine = u32::from(CosineCurve::knot(index));
        let fall = 16 * 30_000 / (16 + cosine);
        *entry = [2_000 + fall, 32_768 - fall, 20_000 + cosine * 10].map(|value| value as u16);
    }
    CosineCurve::from_entries(entries)
}

type Frame = ShadingFrame<Q15>;
type Vector = Direction<Q15>;

fn over<F: Fn(&Frame, &World<Q15>) -> [Rgb<u16>; 2]>(
    count: usize,
    model: impl Fn(Rgb<U32F32>, usize) -> F,
) -> u64 {
    in_space(count, World::new, model)
}

/// As [`over`], in another world space.
fn in_space<W, F: Fn(&Frame, &W) -> [Rgb<u16>; 2]>(
    count: usize,
    world: fn(Vector, Vector, Vector) -> W,
    model: impl Fn(Rgb<U32F32>, usize) -> F,
) -> u64 {
    let mut sum = Checksum::new();
    let mut samples = Samples::new(0x0E59);
    for (index, gain) in GAINS.iter().enumerate() {
        for other in 0..4 {
            let gain = Rgb::from_array(*gain).map(U32F32::from_bits);
            let shade = model(gain, index + other);
            for _ in 0..count {
                // From 30 fraction bits to 14.
                let [l, v] = samples.pair().map(|direction| {
                    let [x, y, z] = direction.map(|c| I2F14::from_bits((c >> 16) as i16));
                    Direction::<Q15>::new(x, y, z)
                });
                let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
                for light in shade(&ShadingFrame::new(l, v), &world(up, l, v)) {
                    for channel in light.to_array() {
                        sum.feed(u32::from(channel));
                    }
                }
            }
        }
    }
    sum.value()
}
