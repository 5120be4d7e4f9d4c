//! Measured data in regular half-angle tables, in the binary layout of the MERL database.
//!
//! W. Matusik, H. Pfister, M. Brand, L. McMillan, *A data-driven reflectance model*
//! (SIGGRAPH 2003), and the database's own reader, BRDFRead: three little-endian 32-bit
//! counts (90, 90, 180), then red, green and blue planes of little-endian doubles, to be
//! multiplied by 1/1500, 1.15/1500 and 1.66/1500. The index runs over √θh, θd and φd.

use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::models::{Blinn, Mixed};
use crate::{Brdf, Direction, ParameterError, brdf::luminance};
use std::f64::consts::{FRAC_PI_2, PI};

/// What the stored red, green and blue values are multiplied by.
const SCALES: [f64; 3] = [1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0];

/// A table over (√θh, θd, φd), looked up without interpolation, as its own reader does.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredHalfAngle {
    counts: [usize; 3],
    /// f in sr⁻¹ for each channel, cell by cell; φd runs fastest.
    cells: Vec<[f64; 3]>,
    coloured: bool,
}

impl MeasuredHalfAngle {
    /// From values in sr⁻¹ (finite; negative ones mark missing cells and count as 0) and
    /// the counts of θh, θd and φd.
    pub fn new(counts: [usize; 3], cells: Vec<[f64; 3]>) -> Result<Self, ParameterError> {
        let expected = counts.iter().try_fold(1usize, |a, &c| a.checked_mul(c));
        if expected.is_none_or(|e| e == 0 || e != cells.len() || e > 1 << 26) {
            return Err(ParameterError::new(
                "counts",
                format!("{counts:?} for {} cells", cells.len()),
                "three counts whose product is the number of cells, at most 67108864",
            ));
        }
        if let Some(bad) = cells.iter().flatten().find(|v| !v.is_finite()) {
            return Err(ParameterError::new("cells", bad, "finite"));
        }
        let coloured = cells.iter().any(|c| c[0] != c[1] || c[0] != c[2]);
        Ok(Self {
            counts,
            cells,
            coloured,
        })
    }

    /// From the bytes of a MERL file.
    pub fn from_merl(bytes: &[u8]) -> Result<Self, ParameterError> {
        let wrong = |what: String| {
            ParameterError::new("file", what, "a MERL table: three counts and three planes")
        };
        if bytes.len() < 12 {
            return Err(wrong(format!("{} bytes", bytes.len())));
        }
        let count = |i: usize| {
            let b = [
                bytes[4 * i],
                bytes[4 * i + 1],
                bytes[4 * i + 2],
                bytes[4 * i + 3],
            ];
            usize::try_from(i32::from_le_bytes(b)).unwrap_or(0)
        };
        let counts = [count(0), count(1), count(2)];
        let n = counts
            .iter()
            .try_fold(1usize, |a, &c| a.checked_mul(c))
            .unwrap_or(0);
        if n == 0 || n > 1 << 26 || bytes.len() != 12 + 24 * n {
            return Err(wrong(format!(
                "{} bytes for counts {counts:?}",
                bytes.len()
            )));
        }
        let value = |plane: usize, i: usize| {
            let at = 12 + 8 * (plane * n + i);
            let mut b = [0; 8];
            b.copy_from_slice(&bytes[at..at + 8]);
            f64::from_le_bytes(b) * SCALES[plane]
        };
        let cells = (0..n).map(|i| [0, 1, 2].map(|p| value(p, i))).collect();
        Self::new(counts, cells)
    }

    /// The bytes of a MERL file that holds this table.
    pub fn to_merl(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(12 + 24 * self.cells.len());
        for c in self.counts {
            bytes.extend((c as i32).to_le_bytes());
        }
        for (plane, scale) in SCALES.iter().enumerate() {
            for cell in &self.cells {
                bytes.extend((cell[plane] / scale).to_le_bytes());
            }
        }
        bytes
    }

    /// The table of any model, for tests and conversions: each cell at its centre.
    pub fn tabulate<B: Brdf + ?Sized>(
        brdf: &B,
        counts: [usize; 3],
    ) -> Result<Self, ParameterError> {
        let [nh, nd, np] = counts;
        let mut cells = Vec::with_capacity(nh * nd * np);
        for ih in 0..nh {
            let root = (ih as f64 + 0.5) / nh as f64;
            let theta_h = FRAC_PI_2 * root * root;
            for id in 0..nd {
                let theta_d = FRAC_PI_2 * (id as f64 + 0.5) / nd as f64;
                for ip in 0..np {
                    let phi_d = PI * (ip as f64 + 0.5) / np as f64;
                    let (l, v) = from_difference(theta_h, theta_d, phi_d);
                    cells.push(brdf.eval_rgb(&l, &v));
                }
            }
        }
        Self::new(counts, cells)
    }

