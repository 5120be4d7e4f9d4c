//! What only one of the arithmetics can be given.

use microbrdf::Rgb;
use microbrdf::arithmetic::{Arithmetic as _, F32, Q31};
use microbrdf::brdf::{Brdf, MetallicPhong};
use microbrdf::fixed::types::I2F30;
use microbrdf::geometry::{Direction, ShadingFrame, World};
use microbrdf_tests::arithmetic::{Tested, bits};
use microbrdf_tests::given::{frame, model};

use crate::faults::{Faults, in_range, is_zero};

/// All sequences of `length` of the given values.
fn each<T: Copy>(values: &[T], length: usize, mut call: impl FnMut(&[T])) {
    let mut index = vec![0; length];
    let mut chosen = vec![values[0]; length];
    loop {
        call(&chosen);
        let mut place = 0;
        loop {
            if place == length {
                return;
            }
            index[place] += 1;
            if index[place] < values.len() {
                break;
            }
            index[place] = 0;
            place += 1;
        }
        for (chosen, index) in chosen.iter_mut().zip(&index) {
            *chosen = values[*index];
        }
    }
}

const EACH: [&str; 16] = [
    "model = \"lambert\", albedo = 1",
    "model = \"phong\", exponent = 1",
    "model = \"phong\", exponent = 20, p = 0.5",
    "model = \"metallic-phong\", exponent = 0",
    "model = \"metallic-phong\", exponent = 1e8",
    "model = \"retro-phong\", exponent = 2",
    "model = \"patch\", radius = 1.5",
    "model = \"patch\", radius = 2",
    "model = \"patch-exponential\", sharpness = 4",
    "model = \"metal\", metal = \"gold\", exponent = 20",
    "model = \"plastic\", albedo = 0.5, specular = 0.5, exponent = 20",
    "model = \"plastic\", albedo = 0.5, specular = 0.5, exponent = 20, index = 1.5",
    "model = \"patch-metal\", radius = 1.5, metal = \"gold\"",
    "model = \"patch-metal\", sharpness = 4, metal = \"gold\"",
    "model = \"metallic-paint\", sharpness = 4, metal = \"gold\"",
    "model = \"generalised-lambert\", albedo = 1, smoothness = 1",
];

/// Every direction of such components: of `values` in the shading frame, of `few` in
/// world space.
fn components_stay_in_range<A: Tested>(values: &[A::Component], few: &[A::Component]) {
    let mut faults = Faults::default();
    let direction = |c: &[A::Component], i| Direction::<A>::new(c[i], c[i + 1], c[i + 2]);
    for toml in EACH {
        let model = model::<A>(toml);
        each(values, 6, |c| {
            let [l, v] = [0, 3].map(|i| direction(c, i));
            in_range(&mut faults, toml, &model, &ShadingFrame::new(l, v));
        });
        each(few, 9, |c| {
            let [n, l, v] = [0, 3, 6].map(|i| direction(c, i));
            in_range(&mut faults, toml, &model, &World::new(n, l, v));
        });
    }
}

#[test]
fn no_fixed_point_input_leaves_the_range() {
    let values = [i32::MIN, -(1 << 30), -1, 0, 1, 1 << 30, i32::MAX].map(I2F30::from_bits);
    let few = [i32::MIN, 0, 1 << 30, i32::MAX].map(I2F30::from_bits);
    components_stay_in_range::<Q31>(&values, &few);
}

/// Finite numbers of any size, negative zero among them.
#[test]
fn no_finite_input_leaves_the_range() {
    let values = [f32::MIN, -1.0, -0.0, 0.0, f32::MIN_POSITIVE, 1.0, 1e20];
    let few = [f32::MIN, -0.0, 1.0, 1e-30];
    components_stay_in_range::<F32>(&values, &few);
}

