//! Lobes and patches with a light's gain in their tables: light of 16 bits,
//! against the reference and at its extremes.

use microbrdf::Rgb;
use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{
    Brdf as _, DirectPhong, ExposedMetal, ExposedPatch, ExposedPhong, Metal, MetallicPhong, Patch,
};
use microbrdf::fixed::types::{I2F14, U2F30, U32F32};
use microbrdf::geometry::{Direction, ShadingFrame, ShortWorld, World};
use microbrdf::shade::{Palette565, srgb8, srgb8_direct};
use microbrdf_reference::encode_srgb;
use microbrdf_scene::{HostArithmetic, Material};
use microbrdf_tests::domain::{Pair, Set};
use microbrdf_tests::error::Subject;
use microbrdf_tests::exposed::{COUNT, middle, number, within, worst};

fn lobe(n: f64) -> MetallicPhong<Q15> {
    MetallicPhong::<Q15>::new(number(n)).expect("an exponent")
}

fn metal(fields: &str, n: f64) -> (Material, microbrdf::table::CosineCurve) {
    let text = format!("model = \"metal\", {fields}, exponent = {n}");
    let material = Material::from_argument(&text).expect("a metal");
    let Material::Metal { reflectance, .. } = &material else {
        unreachable!("{material:?} is no metal")
    };
    let curve = reflectance.curve();
    (material, curve)
}

const CHROMIUM: &str = "eta = [3.18, 3.2, 2.3], k = [3.3, 3.3, 3.1]";
const GLASS: &str = "eta = [1.5, 1.5, 1.5], k = [0, 0, 0]";

/// The greatest error of a kind of metal at K = 1 and, for n to 500, K = c_n.
fn of_metals<const KNOTS: usize>(fields: &[&str]) -> [f64; 2] {
    let mut found = [0.0f64; 2];
    for fields in fields {
        for n in [1.0, 1.5, 2.0, 20.0, 100.0, 500.0, 5000.0] {
            let peak = (n + 2.0) / std::f64::consts::TAU;
            for (k, found) in [1.0, peak].into_iter().zip(&mut found) {
                if k > 100.0 {
                    continue;
                }
                let (material, curve) = metal(fields, n);
                let model = ExposedMetal::<129, KNOTS>::new(lobe(n), &curve, Rgb::grey(number(k)))
                    .expect("a gain");
                *found = found.max(worst(&material, n, k, |pair| model.shade(pair)));
            }
        }
    }
    println!("{fields:?} {KNOTS}: {found:.3?}");
    found
}

#[test]
fn metals_with_65_knots() {
    let metals = ["\"gold\"", "\"silver\"", "\"copper\""].map(|metal| format!("metal = {metal}"));
    let [one, peak] = of_metals::<65>(&metals.each_ref().map(String::as_str));
    within(one, 0.67..=0.75);
    within(peak, 0.65..=0.75);
}

#[test]
fn metals_that_bend_with_129_and_257_knots() {
    let [one, peak] = of_metals::<129>(&["metal = \"aluminium\"", CHROMIUM]);
    within(one, 0.69..=0.75);
    within(peak, 0.67..=0.75);
    let [one, peak] = of_metals::<257>(&[GLASS]);
    within(one, 0.69..=0.75);
    within(peak, 1.02..=1.05);
}

#[test]
fn lobes_of_any_exponent() {
    let mut found = [0.0f64; 2];
    for n in [1.0, 1.5, 2.0, 3.7, 20.0, 100.0, 500.0, 5000.0, 1e5, 1e8] {
        let text = format!("model = \"metallic-phong\", exponent = {n}");
        let material = Material::from_argument(&text).expect("a lobe");
        let peak = (n + 2.0) / std::f64::consts::TAU;
        for (k, found) in [1.0, peak].into_iter().zip(&mut found) {
            if k > 100.0 {
                continue;
            }
            let model = ExposedPhong::<129>::new(lobe(n), Rgb::grey(number(k))).expect("a gain");
            *found = found.max(worst(&material, n, k, |pair| model.shade(pair)));
        }
    }
    println!("lobes: {found:.3?}");
    within(found[0], 0.67..=0.75);
    within(found[1], 0.60..=0.75);
}

/// Where a lobe's end at α = 90° bends without bound, twice the knots are enough.
#[test]
fn metals_between_1_and_2() {
    let mut found = 0.0f64;
    for n in [1.0, 1.02, 1.05, 1.1, 1.15, 1.2, 1.3, 1.43, 1.5, 1.7] {
        let (material, curve) = metal("metal = \"gold\"", n);
        let lobe = MetallicPhong::<Q15<257>>::new(number(n)).expect("an exponent");
        let gain = Rgb::grey(U32F32::ONE);
        let model = ExposedMetal::<257, 65>::new(lobe, &curve, gain).expect("a gain");
        let off = worst(&material, n, 1.0, |pair| {
            let [l, v] = [pair.l, pair.v].map(|d| Direction::new(d.x, d.y, d.z));
            model.shade(&ShadingFrame::<Q15<257>>::new(l, v))
        });
        found = found.max(off);
    }
    println!("gold from n = 1 to 1.7, 257 knots: {found:.3}");
    within(found, 0.53..=0.75);
}

