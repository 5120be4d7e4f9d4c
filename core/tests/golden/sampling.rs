//! Every sampler: directions, weights, densities.

use microbrdf::Rgb;
use microbrdf::arithmetic::{F32, Q31};
use microbrdf::brdf::PowerModel;
use microbrdf::fixed::types::{U0F32, U2F30};
use microbrdf::sampling::{
    MetalSampler, MetallicPhongSampler, PModelSampler, PatchExponentialSampler, PatchSampler,
    PhongSampler, RetroPhongSampler, Sample,
};
use microbrdf_bits::{Checksum, Samples};

use crate::Sums;
use crate::given::{self, Drawing, Words, direction, parameter};

/// Draws for each sampler.
const COUNT: usize = 600;
/// Exponents, 16 fraction bits.
const EXPONENTS: [u64; 9] = [
    0,
    1 << 16,
    98_304,
    7 << 16,
    50 << 16,
    1_000 << 16,
    100_000 << 16,
    (1 << 40) + 12_345,
    100_000_000 << 16,
];
/// Radii, 16 fraction bits.
const RADII: [u32; 7] = [7, 655, 6_554, 32_768, 65_536, 98_304, 131_072];
/// Sharpnesses, 16 fraction bits.
const SHARPNESSES: [u64; 12] = [
    0,
    1,
    6_554,
    32_767,
    32_768,
    50_000,
    1 << 16,
    4 << 16,
    10 << 16,
    100 << 16,
    1_000 << 16,
    4_096 << 16,
];

/// An arithmetic's samplers, added up one by one.
pub trait Samplers: Drawing {
    /// Adds a sum for each.
    fn add(sums: &mut Sums);
}

/// Adds a sum for each sampler.
pub fn add<A: Samplers>(sums: &mut Sums) {
    A::add(sums);
}

macro_rules! samplers {
    ($arithmetic:ty, $parameter:expr, $radius:expr, $p:expr, $peak:expr) => {
        impl Samplers for $arithmetic {
            fn add(sums: &mut Sums) {
                let mut push = |name: &str, n: u64, sum: u64| {
                    sums.push(
                        &format!("sampling, {name}, {:.4}", n as f64 / 65_536.0),
                        sum,
                    );
                };
                for n in EXPONENTS {
                    let lobe = MetallicPhongSampler::<$arithmetic>::new($parameter(n)).expect("n");
                    push("metallic phong", n, drawn(&lobe));
                    push("another peak", n, drawn(&lobe.with_peak($peak)));
                    let metal = MetalSampler::new(lobe, given::curve());
                    push("metal", n, drawn(&metal));
                    let lobe = PhongSampler::<$arithmetic>::new($parameter(n)).expect("n");
                    push("phong", n, drawn(&lobe));
                    let lobe = RetroPhongSampler::<$arithmetic>::new($parameter(n)).expect("n");
                    push("retro phong", n, drawn(&lobe));
                    let p = PowerModel::<$arithmetic>::new($p).expect("p");
                    let lobe = PModelSampler::<$arithmetic>::with_foreshortening($parameter(n), p)
                        .expect("n");
                    push("p-model", n, drawn(&lobe));
                    let (model, other) = (
                        *lobe.model(),
                        PModelSampler::<$arithmetic>::with_foreshortening($parameter(n), p),
                    );
                    assert_eq!(Some(&model), other.as_ref().ok().map(|same| same.model()));
                }
                for radius in RADII {
                    let patch = PatchSampler::<$arithmetic>::new($radius(radius)).expect("R");
                    push("patch", radius.into(), drawn(&patch));
                }
                for s in SHARPNESSES {
                    let patch =
                        PatchExponentialSampler::<$arithmetic>::new($parameter(s)).expect("s");
                    push("exponential patch", s, drawn(&patch));
                }
                let albedo = [1 << 16, 30_000, 1];
                let lambert = <$arithmetic as microbrdf_bits::Sampled>::lambert(albedo);
                push("lambert", 0, drawn(&lambert.expect("albedo")));
            }
        }
    };
}

samplers!(
    F32,
    |bits: u64| bits as f32 / 65_536.0,
    |bits: u32| bits as f32 / 65_536.0,
    0.4,
    0.7
);
samplers!(
    Q31,
    parameter,
    |bits: u32| U2F30::from_bits(bits << 14),
    U0F32::lit("0.4"),
    microbrdf::fixed::types::U32F32::lit("0.7")
);

fn drawn<A: Drawing>(sampler: &impl Sample<A>) -> u64 {
    let mut words = Words::new(0x5A3);
    let mut pairs = Samples::new(0x5A3);
    let mut sum = Checksum::new();
    for _ in 0..COUNT {
        let [l, v] = pairs.pair().map(direction::<A>);
        let mut uniform = || {
            let word = words.word();
            A::uniform(match words.word() % 8 {
                0 => 0,
                1 => u32::MAX,
                2 => word >> (word & 31),
                3 => u32::MAX - (word >> (word & 31)),
                _ => word,
            })
        };
        match sampler.sample(&v, [uniform(), uniform()]) {
            Some(drawn) => {
                let l = drawn.direction;
                for component in [l.x, l.y, l.z] {
                    sum.feed(A::bits(component));
                }
                sum.feed_rgb(drawn.weight);
                sum.feed_rgb(Rgb::grey(sampler.pdf(&l, &v)));
            }
            None => sum.feed(u32::MAX),
        }
        sum.feed_rgb(Rgb::grey(sampler.pdf(&l, &v)));
    }
    sum.value()
}
