//! The transfer function of sRGB (IEC 61966-2-1).

/// Linear light (0 … 1, clamped) to the encoded value, 0 … 1.
pub fn encode_srgb(linear: f64) -> f64 {
    let c = linear.clamp(0.0, 1.0);
    if c <= 0.003_130_8 {
        12.92 * c
    } else {
        1.055 * c.powf(1.0 / 2.4) - 0.055
    }
}

/// The encoded value (0 … 1, clamped) to linear light, 0 … 1.
pub fn decode_srgb(encoded: f64) -> f64 {
    let e = encoded.clamp(0.0, 1.0);
    if e <= 0.040_45 {
        e / 12.92
    } else {
        ((e + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_middle_and_round_trip() {
        assert_eq!(encode_srgb(0.0), 0.0);
        assert!((encode_srgb(1.0) - 1.0).abs() < 1e-15);
        assert!((encode_srgb(0.214_041_14) - 0.5).abs() < 1e-8);
        for code in 0..=255 {
            let e = f64::from(code) / 255.0;
            assert!((encode_srgb(decode_srgb(e)) - e).abs() < 1e-12, "{code}");
        }
    }
}
