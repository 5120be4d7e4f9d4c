//! Greatest errors of the stored curves, as their documentation states them:
//! each bound holds, and is nearly met. They are read through the models, at
//! directions that leave nothing else of the share.

use microbrdf::arithmetic::{F32, Q31};
use microbrdf::brdf::{Brdf, MetallicPhong};
use microbrdf::constant;
use microbrdf::fixed::types::{I2F30, U32F32};
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_reference as reference;
use microbrdf_scene::{AnyModel, HostArithmetic, Material};
use microbrdf_tests::curves::CURVES;
use microbrdf_tests::given::model;

/// A direction in 30 fraction bits.
fn direction<const CELLS: usize>(bits: [i32; 3]) -> Direction<Q31<CELLS>> {
    let [x, y, z] = bits.map(I2F30::from_bits);
    Direction::new(x, y, z)
}

const ONE: i32 = 1 << 30;
/// 2⁻³⁰, what every bound leaves to the steps of an entry.
const STEP: f64 = 1.0 / (1 << 30) as f64;

/// L along N and V at m from it: the share is the lobe of
/// x = (m² + (1 − cosΘ)²)/2, or the profile of m. Gives both arguments and
/// the share.
fn read<const CELLS: usize>(model: &AnyModel<Q31<CELLS>>, m: i32, z: i32) -> (f64, f64, f64) {
    let geometry = ShadingFrame::new(direction([0, 0, ONE]), direction([m, 0, z]));
    let share: f64 = model.share(&geometry).r.to_num();
    let (m, height) = (f64::from(m), f64::from(ONE - z));
    (
        (m * m + height * height) * 0.5 * STEP * STEP,
        m * STEP,
        share,
    )
}

/// The greatest error of (1 − x)ⁿ: absolute, and what passes a step relative
/// to the value.
fn lobe_error<const CELLS: usize>(n: f64) -> [f64; 2] {
    let n = Q31::<CELLS>::exponent_value(n);
    let model = model::<Q31<CELLS>>(&format!("model = \"metallic-phong\", exponent = {n}"));
    let mut worst = [0.0f64; 2];
    for i in 0..8000 {
        // Where the lobe bends most: in the first cell, and for a broad lobe
        // before x = 1.
        let near = (f64::from(i) / 8000.0).powi(2);
        let x = if i % 2 == 0 || n >= 5.0 {
            22.5 * near / n
        } else {
            1.0 - near
        };
        if !(0.0..1.0).contains(&x) {
            continue;
        }
        let (s, c) = (2.0 * (0.5 * x).sqrt().asin()).sin_cos();
        let (x, _, share) = read(&model, (s / STEP) as i32, (c / STEP) as i32);
        if x < 1.0 {
            let exact = (n * (-x).ln_1p()).exp();
            let error = (share - exact).abs();
            worst[0] = worst[0].max(error);
            worst[1] = worst[1].max((error - STEP) / exact);
        }
    }
    worst
}

/// Exponents from `low` to `high`, evenly in the logarithm.
fn exponents(low: f64, high: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| (low * (high / low).powf(f64::from(i) / f64::from(count))).min(high))
}

/// `UniformTable`: 1.9e-4 of the value + 2⁻³⁰.
#[test]
fn lobes_from_five_on_keep_a_relative_error() {
    let mut greatest = 0.0f64;
    for n in exponents(5.0, 1e8, 400) {
        let [_, relative] = lobe_error::<1024>(n);
        assert!(relative <= 1.9e-4, "n = {n}: {relative:e}");
        greatest = greatest.max(relative);
    }
    assert!(greatest >= 1.75e-4, "{greatest:e}");
}

/// `UniformTable`: 1.6e-5, before x = 1, where the lobe's curvature or its
/// relative slope is infinite.
#[test]
fn lobes_below_five_keep_an_absolute_error() {
    let mut greatest = 0.0f64;
    for n in exponents(1.0, 1.5, 200).chain(exponents(1.5, 5.0, 40)) {
        let [absolute, _] = lobe_error::<1024>(n);
        assert!(absolute <= 1.6e-5, "n = {n}: {absolute:e}");
        greatest = greatest.max(absolute);
    }
    assert!(greatest >= 1.5e-5, "{greatest:e}");
}