#[test]
fn patches_of_any_radius() {
    let mut found = 0.0f64;
    for radius in [0.01, 0.05, 0.3, 1.0, 1.4, 2.0] {
        let text = format!("model = \"patch\", radius = {radius}");
        let material = Material::from_argument(&text).expect("a patch");
        let patch = Patch::<Q15>::new(U2F30::from_num(radius)).expect("a radius");
        let peak = std::f64::consts::FRAC_1_PI / f64::min(1.0, radius * radius);
        let n = 1.0 / (radius * radius);
        for k in [0.01, 1.0, peak] {
            let model = ExposedPatch::<129>::new(patch, Rgb::grey(number(k))).expect("a gain");
            found = found.max(worst(&material, n, k, |pair| model.shade(pair)));
        }
    }
    println!("patches: {found:.3}");
    within(found, 0.50..=0.56);
}

/// What a light does that is too bright or too dim for 16 bits, beside the
/// ordinary way.
#[test]
fn any_gain_is_white_or_black_where_it_must_be() {
    let (_, curve) = metal("metal = \"gold\"", 20.0);
    let plain = Metal::new(lobe(20.0), curve);
    for k in [
        1e-9, 1e-3, 0.03, 1.0, 7.9, 8.1, 255.0, 257.0, 1e4, 1e6, 2e7, 4e9,
    ] {
        let gain = Rgb::grey(number(k));
        let model = ExposedMetal::<129, 65>::new(lobe(20.0), &curve, gain).expect("a gain");
        for pair in Set::ALL
            .into_iter()
            .flat_map(|set| set.pairs(20.0, 40.0, COUNT))
        {
            let geometry = Subject::<Q15>::geometry(pair);
            let gain = Rgb::grey(<Q15 as HostArithmetic>::gain(k));
            let expected = plain.shade(&gain, &geometry).map(srgb8).to_array();
            let shown = middle(model.shade(&geometry)).map(srgb8);
            for (shown, expected) in shown.into_iter().zip(expected) {
                // Beyond K = 1000 a step of a share is more than one of light.
                assert!(
                    k > 1000.0 || shown.abs_diff(expected) <= 1,
                    "K = {k}: {shown} for {expected} at {pair:?}"
                );
            }
        }
        let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
        let light = model.shade(&ShadingFrame::new(up, up));
        assert_eq!(light.r == u16::MAX, k > 1.1, "{k}");
        assert_eq!(light.r == 0, k < 1e-5, "{k}");
    }
}

#[test]
fn a_gain_whose_channels_are_too_far_apart_is_refused_if_it_is_great() {
    let gain = |r, b| Rgb {
        r: number(r),
        g: number(r),
        b: number(b),
    };
    assert!(ExposedPhong::<129>::new(lobe(20.0), gain(300.0, 2.0)).is_err());
    assert!(ExposedPhong::<129>::new(lobe(20.0), gain(300.0, 3.0)).is_ok());
    // One that is off is no matter, nor is a faint one beside less.
    assert!(ExposedPhong::<129>::new(lobe(20.0), gain(300.0, 0.0)).is_ok());
    assert!(ExposedPhong::<129>::new(lobe(20.0), gain(250.0, 0.1)).is_ok());
    let (_, curve) = metal("metal = \"gold\"", 20.0);
    assert!(ExposedMetal::<129, 65>::new(lobe(20.0), &curve, gain(300.0, 2.0)).is_err());
    let patch = Patch::<Q15>::new(U2F30::from_num(0.1)).expect("a radius");
    assert!(ExposedPatch::<129>::new(patch, gain(16_384.0, 0.0)).is_ok());
    let error = ExposedPatch::<129>::new(patch, gain(16_385.0, 0.0)).expect_err("too bright");
    assert_eq!(error.to_string(), "gain must be at most 16384");
}

#[test]
fn a_curve_that_falls_too_steeply_for_its_cells_is_refused() {
    let mut entries = [[100; 3]; microbrdf::table::COSINE_KNOTS];
    entries[0] = [32_768; 3];
    let steep = microbrdf::table::CosineCurve::from_entries(entries);
    let error = ExposedMetal::<129, 65>::new(lobe(20.0), &steep, Rgb::grey(U32F32::ONE))
        .expect_err("a step in one cell");
    assert_eq!(error.parameter, "fresnel");
}

