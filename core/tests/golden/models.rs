//! Every model at many parameters: its table, its peak, its directions.

use microbrdf::brdf::{
    Brdf, Flat, GeneralisedLambert, Metal, Metallic, MetallicPaint, Mirror, PatchMetal,
    PatchProfile, Retro,
};
use microbrdf::{ParameterError, Rgb};
use microbrdf_bits::{Checksum, digest};

use crate::Sums;
use crate::given::{self, Given};

/// Pairs of directions for each model.
const COUNT: usize = 48;

/// Exponents, 16 fraction bits.
const EXPONENTS: [u64; 20] = [
    0,
    1 << 16,
    (1 << 16) + 1,
    98_304,
    2 << 16,
    3 << 16,
    5 << 16,
    478_413,
    10 << 16,
    33 << 16,
    100 << 16,
    333 << 16,
    1_000 << 16,
    10_000 << 16,
    1 << 32,
    100_000 << 16,
    1_000_000 << 16,
    (1 << 40) + 12_345,
    10_000_000 << 16,
    100_000_000 << 16,
];
/// Exponents just above 1, where a table's last cell has its own rule.
const LOW: [u64; 7] = [68_000, 72_090, 78_643, 85_197, 91_750, 94_000, 120_000];
/// Powers p of a cosine, 16 fraction bits.
const POWERS: [u16; 9] = [
    1, 100, 6_554, 16_384, 32_768, 40_000, 49_152, 58_982, 65_535,
];
/// Radii, 16 fraction bits.
const RADII: [u32; 9] = [7, 66, 655, 6_554, 32_768, 65_536, 92_682, 131_000, 131_072];
/// Sharpnesses, 16 fraction bits.
const SHARPNESSES: [u64; 18] = [
    0,
    1,
    655,
    6_554,
    19_661,
    32_767,
    32_768,
    50_000,
    1 << 16,
    2 << 16,
    4 << 16,
    655_360,
    50 << 16,
    100 << 16,
    500 << 16,
    1_000 << 16,
    2_000 << 16,
    4_096 << 16,
];

/// Adds a sum for each kind of model.
pub fn add<A: Given>(sums: &mut Sums) {
    sums.push(
        "metallic phong",
        over::<A, _, _>(&EXPONENTS, |n| A::lobe::<Mirror, _>(*n, Metallic)),
    );
    sums.push(
        "metallic phong of low exponents",
        over::<A, _, _>(&LOW, |n| A::lobe::<Mirror, _>(*n, Metallic)),
    );
    sums.push(
        "phong",
        over::<A, _, _>(&EXPONENTS, |n| A::lobe::<Mirror, _>(*n, Flat)),
    );
    sums.push(
        "retro phong",
        over::<A, _, _>(&EXPONENTS, |n| A::lobe::<Retro, _>(*n, Metallic)),
    );
    sums.push(
        "p-model",
        over::<A, _, _>(&POWERS, |p| {
            A::lobe::<Mirror, _>(3 << 16, A::power_model(*p)?)
        }),
    );
    sums.push("patch", over::<A, _, _>(&RADII, |radius| A::patch(*radius)));
    sums.push(
        "exponential patch",
        over::<A, _, _>(&SHARPNESSES, |s| A::patch_exponential(*s)),
    );
    sums.push(
        "patch with a profile",
        over::<A, _, _>(&[0, 1, 5, 11], |halvings| {
            let peak = A::patch(1 << 16)?.peak();
            Ok(PatchProfile::new(given::profile(*halvings)?, peak))
        }),
    );
    let colours = [
        [0, 0, 0],
        [1 << 16, 1 << 16, 1 << 16],
        [65_535, 1, 32_769],
        [20_000, 40_000, 60_000],
    ];
    sums.push(
        "lambert",
        over::<A, _, _>(&colours, |albedo| A::lambert(*albedo)),
    );
    let plastic = |albedo: &[u32; 3]| {
        let rest = (1 << 16) - albedo.iter().max().expect("three channels");
        A::plastic(*albedo, [rest, rest / 3, 0], 7 << 16)
    };
    sums.push("plastic", over::<A, _, _>(&colours, plastic));
    sums.push(
        "plastic with Fresnel's factor",
        over::<A, _, _>(&colours, |albedo| {
            Ok(plastic(albedo)?.with_fresnel(given::curve()))
        }),
    );
    sums.push(
        "generalised lambert",
        over::<A, _, _>(&[1 << 14, 17_243, 1 << 15, 40_000, 0xFFFF], |inverse| {
            let (body, peak) = (A::lambert(colours[3])?, A::patch(1 << 16)?.peak());
            Ok(GeneralisedLambert::new(
                body,
                given::square(*inverse)?,
                peak,
            ))
        }),
    );
    sums.push(
        "metal",
        over::<A, _, _>(&EXPONENTS, |n| {
            Ok(Metal::new(
                A::lobe::<Mirror, _>(*n, Metallic)?,
                given::curve(),
            ))
        }),
    );
    sums.push(
        "metallic paint",
        over::<A, _, _>(&SHARPNESSES, |s| {
            Ok(MetallicPaint::<A>::new(
                A::patch_exponential(*s)?,
                given::curve(),
            ))
        }),
    );
    sums.push(
        "metal of exponential patches",
        over::<A, _, _>(&SHARPNESSES, |s| {
            Ok(PatchMetal::new(A::patch_exponential(*s)?, given::curve()))
        }),
    );
    sums.push(
        "metal of patches",
        over::<A, _, _>(&RADII, |radius| {
            Ok(PatchMetal::new(A::patch(*radius)?, given::curve()))
        }),
    );
}

fn over<A: Given, P, M: Brdf<A>>(
    parameters: &[P],
    model: impl Fn(&P) -> Result<M, ParameterError>,
) -> u64 {
    let mut sum = Checksum::new();
    for parameter in parameters {
        let model = model(parameter).expect("a parameter within its range");
        // Both halves: what a checksum takes in are words.
        let digest = digest::<A>(&model, COUNT);
        sum.feed(digest as u32);
        sum.feed((digest >> 32) as u32);
        sum.feed_rgb(Rgb::grey(model.peak()));
    }
    sum.value()
}