/// Every mixture of good components of L, V and N and one bad value.
fn mixtures() -> impl Iterator<Item = [Direction<F32>; 3]> {
    const GOOD: [f32; 9] = [0.6, 0.0, 0.8, -0.48, 0.36, 0.8, 0.0, 0.0, 1.0];
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    bad.into_iter().flat_map(|bad| {
        (1..512).map(move |mask| {
            let c = |i: usize| if mask >> i & 1 == 1 { bad } else { GOOD[i] };
            [0, 3, 6].map(|i| Direction::new(c(i), c(i + 1), c(i + 2)))
        })
    })
}

/// What is not a number, or infinite, never shows as such.
#[test]
fn not_a_number_and_infinity_stay_in_range() {
    let mut faults = Faults::default();
    for toml in EACH {
        let model = model::<F32>(toml);
        for [l, v, n] in mixtures() {
            in_range(&mut faults, toml, &model, &World::new(n, l, v));
            in_range(&mut faults, toml, &model, &ShadingFrame::new(l, v));
        }
    }
}

/// The documentation of [`Direction`]: what is not a finite number makes
/// the result 0.
#[test]
fn not_a_number_and_infinity_give_zero() {
    let mut faults = Faults::default();
    let finite = |d: &Direction<F32>| [d.x, d.y, d.z].into_iter().all(f32::is_finite);
    for toml in EACH {
        let model = model::<F32>(toml);
        for [l, v, n] in mixtures() {
            is_zero(&mut faults, toml, &model, &World::new(n, l, v));
            if !finite(&l) || !finite(&v) {
                let name = format!("{toml}, in the shading frame");
                is_zero(&mut faults, &name, &model, &ShadingFrame::new(l, v));
            }
        }
    }
}

/// A gain or a peak that is no number shows as black, an infinite one as
/// black, white or the greatest number.
#[test]
fn gains_and_peaks_that_are_no_numbers_stay_in_range() {
    let there = frame::<F32>([-0.6, 0.0, 0.8], [0.6, 0.0, 0.8]);
    let beside = frame::<F32>([-0.6, 0.0, 0.8], [0.0, 0.6, 0.8]);
    for toml in EACH {
        let model = model::<F32>(toml);
        for geometry in [there, beside] {
            let shown = |gain: f32| F32::linear(model.shade(&Rgb::grey(gain), &geometry));
            assert_eq!(shown(f32::NAN).to_raw(), [0; 3], "{toml}");
            assert_eq!(shown(f32::NEG_INFINITY).to_raw(), [0; 3], "{toml}");
            for value in shown(f32::INFINITY).to_raw() {
                assert!(value == 0 || value == 1 << 24, "{toml}: {value}");
            }
        }
    }
    let lobe = MetallicPhong::<F32>::new(20.0).expect("an exponent");
    for (peak, greatest) in [(f32::NAN, 0.0), (f32::INFINITY, f32::MAX)] {
        let lobe = lobe.with_peak(peak);
        for value in [lobe.reflect(&there).r, lobe.brdf(&there).r] {
            assert_eq!(value, greatest, "peak {peak}");
        }
    }
}

/// −0.0 is the cosine 0, not one below the horizon.
#[test]
fn negative_zero_is_zero() {
    let mut faults = Faults::default();
    for toml in EACH {
        let model = model::<F32>(toml);
        for (lz, vz) in [(0.0f32, 0.0f32), (0.0, 0.8), (0.8, 0.0)] {
            let results = |zero: f32| {
                let z = |z: f32| if z == 0.0 { zero } else { z };
                let l = Direction::new((1.0 - lz * lz).sqrt(), 0.0, z(lz));
                let v = Direction::new(-(1.0 - vz * vz).sqrt(), 0.0, z(vz));
                let geometry = ShadingFrame::new(l, v);
                [
                    model.share(&geometry).r,
                    model.reflect(&geometry).r,
                    model.brdf(&geometry).r,
                ]
            };
            let (plain, negative) = (results(0.0), results(-0.0));
            if bits(plain) != bits(negative) {
                faults.add(&format!("{toml}, cosines {lz} and {vz}"), || {
                    format!("{negative:?} for {plain:?}")
                });
            }
        }
    }
}