    fn index(&self, l: &Direction, v: &Direction) -> usize {
        let [nh, nd, np] = self.counts;
        let (theta_h, theta_d, phi_d) = to_difference(l, v);
        let cell = |x: f64, n: usize| ((x * n as f64) as usize).min(n - 1);
        let ih = cell((theta_h / FRAC_PI_2).max(0.0).sqrt(), nh);
        let id = cell(theta_d / FRAC_PI_2, nd);
        let ip = cell(phi_d / PI, np);
        ip + np * (id + nd * ih)
    }
}

/// θh, θd and φd (0 … π) of a pair, the same for (L, V) and (V, L).
fn to_difference(l: &Direction, v: &Direction) -> (f64, f64, f64) {
    // The same order for both, so that rounding can't tell them apart.
    let (a, b) = if (l.x, l.y, l.z) <= (v.x, v.y, v.z) {
        (l, v)
    } else {
        (v, l)
    };
    let h = Direction::new(a.x + b.x, a.y + b.y, a.z + b.z).normalised();
    let sine = h.x.hypot(h.y);
    let theta_h = sine.atan2(h.z);
    let (c, s) = if sine > 0.0 {
        (h.x / sine, h.y / sine)
    } else {
        (1.0, 0.0)
    };
    // Rows of the rotation that takes H to +z.
    let d = Direction::new(
        a.x * c * h.z + a.y * s * h.z - a.z * sine,
        -a.x * s + a.y * c,
        a.dot(h),
    );
    let theta_d = d.x.hypot(d.y).atan2(d.z);
    let mut phi_d = d.y.atan2(d.x);
    if phi_d < 0.0 {
        phi_d += PI;
    }
    (theta_h, theta_d, phi_d)
}

/// A pair with the given difference angles, H in the plane y = 0.
fn from_difference(theta_h: f64, theta_d: f64, phi_d: f64) -> (Direction, Direction) {
    let rotate = |d: Direction| {
        let (s, c) = theta_h.sin_cos();
        Direction::new(c * d.x + s * d.z, d.y, c * d.z - s * d.x)
    };
    let d = Direction::from_angles(theta_d, phi_d);
    (rotate(d), rotate(Direction::new(-d.x, -d.y, d.z)))
}

impl Brdf for MeasuredHalfAngle {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.coloured { luminance(f) } else { f[0] }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        self.cells[self.index(l, v)].map(|f| f.max(0.0))
    }

    fn is_coloured(&self) -> bool {
        self.coloured
    }

    fn is_isotropic(&self) -> bool {
        // Only under rotation: a table need not be symmetric in the sign of φd.
        false
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "measured_half_angle",
    source: "slides; Matusik et al. 2003, BRDFRead",
    formula: "table over √θh, θd, φd",
    parameters: "a file in the MERL layout",
    reciprocal: true,
    grazing: "as measured",
    examples: || {
        let blinn = Blinn::new(10.0).expect("in range");
        let blinn = Mixed::new(vec![(0.9, Box::new(blinn))]).expect("in range");
        vec![example(
            "a table of 0.9 × Blinn, n = 10, 30 × 10 × 4",
            MeasuredHalfAngle::tabulate(&blinn, [30, 10, 4]).expect("a small table"),
            Conserves,
        )]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Blinn;

    #[test]
    fn difference_angles_invert() {
        for (h, d, p) in [(0.2, 0.7, 0.4), (0.9, 0.3, 2.9), (0.05, 1.2, 1.5)] {
            let (l, v) = from_difference(h, d, p);
            let (h2, d2, p2) = to_difference(&l, &v);
            assert!((h - h2).abs() < 1e-12 && (d - d2).abs() < 1e-12 && (p - p2).abs() < 1e-9);
            assert_eq!(to_difference(&l, &v), to_difference(&v, &l));
        }
    }

    #[test]
    fn a_table_goes_through_its_file() {
        let blinn = Blinn::new(30.0).unwrap();
        let table = MeasuredHalfAngle::tabulate(&blinn, [90, 9, 18]).unwrap();
        let back = MeasuredHalfAngle::from_merl(&table.to_merl()).unwrap();
        let (l, v) = (
            Direction::from_degrees(30.0, 5.0),
            Direction::from_degrees(42.0, 190.0),
        );
        for i in 0..3 {
            let (a, b) = (table.eval_rgb(&l, &v)[i], back.eval_rgb(&l, &v)[i]);
            assert!((a / b - 1.0).abs() < 1e-14);
        }
        // 90 cells of √θh: the nearest is within half a cell of the exact value.
        let (a, b) = (table.eval(&l, &v), blinn.eval(&l, &v));
        assert!((a / b - 1.0).abs() < 0.05, "{a} {b}");
        assert_eq!(table.eval_rgb(&l, &v), table.eval_rgb(&v, &l));
    }

    #[test]
    fn broken_files_are_refused() {
        assert!(MeasuredHalfAngle::from_merl(&[1, 2, 3]).is_err());
        let mut bytes = Vec::new();
        for c in [90i32, 90, 180] {
            bytes.extend(c.to_le_bytes());
        }
        bytes.extend([0; 100]);
        assert!(MeasuredHalfAngle::from_merl(&bytes).is_err());
        assert!(MeasuredHalfAngle::new([1, 1, 2], vec![[0.0; 3]]).is_err());
    }
}
