//! Displays of few levels.

use microbrdf::shade::{LINEAR_ONE, Linear, srgb8};
use microbrdf_tests::dither::{Display, RAMPS, document, look};

#[test]
fn the_document_is_what_the_code_gives() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/dither.md");
    let text = std::fs::read_to_string(path).expect("docs/dither.md");
    for (written, made) in text.lines().zip(document().lines()) {
        assert_eq!(written, made);
    }
    assert_eq!(text, document());
}

/// A dither is there to shorten what is flat, and to keep grey what is grey.
#[test]
fn a_dither_shortens_runs_and_takes_away_casts() {
    for ramp in RAMPS {
        for display in [Display::Rgb565, Display::Grey16] {
            let (off, on) = (look(display(false), ramp), look(display(true), ramp));
            assert!(
                3 * on.flat_run <= 2 * off.flat_run,
                "{ramp:?}: {on:?} {off:?}"
            );
            if matches!(display(true), Display::Rgb565(_)) {
                assert!(2.0 * on.cast < off.cast, "{ramp:?}: {on:?} {off:?}");
            }
        }
    }
}

/// Over a cell, levels average to the code; thresholds stay where they are.
#[test]
fn a_cell_averages_to_the_code() {
    for linear in (0..=LINEAR_ONE).step_by(4_099) {
        let light = Linear::from_raw(linear, linear, linear);
        let code = f64::from(srgb8(linear));
        for (shift, mask, levels) in [(11, 31, 31.0), (5, 63, 63.0), (0, 31, 31.0)] {
            let level = |x, y| f64::from((light.rgb565_dithered(x, y) >> shift) & mask);
            let sum: f64 = (0..16).map(|i| level(4 + i % 4, i / 4)).sum();
            let wanted = code / 255.0 * levels;
            assert!((sum / 16.0 - wanted).abs() <= 1.0 / 32.0 + 1e-9, "{code}");
            assert_eq!(level(1, 2), level(5, 10));
        }
    }
}
