//! The core's results to the last bit: the same in every build, on every
//! core. A change of any of them is a change of what devices show, and is
//! made here on purpose.

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf_bits::{Sampled, checksums};

/// Pairs for each model. A microcontroller's probe takes as many.
const COUNT: usize = 2000;

fn computed<A: Sampled>() -> Vec<(&'static str, u64)> {
    let mut found = Vec::new();
    checksums::<A>(COUNT, &mut |name, sum| found.push((name, sum)));
    found
}

fn compare<A: Sampled>(golden: &[(&str, u64)]) {
    let found = computed::<A>();
    let lines: Vec<_> = found
        .iter()
        .map(|(name, sum)| format!("    (\"{name}\", {sum:#018x}),"))
        .collect();
    assert!(
        found == golden,
        "{} gives other bits. If that is meant, they are now\n{}",
        A::NAME,
        lines.join("\n")
    );
}

#[test]
fn f32_gives_the_same_bits_everywhere() {
    compare::<F32>(&F32_SUMS);
}

#[test]
fn q31_gives_the_same_bits_everywhere() {
    compare::<Q31>(&Q31_SUMS);
}

#[test]
fn micromath_gives_the_same_bits_everywhere() {
    compare::<Micromath>(&MICROMATH_SUMS);
}

#[test]
fn q15_gives_the_same_bits_everywhere() {
    compare::<Q15>(&Q15_SUMS);
}

/// What fits into the RAM of the smallest board.
#[test]
fn q31_with_small_tables_gives_the_same_bits_everywhere() {
    compare::<Q31<128>>(&Q31_128_SUMS);
}

