//! The ends of K.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf;
use microbrdf_reference::geometry::{retro_versine, versine};
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::domain::Set;
use microbrdf_tests::error::Subject;
use microbrdf_tests::{in_every_arithmetic, registry};

use crate::faults::Faults;

in_every_arithmetic!(
    exposure_never_wraps,
    every_model_is_exact_at_the_ends_of_exposure,
);

/// Greatest error of generalised Lambert's table, `tables.rs`.
const PROFILE_ERROR: f64 = 4e-4;

/// K from 1e-3 to 2e7 on shares from the least to 1: the clamped product,
/// within a step of linear light.
fn exposure_never_wraps<A: Tested>() {
    let mut k = 1e-3;
    while k <= 2e7 {
        let gain = A::gain(k);
        let mut share = 1.0;
        while share > 1e-10 {
            let held = A::unit_value(A::unit(share));
            let found =
                f64::from(A::linear(Rgb::grey(A::expose(gain, A::unit(share)))).to_raw()[0]);
            let exact = (k * held).min(1.0) * f64::from(1 << 24);
            assert!(
                (found - exact).abs()
                    <= 1.0 + A::GAIN_ERROR * exact + A::EXPOSURE_STEP * k * 16_777_216.0,
                "K = {k}, share {held}: {found} for {exact}"
            );
            share *= 0.61;
        }
        k *= 1.37;
    }
    for k in [1e-3, 1.0, 2e7] {
        let light = |share: f64| A::linear(Rgb::grey(A::expose(A::gain(k), A::unit(share))));
        assert_eq!(light(0.0).to_raw(), [0; 3]);
        let (found, exact) = (f64::from(light(1.0).to_raw()[0]), k.min(1.0) * 16_777_216.0);
        assert!((found - exact).abs() <= 0.5 + A::GAIN_ERROR * exact);
    }
    // Many lights on one pixel are white, not what is left of their sum.
    let full = A::expose(A::gain(2e7), A::ONE);
    let sum = (0..1000).fold(A::Light::default(), |sum, _| A::add_light(sum, full));
    assert_eq!(A::linear(Rgb::grey(sum)).srgb8(), [255; 3]);
}

/// Every model at K = 1e-3 and 2e7: linear light within what the stored curves
/// and the last bits of a share leave, times K.
fn every_model_is_exact_at_the_ends_of_exposure<A: Tested>() {
    let mut faults = Faults::default();
    let mut graded = 0;
    for entry in registry::all() {
        let subject = Subject::<A>::new(&entry.material());
        for k in [1e-3, 2e7] {
            let gain = Rgb::grey(A::gain(k));
            for set in Set::ALL {
                for pair in entry.pairs(set, 9.0 + k.max(1.0).ln(), 200) {
                    let geometry = Subject::<A>::geometry(pair);
                    let shown = A::linear(subject.model.shade(&gain, &geometry)).to_raw();
                    let [l, v] = Subject::<A>::rounded(&geometry);
                    let exact = subject.exact.rho(&l, &v);
                    let x = if entry.model == "retro-phong" {
                        retro_versine(&l, &v)
                    } else {
                        versine(&l, &v)
                    };
                    // A float's versine is off by a few roundings, which
                    // n/(1 − x) magnifies where a broad lobe ends.
                    let turned = if A::FRACTIONAL_EXPONENTS && x < 1.0 {
                        2e-7 * entry.n * x / (1.0 - x)
                    } else {
                        0.0
                    };
                    for (shown, rho) in shown.into_iter().zip(exact) {
                        // The share's own steps: of its value, or of 1.
                        let steps = A::LOBE_FLOOR
                            + A::RATIO_FLOOR
                            + if A::FRACTIONAL_EXPONENTS {
                                rho / f64::from(1 << 21)
                            } else {
                                4.0 * A::UNIT_STEP
                            };
                        // Glass: its curve is off by 1.4e-4 of 0.04.
                        let curve = match entry.model {
                            "metal" | "plastic with index" | "patch-metal" | "metallic-paint" => {
                                3.5e-3
                            }
                            "generalised-lambert" => PROFILE_ERROR,
                            _ => 0.0,
                        };
                        let relative = A::LOBE_ERROR + A::PRODUCT_ERROR + curve;
                        let bound = k * ((relative + turned) * rho + steps);
                        let light = f64::from(shown) / f64::from(1 << 24);
                        let expected = (k * rho).min(1.0);
                        if (light - expected).abs() > bound + 1.0 / f64::from(1 << 24) {
                            faults.add(&format!("{}, K = {k}", entry.toml), || {
                                format!("{set:?}: {light} for {expected}, may be off by {bound:e}")
                            });
                        }
                        graded += u32::from(shown > 0 && shown < 1 << 24);
                    }
                }
            }
        }
    }
    assert!(
        graded > 50_000,
        "only {graded} were neither black nor white"
    );
}
