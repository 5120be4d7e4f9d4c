//! The gamut map: what to do with a colour outside sRGB.

/// A linear colour brought into 0 … 1 by desaturation: it is moved towards the grey
/// of its own luminance (clamped to 0 … 1) just as far as the worst channel needs.
///
/// Luminance is kept, hue nearly so; a colour inside is returned unchanged. Tables and
/// materials hold colours before this map, so that energy stays true; it belongs after
/// shading, at the picture.
pub fn to_gamut(rgb: [f64; 3]) -> [f64; 3] {
    let y = crate::brdf::luminance(rgb).clamp(0.0, 1.0);
    let mut keep = 1.0f64;
    for c in rgb {
        if c > 1.0 {
            keep = keep.min((1.0 - y) / (c - y));
        } else if c < 0.0 {
            keep = keep.min(y / (y - c));
        }
    }
    if keep >= 1.0 {
        return rgb;
    }
    rgb.map(|c| (y + keep * (c - y)).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::luminance;

    #[test]
    fn inside_is_unchanged_and_outside_keeps_its_luminance() {
        assert_eq!(to_gamut([0.2, 1.0, 0.0]), [0.2, 1.0, 0.0]);
        for c in [[1.08, 0.78, 0.33], [0.5, 0.5, -0.1], [1.5, -0.2, 0.3]] {
            let m = to_gamut(c);
            assert!(m.iter().all(|c| (0.0..=1.0).contains(c)), "{m:?}");
            assert!((luminance(m) - luminance(c)).abs() < 1e-12, "{m:?}");
        }
        assert_eq!(to_gamut([2.0, 2.0, 2.0]), [1.0; 3]);
    }
}
