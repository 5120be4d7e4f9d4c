//! Directions of any bits: whatever is clamped, saturates or is refused.

use microbrdf::ParameterError;
use microbrdf::brdf::{
    Brdf, Flat, GeneralisedLambert, Metal, Metallic, MetallicPaint, Mirror, PatchMetal,
    PatchProfile, Retro,
};
use microbrdf::geometry::{Direction, ShadingFrame, World};
use microbrdf_bits::Checksum;

use crate::Sums;
use crate::given::{self, Given, Words};

/// Triples of directions for each model.
const COUNT: usize = 400;

/// The axes, and what is no direction: cosines are exactly 1, 0 and −1.
const CORNERS: [[i32; 3]; 6] = [
    [0, 0, 1 << 30],
    [1 << 30, 0, 0],
    [-(1 << 30), 0, 0],
    [0, 1 << 30, 0],
    [0, 0, -(1 << 30)],
    [0, 0, 0],
];

/// Adds a sum for each kind of model.
pub fn add<A: Given>(sums: &mut Sums) {
    let mut push = |name: &str, sum: u64| sums.push(&format!("any bits, {name}"), sum);
    push(
        "metallic phong",
        any(A::lobe::<Mirror, _>(20 << 16, Metallic)),
    );
    push("phong, n = 0", any(A::lobe::<Mirror, _>(0, Flat)));
    push("retro phong", any(A::lobe::<Retro, _>(1 << 16, Metallic)));
    push(
        "p-model",
        any(A::power_model(1 << 15).and_then(|p| A::lobe::<Mirror, _>(5 << 16, p))),
    );
    push("patch", any(A::patch(2 << 16)));
    push("exponential patch", any(A::patch_exponential(3 << 16)));
    push(
        "patch with a profile",
        any(A::patch(1 << 16)
            .and_then(|patch| Ok(PatchProfile::<A>::new(given::profile(2)?, patch.peak())))),
    );
    push("lambert", any(A::lambert([1 << 16, 1 << 15, 0])));
    push(
        "plastic",
        any(A::plastic([1 << 15, 1 << 14, 0], [1 << 15; 3], 1 << 16)),
    );
    push(
        "metal",
        any(A::lobe::<Mirror, _>(2 << 16, Metallic).map(|lobe| Metal::new(lobe, given::curve()))),
    );
    push(
        "plastic with Fresnel's factor",
        any(A::plastic([1 << 14, 1 << 15, 9], [1 << 15; 3], 4 << 16)
            .map(|plastic| plastic.with_fresnel(given::curve()))),
    );
    push(
        "metallic paint",
        any(A::patch_exponential(2 << 16)
            .map(|patch| MetallicPaint::<A>::new(patch, given::curve()))),
    );
    push(
        "metal of patches",
        any(A::patch(3 << 15).map(|patch| PatchMetal::new(patch, given::curve()))),
    );
    push(
        "generalised lambert",
        any(A::lambert([1 << 16, 1 << 13, 1 << 15]).and_then(|body| {
            let peak = A::patch(1 << 16)?.peak();
            Ok(GeneralisedLambert::new(body, given::square(19_661)?, peak))
        })),
    );
}

fn any<A: Given>(model: Result<impl Brdf<A>, ParameterError>) -> u64 {
    let model = model.expect("a parameter within its range");
    let gains = [
        0,
        1,
        1 << 16,
        98_765,
        4_123_457,
        0x1_FFFF_FFFF,
        1 << 40,
        u64::MAX >> 16,
    ]
    .map(A::gain);
    let mut words = Words::new(0xB175);
    let mut sum = Checksum::new();
    let corners = CORNERS.map(given::direction::<A>);
    let triples = (0..COUNT)
        .map(|round| {
            [(); 3].map(|()| {
                let [x, y, z] = [(); 3].map(|()| words.component::<A>(round));
                Direction::new(x, y, z)
            })
        })
        .chain(corners.iter().flat_map(|l| {
            let up = corners[0];
            corners.iter().map(move |v| [up, *l, *v])
        }));
    for [n, l, v] in triples {
        let (frame, world) = (ShadingFrame::new(l, v), World::new(n, l, v));
        for all in [
            (
                model.brdf(&frame),
                model.reflect(&frame),
                model.share(&frame),
            ),
            (
                model.brdf(&world),
                model.reflect(&world),
                model.share(&world),
            ),
        ] {
            sum.feed_rgb(all.0);
            sum.feed_rgb(all.1);
            sum.feed_rgb(all.2);
        }
        for gain in gains {
            let gain = microbrdf::Rgb::grey(gain);
            for light in [model.shade(&gain, &frame), model.shade(&gain, &world)] {
                let twice = light.zip(light, A::add_light);
                for component in A::linear(light).to_raw() {
                    sum.feed(component);
                }
                for component in A::linear(twice).to_raw() {
                    sum.feed(component);
                }
            }
        }
    }
    sum.value()
}