/// n = 0 and n = 1 are chords themselves: what is left is the position in a
/// cell, 16 bits of 2⁻¹⁰.
#[test]
fn straight_lobes_are_exact() {
    for (n, bound) in [(0.0, 0.0), (1.0, 0.5f64.powi(26))] {
        let [absolute, _] = lobe_error::<1024>(n);
        assert!(absolute <= bound, "n = {n}: {absolute:e}");
    }
}

/// Four times the cells, a sixteenth of the error.
#[test]
fn the_error_falls_with_the_square_of_the_cells() {
    for n in [20.0, 500.0, 1e5] {
        let [few, some, many] = [
            lobe_error::<64>(n)[0],
            lobe_error::<256>(n)[0],
            lobe_error::<1024>(n)[0],
        ];
        for (coarse, fine) in [(few, some), (some, many)] {
            let factor = coarse / fine;
            assert!((11.0..=18.0).contains(&factor), "n = {n}: {factor}");
        }
    }
}

/// `UniformTable`: the same for e^(−s·m), m from 0 to 2.
#[test]
fn profiles_keep_a_relative_error() {
    let mut greatest = 0.0f64;
    for s in exponents(0.01, 4096.0, 250).chain([0.0]) {
        let s = Q31::<1024>::exponent_value(s);
        let model = model::<Q31>(&format!("model = \"patch-exponential\", sharpness = {s}"));
        let reach = (22.5 / s).min(2.0 - STEP);
        for i in 0..8000 {
            let m = reach * (f64::from(i) / 8000.0).powi(2);
            // A share of the cosine 1: V's own does not count.
            let (_, m, share) = read(&model, (m / STEP) as i32, ONE / 2);
            let exact = (-s * m).exp();
            let relative = ((share - exact).abs() - STEP) / exact;
            assert!(relative <= 1.9e-4, "s = {s}, m = {m}: {relative:e}");
            greatest = greatest.max(relative);
        }
    }
    assert!(greatest >= 1.75e-4, "{greatest:e}");
}

/// `CosinePowerTable`: 8e-6 of the value + 2⁻³⁰, at every octave of cosines.
#[test]
fn powers_of_a_cosine_keep_a_relative_error() {
    let mut greatest = 0.0f64;
    for p in [1e-3, 0.01, 0.1, 0.3, 0.45, 0.5, 0.55, 0.7, 0.9, 0.99, 0.999] {
        let model = model::<Q31>(&format!("model = \"phong\", exponent = 20, p = {p}"));
        for octave in 0..30 {
            let width = 1i64 << octave;
            let mut before = 0.0;
            for i in 0..1000 {
                let cosine = (width + width * i / 1000) as i32;
                // The mirror direction: lobe and ratio are 1.
                let vector = direction([0, 0, cosine]);
                let share: f64 = model.share(&ShadingFrame::new(vector, vector)).r.to_num();
                let exact = (f64::from(cosine) * STEP).powf(1.0 - p);
                let relative = ((share - exact).abs() - STEP) / exact;
                assert!(relative <= 8e-6, "p = {p}, {cosine}: {relative:e}");
                assert!(share >= before, "p = {p}, {cosine}: falls from {before}");
                before = share;
                greatest = greatest.max(relative);
            }
        }
        let vector = direction([0, 0, ONE]);
        let share = model.share(&ShadingFrame::new(vector, vector)).r;
        assert_eq!(share, microbrdf::fixed::types::U1F31::ONE);
    }
    assert!(greatest >= 7.4e-6, "{greatest:e}");
}

