//! Steps that round to nearest are within half a step of the exact value.

use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic, F32, Q31};
use microbrdf::brdf::{Brdf, Lambert, PatchExponential};
use microbrdf::fixed::types::{I2F30, U1F31, U32F32};
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_bits::Samples;

/// Half of 2⁻³¹, and what f64 itself adds to it.
const HALF: f64 = 0.5 / (1u64 << 31) as f64 + 1e-15;

fn direction([x, y, z]: [i32; 3]) -> Direction<Q31> {
    let [x, y, z] = [x, y, z].map(I2F30::from_bits);
    Direction::new(x, y, z)
}

/// albedo · cosΘL.
#[test]
fn products_of_shares() {
    let albedo = U1F31::lit("0.7310585786");
    let lambert = Lambert::<Q31>::new(Rgb::grey(albedo)).expect("an albedo");
    let mut samples = Samples::new(1);
    let mut greatest = 0.0f64;
    for _ in 0..20_000 {
        let [l, _] = samples.pair();
        if l[2] >= 0 {
            let share: f64 = lambert
                .share(&ShadingFrame::new(direction(l), direction(l)))
                .r
                .to_num();
            let exact = albedo.to_num::<f64>() * f64::from(l[2]) / f64::from(1 << 30);
            greatest = greatest.max((share - exact).abs());
        }
    }
    assert!(greatest <= HALF, "{greatest:e}");
    assert!(greatest > 0.99 * HALF, "{greatest:e}");
}

#[test]
fn dot_products() {
    let mut samples = Samples::new(2);
    let mut greatest = 0.0f64;
    for _ in 0..20_000 {
        let [a, b] = samples.pair();
        let found = Q31::<1024>::dot(&direction(a), &direction(b));
        let exact: i64 = (0..3).map(|i| i64::from(a[i]) * i64::from(b[i])).sum();
        // 60 fraction bits, exactly.
        let error = (i64::from(found.to_bits()) << 30) - exact;
        greatest = greatest.max(error.abs() as f64);
    }
    let half = f64::from(1 << 29);
    assert!(greatest <= half && greatest > 0.99 * half, "{greatest}");
}

/// e^(−s·m) for so small an s that the chords' sag is far below a step, at
/// the knots.
#[test]
fn entries_of_a_table() {
    let s = 1.0 / 8192.0;
    let mixture = PatchExponential::<Q31>::new(U32F32::from_num(s)).expect("a sharpness");
    let mut greatest = 0.0f64;
    for knot in 0..256 {
        let m = knot << 22;
        let geometry = ShadingFrame::new(direction([0, 0, 1 << 30]), direction([m, 0, 1 << 29]));
        let share: f64 = mixture.share(&geometry).r.to_num();
        let exact = (-s * f64::from(m) / f64::from(1 << 30)).exp();
        greatest = greatest.max((share - exact).abs());
    }
    assert!(greatest <= HALF && greatest > 0.9 * HALF, "{greatest:e}");
}

/// K·ρ to 24 bits, where f32 holds more than those.
#[test]
fn linear_light() {
    let mut greatest = 0.0f64;
    for i in 1..20_000 {
        let light = 0.1 * (i as f32) / 20_000.0;
        let found = f64::from(F32::linear(Rgb::grey(light)).to_raw()[1]);
        greatest = greatest.max((found - f64::from(light) * f64::from(1 << 24)).abs());
    }
    assert!((0.49..=0.5).contains(&greatest), "{greatest}");
}