const F32_SUMS: [(&str, u64); 19] = [
    ("lambert", 0x2c397570905977c0),
    ("metallic-phong, n = 0", 0xc1fc3dbb4a69d174),
    ("metallic-phong, n = 1", 0x87b3dcf5b2df1220),
    ("metallic-phong, n = 2.5", 0xad5c4ca9a0fbdedf),
    ("metallic-phong, n = 20", 0xb21aec0c86c8b7f3),
    ("metallic-phong, n = 5e3", 0x88fe77a88c15aec6),
    ("metallic-phong, n = 1e8", 0x022688093f4bea0c),
    ("phong, n = 20", 0x4ae6ceb93610ce15),
    ("phong, n = 20, p = 0.5", 0x3d77e94b5dbf424a),
    ("retro-phong, n = 20", 0x8f792e59e9f13390),
    ("patch, R = 0.3", 0x34e4a941a2a68e27),
    ("patch, R = 1.5", 0xd5661e3c84af87b3),
    ("patch, R = 2", 0xeb4902d1fc9ba9b3),
    ("patch-exponential, s = 0", 0xeb4902d1fc9ba9b3),
    ("patch-exponential, s = 0.05", 0x266b6192140ba435),
    ("patch-exponential, s = 4", 0x38358f5c99a34c5e),
    ("patch-exponential, s = 4096", 0xe0cd230435ea6af7),
    ("metal, n = 20", 0xbc1cc590aed2c7a9),
    ("plastic, n = 20", 0x216f26689ccd186b),
];
const Q31_SUMS: [(&str, u64); 19] = [
    ("lambert", 0x6968218aa20ca42d),
    ("metallic-phong, n = 0", 0x473cba88c35a906e),
    ("metallic-phong, n = 1", 0x0220dac58d6f5b76),
    ("metallic-phong, n = 2.5", 0x17852e715d89e80e),
    ("metallic-phong, n = 20", 0x6665e8f2c670c112),
    ("metallic-phong, n = 5e3", 0x80783c3d120a1f2d),
    ("metallic-phong, n = 1e8", 0x0bf33dbadc1dec42),
    ("phong, n = 20", 0xc662f99a410a2fca),
    ("phong, n = 20, p = 0.5", 0x9d6b4bec1d38e9f7),
    ("retro-phong, n = 20", 0x1593089241356d5d),
    ("patch, R = 0.3", 0xdaa912a166803fa7),
    ("patch, R = 1.5", 0x9dd6eb5048493ae5),
    ("patch, R = 2", 0x871268a9c5ebe6a8),
    ("patch-exponential, s = 0", 0x871268a9c5ebe6a8),
    ("patch-exponential, s = 0.05", 0x50ab6e5b91fed97c),
    ("patch-exponential, s = 4", 0xedec7d1275eb70bb),
    ("patch-exponential, s = 4096", 0xbe7f3e561615dd1d),
    ("metal, n = 20", 0xd526697f20e51b55),
    ("plastic, n = 20", 0xa6630bfb96441d90),
];
const Q31_128_SUMS: [(&str, u64); 19] = [
    ("lambert", 0x6968218aa20ca42d),
    ("metallic-phong, n = 0", 0x473cba88c35a906e),
    ("metallic-phong, n = 1", 0x0edae9862860227a),
    ("metallic-phong, n = 2.5", 0x81fbfd4429da6673),
    ("metallic-phong, n = 20", 0x98105e1ae748f99e),
    ("metallic-phong, n = 5e3", 0x0e8efddb81426d54),
    ("metallic-phong, n = 1e8", 0x8d2a290fd4e6b94a),
    ("phong, n = 20", 0xa80351c9a65eb148),
    ("phong, n = 20, p = 0.5", 0xb8571659f89e3303),
    ("retro-phong, n = 20", 0xbf3d947528f0176f),
    ("patch, R = 0.3", 0xdaa912a166803fa7),
    ("patch, R = 1.5", 0x9dd6eb5048493ae5),
    ("patch, R = 2", 0x871268a9c5ebe6a8),
    ("patch-exponential, s = 0", 0x871268a9c5ebe6a8),
    ("patch-exponential, s = 0.05", 0x6eafc5eea49fa501),
    ("patch-exponential, s = 4", 0xc6995fb4e4a31402),
    ("patch-exponential, s = 4096", 0x75ce89497b5f717a),
    ("metal, n = 20", 0x35122cfded29e6f2),
    ("plastic, n = 20", 0xe6da5a4dcce523e4),
];
const MICROMATH_SUMS: [(&str, u64); 19] = [
    ("lambert", 0x2c397570905977c0),
    ("metallic-phong, n = 0", 0xc1fc3dbb4a69d174),
    ("metallic-phong, n = 1", 0x6553637d59879459),
    ("metallic-phong, n = 2.5", 0x220105c77479d657),
    ("metallic-phong, n = 20", 0x35435dbc192332fb),
    ("metallic-phong, n = 5e3", 0x2be32ec87ddc045b),
    ("metallic-phong, n = 1e8", 0x3111b7b516bf3ae5),
    ("phong, n = 20", 0xa800b3c0a50fdf10),
    ("phong, n = 20, p = 0.5", 0x0969ee37a347d4b5),
    ("retro-phong, n = 20", 0xc53e32dc1f574033),
    ("patch, R = 0.3", 0x34e4a941a2a68e27),
    ("patch, R = 1.5", 0xd5661e3c84af87b3),
    ("patch, R = 2", 0xeb4902d1fc9ba9b3),
    ("patch-exponential, s = 0", 0xeb4902d1fc9ba9b3),
    ("patch-exponential, s = 0.05", 0x37a613cc6a3d6e1d),
    ("patch-exponential, s = 4", 0x02b373cf71973b05),
    ("patch-exponential, s = 4096", 0x07412a971a61b1c0),
    ("metal, n = 20", 0x1bee25884204135b),
    ("plastic, n = 20", 0x68c1b7b485d50f74),
];
const Q15_SUMS: [(&str, u64); 19] = [
    ("lambert", 0x95e0cf69a6e0b9be),
    ("metallic-phong, n = 0", 0x4eff2f33034f5671),
    ("metallic-phong, n = 1", 0xf7102d809b3c9054),
    ("metallic-phong, n = 2.5", 0x9be278f29d8e1628),
    ("metallic-phong, n = 20", 0xe2b04ac623b58dfd),
    ("metallic-phong, n = 5e3", 0x29cbbe29ae90878c),
    ("metallic-phong, n = 1e8", 0x851d34f4e9146c68),
    ("phong, n = 20", 0xf5ffd68a9056010f),
    ("phong, n = 20, p = 0.5", 0x18de6d5b79a0e9e8),
    ("retro-phong, n = 20", 0xc725685974eb1c34),
    ("patch, R = 0.3", 0x8c2618036f8b113c),
    ("patch, R = 1.5", 0xc0df867d0558a3fa),
    ("patch, R = 2", 0x803c49877c0c1ea8),
    ("patch-exponential, s = 0", 0x803c49877c0c1ea8),
    ("patch-exponential, s = 0.05", 0xae0dee50d2a164bb),
    ("patch-exponential, s = 4", 0xa75021e9796e608a),
    ("patch-exponential, s = 4096", 0xc26e629a5b040030),
    ("metal, n = 20", 0xcc24ef8b6cb34e26),
    ("plastic, n = 20", 0x4aea142ab5468517),
];