/// `CosineCurve`: every cosine of 16 bits, both arithmetics.
#[test]
fn fresnel_curves_keep_the_documented_error() {
    for curve in CURVES {
        let toml = format!("model = \"metal\", exponent = 20, {}", curve.fields);
        let (fixed, single) = (model::<Q31>(&toml), model::<F32>(&toml));
        let exact = Material::from_argument(&toml).expect("a metal").reference();
        let mut greatest = 0.0f64;
        for step in 1..=65_536i32 {
            // The mirror direction: what is left of the share is Fresnel's.
            let vector = direction([0, 0, step << 14]);
            let fixed = fixed.share(&ShadingFrame::new(vector, vector)).to_array();
            let cosine = f64::from(step) / 65_536.0;
            let vector = Direction::new(0.0, 0.0, cosine as f32);
            let single = single.share(&ShadingFrame::new(vector, vector)).to_array();
            let vector = reference::Direction::new(0.0, 0.0, cosine);
            let exact = exact.rho(&vector, &vector);
            for channel in 0..3 {
                for found in [fixed[channel].to_num(), f64::from(single[channel])] {
                    let error = (found - exact[channel]).abs();
                    assert!(
                        error <= curve.error,
                        "{} at {cosine}: {found} for {}",
                        curve.name,
                        exact[channel]
                    );
                    greatest = greatest.max(error);
                }
            }
        }
        assert!(
            greatest >= 0.95 * curve.error,
            "{}: {greatest:e} was found",
            curve.name
        );
    }
}

/// The ends of a curve are exact to half a step of an entry, and the cosine
/// just below 1/4, where the cells change their width, meets the one above.
#[test]
fn fresnel_curves_have_no_seam() {
    let toml = "model = \"metal\", exponent = 20, metal = \"gold\"";
    let (model, exact) = (
        model::<Q31>(toml),
        Material::from_argument(toml).expect("gold").reference(),
    );
    let share = |cosine: i32| {
        let vector = direction([0, 0, cosine]);
        model
            .share(&ShadingFrame::new(vector, vector))
            .to_array()
            .map(|share| -> f64 { share.to_num() })
    };
    let up = reference::Direction::new(0.0, 0.0, 1.0);
    for (found, exact) in share(ONE).into_iter().zip(exact.rho(&up, &up)) {
        assert!((found - exact).abs() <= 1.6e-5, "{found} for {exact}");
    }
    for (below, above) in share((ONE >> 2) - 1).into_iter().zip(share(ONE >> 2)) {
        assert!((below - above).abs() < 1e-7, "{below} and {above}");
    }
    // All but at the horizon a metal is white.
    for found in share(1) {
        assert!((found - 1.0).abs() <= 1.6e-5, "{found}");
    }
}

/// Built by the compiler or at start-up, a table holds the same entries.
#[test]
fn tables_in_flash_equal_those_built_at_run_time() {
    static FLASH: MetallicPhong<Q31<128>> =
        constant!(MetallicPhong::<Q31<128>>::new(U32F32::lit("37.5")));
    let n = std::hint::black_box(U32F32::from_num(37.5));
    let built = MetallicPhong::<Q31<128>>::new(n).expect("an exponent");
    assert_eq!(FLASH, built);
    assert_ne!(
        FLASH,
        MetallicPhong::<Q31<128>>::new(n + U32F32::ONE).expect("an exponent")
    );
}

/// ξ/ξmax of generalised Lambert, the clip on a knot.
#[test]
fn generalised_lamberts_profile_is_within_its_bound() {
    use microbrdf_reference::models::GeneralisedLambert;
    use microbrdf_scene::SquareProfile;

    for (clip, bound) in [(1.0, 2e-5), (1.5, 2e-5), (1.9, 4e-4)] {
        let mut worst = 0.0f64;
        for d in [0.25, 0.5, 0.75, 1.0] {
            let model = GeneralisedLambert::new(d, clip).expect("in range");
            let share = |square: f64| model.profile(square) / model.greatest_profile();
            let table = SquareProfile::new(share, clip);
            for i in 0..=100_000u32 {
                let square = f64::from(i) * 4.0 / 1e5;
                worst = worst.max((table.at(square) - share(square)).abs());
            }
        }
        println!("clip {clip}: {worst:e}");
        assert!((0.6 * bound..=bound).contains(&worst), "{clip}: {worst:e}");
    }
}
