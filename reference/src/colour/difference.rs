//! CIELAB under D65 and CIEDE2000.

use super::observer::srgb_to_xyz;
use colorimetry::lab::CieLab;
use colorimetry::observer::Observer;
use colorimetry::xyz::XYZ;

/// CIELAB of a linear sRGB colour, with sRGB's own white.
pub fn lab(linear: [f64; 3]) -> [f64; 3] {
    let xyz = srgb_to_xyz(linear);
    let white = srgb_to_xyz([1.0; 3]);
    let f = |t: f64| {
        if t > (6.0f64 / 29.0).powi(3) {
            t.cbrt()
        } else {
            t * (29.0f64 / 6.0).powi(2) / 3.0 + 4.0 / 29.0
        }
    };
    let [x, y, z] = [0, 1, 2].map(|i| f(xyz[i] / white[i]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// L* (0 … 100) of a relative luminance 0 … 1.
pub fn lightness(luminance: f64) -> f64 {
    lab([luminance; 3])[0]
}

/// CIEDE2000 between two linear sRGB colours, with all weights 1.
pub fn ciede2000(a: [f64; 3], b: [f64; 3]) -> f64 {
    let white = XYZ::new([95.047, 100.0, 108.883], Observer::Cie1931);
    let (a, b) = (CieLab::new(lab(a), white), CieLab::new(lab(b), white));
    a.ciede2000(&b).expect("same observer and white")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_black_and_grey() {
        assert!((lightness(1.0) - 100.0).abs() < 1e-12);
        assert_eq!(lightness(0.0), 0.0);
        assert!((lightness(0.184_186_518) - 50.0).abs() < 1e-6);
        let [_, a, b] = lab([0.3; 3]);
        assert!(a.abs() < 1e-12 && b.abs() < 1e-12);
    }

    #[test]
    fn red_has_its_known_lab() {
        let [l, a, b] = lab([1.0, 0.0, 0.0]);
        assert!((l - 53.24).abs() < 0.01 && (a - 80.09).abs() < 0.02 && (b - 67.2).abs() < 0.02);
    }

    #[test]
    fn difference_is_a_difference() {
        assert_eq!(ciede2000([0.2, 0.3, 0.4], [0.2, 0.3, 0.4]), 0.0);
        assert!((ciede2000([0.0; 3], [1.0; 3]) - 100.0).abs() < 1e-9);
    }
}
