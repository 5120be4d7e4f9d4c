//! The sRGB encoder, for every input.

use microbrdf::shade::{LINEAR_ONE, Linear, Palette565, srgb8, srgb8_bisected, srgb8_quick};

/// IEC 61966-2-1, code as a real number.
fn encoded(linear: f64) -> f64 {
    let v = if linear <= 0.0031308 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    255.0 * v
}

#[test]
fn every_linear_value_gets_its_rounded_code() {
    let mut greatest = 0.0f64;
    for linear in 0..=LINEAR_ONE {
        let exact = encoded(f64::from(linear) / f64::from(LINEAR_ONE));
        let code = srgb8(linear);
        assert_eq!(srgb8_bisected(linear), code, "linear {linear}");
        greatest = greatest.max((f64::from(code) - exact).abs());
        // The two branches of the standard meet with a gap of 1e-5 of a code.
        assert!(
            (f64::from(code) - exact).abs() <= 0.500_02,
            "linear {linear}: {code} for {exact}"
        );
    }
    assert!(greatest > 0.499, "the test saw no value near a threshold");
}

#[test]
fn the_quick_encoder_is_a_tenth_of_a_code_less_exact() {
    let mut greatest = 0.0f64;
    for linear in 0..=LINEAR_ONE {
        let exact = encoded(f64::from(linear) / f64::from(LINEAR_ONE));
        greatest = greatest.max((f64::from(srgb8_quick(linear)) - exact).abs());
    }
    assert!((0.595..=0.60).contains(&greatest), "{greatest}");
    assert_eq!(srgb8_quick(0), 0);
    assert_eq!(srgb8_quick(LINEAR_ONE), 255);
    assert_eq!(srgb8_quick(u32::MAX), 255);
}

#[test]
fn beyond_one_is_white() {
    assert_eq!(srgb8(LINEAR_ONE + 1), 255);
    assert_eq!(srgb8(u32::MAX), 255);
    assert_eq!(srgb8_bisected(u32::MAX), 255);
    assert_eq!(
        Linear::from_raw(u32::MAX, 0, LINEAR_ONE + 1).to_raw(),
        [LINEAR_ONE, 0, LINEAR_ONE]
    );
}

#[test]
fn rgb565_takes_the_nearest_level() {
    for linear in (0..=LINEAR_ONE).step_by(997) {
        let pixel = Linear::from_raw(linear, linear, linear);
        let code = f64::from(srgb8(linear));
        let packed = pixel.rgb565();
        let (red, green, blue) = (packed >> 11, (packed >> 5) & 63, packed & 31);
        assert_eq!(f64::from(red), (code * 31.0 / 255.0).round());
        assert_eq!(f64::from(green), (code * 63.0 / 255.0).round());
        assert_eq!(blue, red);
    }
}

#[test]
fn a_palette_is_at_most_a_level_off() {
    let tint = [LINEAR_ONE, LINEAR_ONE / 2, LINEAR_ONE / 20];
    let palette = Palette565::new(tint);
    let mut off = 0;
    for light in (0..=LINEAR_ONE).step_by(7) {
        let packed = palette.at(light);
        let levels = [packed >> 11, (packed >> 5) & 63, packed & 31];
        for ((level, tint), greatest) in levels.into_iter().zip(tint).zip([31.0, 63.0, 31.0]) {
            let linear =
                f64::from(light) / f64::from(LINEAR_ONE) * f64::from(tint) / f64::from(LINEAR_ONE);
            let exact = (encoded(linear) * greatest / 255.0).round();
            let error = (f64::from(level) - exact).abs();
            assert!(error <= 1.0, "light {light}: {level} for {exact}");
            off += u32::from(error == 1.0);
        }
    }
    // It is coarse: no test of an exact encoder.
    assert!(off > 100_000, "{off}");
    assert_eq!(palette.at(0), 0);
    assert_eq!(palette.at(u32::MAX), palette.at(LINEAR_ONE));
    assert_eq!(Palette565::new([u32::MAX; 3]).at(LINEAR_ONE), 0xFFFF);
}

#[test]
fn luminance_weighs_the_channels() {
    for value in [0, 1, 4095, 4096, 1 << 20, LINEAR_ONE] {
        let exact = |weight: f64| f64::from(value) * weight;
        let luminance = |r, g, b| f64::from(Linear::from_raw(r, g, b).luminance());
        assert!((luminance(value, 0, 0) - exact(0.2126)).abs() < 120.0);
        assert!((luminance(0, value, 0) - exact(0.7152)).abs() < 120.0);
        assert!((luminance(0, 0, value) - exact(0.0722)).abs() < 120.0);
        assert!((luminance(value, value, value) - f64::from(value)).abs() < 6.0);
    }
}