/// A colour is each channel's own.
#[test]
fn channels_do_not_mix() {
    let gain = Rgb {
        r: number(1.0),
        g: number(0.5),
        b: U32F32::ZERO,
    };
    let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
    let pair = ShadingFrame::new(up, up);
    let phong = ExposedPhong::<129>::new(lobe(20.0), gain).expect("a gain");
    assert_eq!(
        phong.shade(&pair),
        Rgb {
            r: 65_535,
            g: 32_768,
            b: 0
        }
    );
    let patch = Patch::<Q15>::new(U2F30::from_num(0.1)).expect("a radius");
    let patch = ExposedPatch::<129>::new(patch, gain).expect("a gain");
    assert_eq!(
        patch.shade(&pair),
        Rgb {
            r: 65_535,
            g: 32_768,
            b: 0
        }
    );
}

/// Directions of any length, in both geometries: overflow checks are on.
#[test]
fn nothing_wraps_for_directions_of_any_length() {
    let ends = [
        i16::MIN,
        -16_385,
        -16_384,
        -1,
        0,
        1,
        8_000,
        16_384,
        16_385,
        i16::MAX,
    ];
    let gains = [1e-6, 1.0, 80.0, 1e4].map(|k| Rgb::grey(number(k)));
    let (_, curve) = metal("metal = \"gold\"", 20.0);
    let patch = Patch::<Q15>::new(U2F30::from_num(2.0)).expect("a radius");
    let models = gains.map(|gain| {
        (
            ExposedMetal::<129, 65>::new(lobe(1.0), &curve, gain).expect("a gain"),
            ExposedPatch::<129>::new(patch, gain).expect("a gain"),
            DirectPhong::<256>::new(&lobe(1.0), gain).expect("a gain"),
        )
    });
    let direction = |x, y, z| {
        let [x, y, z] = [x, y, z].map(I2F14::from_bits);
        Direction::<Q15>::new(x, y, z)
    };
    let mut lit = 0;
    for lz in ends {
        for vz in ends {
            for x in ends {
                for y in ends {
                    let (l, v) = (direction(x, y, lz), direction(y, -(x / 2), vz));
                    let frame = ShadingFrame::new(l, v);
                    let normal = direction(x / 3, y / 3, 15_000);
                    let world = World::new(normal, l, v);
                    let short = ShortWorld::new(normal, l, v);
                    for (metal, patch, phong) in &models {
                        lit += u32::from(phong.light(&frame).is_some());
                        lit += u32::from(phong.light(&short).is_some());
                        lit += u32::from(metal.light(&frame).is_some());
                        lit += u32::from(metal.light(&world).is_some());
                        lit += u32::from(metal.light(&short).is_some());
                        let light = patch.shade(&frame);
                        assert!(lz > 0 && vz >= 0 || light == Rgb::grey(0));
                        lit += u32::from(patch.shade(&world).r > 0);
                    }
                }
            }
        }
    }
    assert!(lit > 10_000, "{lit}");
}

/// In world space it is what it is in the shading frame, for directions that
/// both hold exactly.
#[test]
fn both_geometries_agree() {
    let up = Direction::new(I2F14::ZERO, I2F14::ZERO, I2F14::ONE);
    let model = ExposedPhong::<129>::new(lobe(20.0), Rgb::grey(U32F32::ONE)).expect("a gain");
    let mut lit = 0;
    for pair in Set::Random.pairs(20.0, 9.0, COUNT) {
        let pair: Pair = pair;
        let frame = Subject::<Q15>::geometry(pair);
        let light = model.shade(&frame);
        assert_eq!(model.shade(&World::new(up, frame.l, frame.v)), light);
        lit += u32::from(light.r > 0);
    }
    assert!(lit > 100);
}

/// Every light of 16 bits: both ends of what it stands for.
#[test]
fn the_direct_encoder_is_a_tenth_of_a_code_less_exact() {
    let mut greatest = 0.0f64;
    for light in 0..=u16::MAX {
        let code = f64::from(srgb8_direct(light));
        for end in [light.into(), u32::from(light) + 1] {
            let exact = 255.0 * encode_srgb(f64::from(end) / 65_536.0);
            greatest = greatest.max((code - exact).abs());
        }
    }
    assert!((0.59..=0.60).contains(&greatest), "{greatest}");
    assert_eq!(srgb8_direct(0), 0);
    assert_eq!(srgb8_direct(u16::MAX), 255);
}

/// A palette's cells are no finer than the steps.
#[test]
fn a_palette_gives_the_same_for_16_bits() {
    let palette = Palette565::new([1 << 24, 1 << 23, 1 << 20]);
    for light in 0..=u16::MAX {
        assert_eq!(palette.at_short(light), palette.at(u32::from(light) << 8));
    }
}
