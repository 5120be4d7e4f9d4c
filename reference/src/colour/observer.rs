//! From a spectrum to linear sRGB: CIE 1931 2° observer, illuminant D65, 380 to 780 nm
//! by 1 nm, data of the `colorimetry` crate.

use colorimetry::illuminant::CieIlluminant;
use colorimetry::observer::Observer as Cie;
use colorimetry::traits::Light;
use std::sync::OnceLock;

/// The illuminant under which reflectances are turned into colours.
pub const ILLUMINANT: &str = "CIE D65";

/// First and last wavelength in nm, by steps of 1 nm.
pub const WAVELENGTHS: (usize, usize) = (380, 780);

/// Chromaticities x, y of sRGB's primaries (IEC 61966-2-1), and of its white D65.
const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];
const WHITE: [f64; 2] = [0.3127, 0.3290];

/// The weights that turn a reflectance spectrum into linear sRGB.
#[derive(Debug)]
pub struct Observer {
    /// For each wavelength, its weight in red, green and blue; each channel's sum is 1.
    weights: Vec<[f64; 3]>,
    /// For each wavelength, its weight in X, Y and Z; the sum of Y's is 1.
    tristimulus: Vec<[f64; 3]>,
}

impl Observer {
    /// CIE 1931 2° under D65, computed once.
    ///
    /// A reflectance of 1 at every wavelength gives exactly white, (1, 1, 1) up to
    /// rounding: the channels are scaled by the white that the same sums give, which
    /// takes the part of a von Kries adaptation to sRGB's white (they differ by less
    /// than 1e-3).
    pub fn standard() -> &'static Self {
        static STANDARD: OnceLock<Observer> = OnceLock::new();
        STANDARD.get_or_init(|| {
            let primaries = columns_from_chromaticities();
            let inverse = inverted(primaries);
            let light = CieIlluminant::D65.spectrum();
            let mut tristimulus: Vec<[f64; 3]> = (WAVELENGTHS.0..=WAVELENGTHS.1)
                .map(|nm| {
                    let cmf = Cie::Cie1931
                        .xyz_at_wavelength(nm)
                        .expect("within 380 to 780 nm")
                        .to_array();
                    let power = light.as_array()[nm - WAVELENGTHS.0];
                    cmf.map(|c| c * power)
                })
                .collect();
            let luminous: f64 = tristimulus.iter().map(|t| t[1]).sum();
            for t in tristimulus.iter_mut().flatten() {
                *t /= luminous;
            }
            let mut weights: Vec<[f64; 3]> = tristimulus
                .iter()
                .map(|t| multiplied(inverse, *t))
                .collect();
            let mut white = [0.0; 3];
            for w in &weights {
                for (sum, part) in white.iter_mut().zip(w) {
                    *sum += part;
                }
            }
            for w in &mut weights {
                for (part, sum) in w.iter_mut().zip(white) {
                    *part /= sum;
                }
            }
            Observer {
                weights,
                tristimulus,
            }
        })
    }

    /// The linear sRGB colour of a surface with the given reflectance at each
    /// wavelength in nm, under the illuminant. May lie outside 0 … 1.
    pub fn colour(&self, reflectance: &dyn Fn(f64) -> f64) -> [f64; 3] {
        weighted(&self.weights, reflectance)
    }

    /// X, Y and Z of the same surface; Y of a perfect white is 1.
    pub fn xyz(&self, reflectance: &dyn Fn(f64) -> f64) -> [f64; 3] {
        weighted(&self.tristimulus, reflectance)
    }
}

fn weighted(weights: &[[f64; 3]], reflectance: &dyn Fn(f64) -> f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (i, weight) in weights.iter().enumerate() {
        let r = reflectance((WAVELENGTHS.0 + i) as f64);
        for (sum, w) in sums.iter_mut().zip(weight) {
            *sum += w * r;
        }
    }
    sums
}

/// The linear sRGB colour of a reflectance spectrum (wavelength in nm) under D65.
pub fn spectrum_to_rgb(reflectance: &dyn Fn(f64) -> f64) -> [f64; 3] {
    Observer::standard().colour(reflectance)
}

/// XYZ (Y of white is 1) of a linear sRGB colour.
pub(crate) fn srgb_to_xyz(rgb: [f64; 3]) -> [f64; 3] {
    let primaries = columns_from_chromaticities();
    let white = [
        WHITE[0] / WHITE[1],
        1.0,
        (1.0 - WHITE[0] - WHITE[1]) / WHITE[1],
    ];
    let scale = multiplied(inverted(primaries), white);
    multiplied(primaries, [0, 1, 2].map(|i| scale[i] * rgb[i]))
}

type Matrix = [[f64; 3]; 3];

fn columns_from_chromaticities() -> Matrix {
    let column = |[x, y]: [f64; 2]| [x / y, 1.0, (1.0 - x - y) / y];
    let [r, g, b] = PRIMARIES.map(column);
    [0, 1, 2].map(|i| [r[i], g[i], b[i]])
}

fn multiplied(m: Matrix, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn inverted(m: Matrix) -> Matrix {
    let minor = |r: usize, c: usize| {
        let (r1, r2) = ((r + 1) % 3, (r + 2) % 3);
        let (c1, c2) = ((c + 1) % 3, (c + 2) % 3);
        m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
    };
    let det: f64 = (0..3).map(|c| m[0][c] * minor(0, c)).sum();
    [0, 1, 2].map(|r| [0, 1, 2].map(|c| minor(c, r) / det))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_white() {
        for c in spectrum_to_rgb(&|_| 1.0) {
            assert!((c - 1.0).abs() < 1e-13, "{c}");
        }
        for c in spectrum_to_rgb(&|_| 0.5) {
            assert!((c - 0.5).abs() < 1e-13, "{c}");
        }
    }

    #[test]
    fn white_has_d65s_chromaticity() {
        let [x, y, z] = Observer::standard().xyz(&|_| 1.0);
        let sum = x + y + z;
        // CIE 15 gives 0.31272, 0.32903 from 360 to 830 nm; here the violet end is missing.
        let (cx, cy) = (x / sum, y / sum);
        let near = (cx - 0.31272).abs() < 3e-5 && (cy - 0.32903).abs() < 3e-5;
        assert!(near, "{cx} {cy}");
        assert!((y - 1.0).abs() < 1e-13);
    }

    #[test]
    fn the_matrix_is_srgbs() {
        // IEC 61966-2-1 prints four digits.
        let x = srgb_to_xyz([1.0, 0.0, 0.0]);
        for (a, b) in x.iter().zip([0.4124, 0.2126, 0.0193]) {
            assert!((a - b).abs() < 1e-4, "{x:?}");
        }
        let w = srgb_to_xyz([1.0; 3]);
        for (a, b) in w.iter().zip([0.9505, 1.0, 1.0890]) {
            assert!((a - b).abs() < 2e-4, "{w:?}");
        }
    }

    #[test]
    fn long_waves_are_red_and_short_ones_blue() {
        let red = spectrum_to_rgb(&|nm| if nm > 620.0 { 1.0 } else { 0.0 });
        assert!(red[0] > red[1] && red[0] > red[2], "{red:?}");
        let blue = spectrum_to_rgb(&|nm| if nm < 470.0 { 1.0 } else { 0.0 });
        assert!(blue[2] > blue[0] && blue[2] > blue[1], "{blue:?}");
    }
}
