//! Measured metals: the complex index over wavelength, and the colour that follows.

use super::observer::Observer;
use crate::fresnel::conductor;
use std::sync::OnceLock;

const DATA: &str = include_str!("../../data/metals.csv");

/// A metal whose spectrum is in `data/metals.csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MetalName {
    /// Gold.
    Gold,
    /// Silver.
    Silver,
    /// Copper.
    Copper,
    /// Aluminium.
    Aluminium,
}

impl MetalName {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Gold, Self::Silver, Self::Copper, Self::Aluminium];

    /// The name in the data and in material files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gold => "gold",
            Self::Silver => "silver",
            Self::Copper => "copper",
            Self::Aluminium => "aluminium",
        }
    }
}

impl std::str::FromStr for MetalName {
    type Err = crate::ParameterError;
    fn from_str(s: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|m| m.name() == s)
            .ok_or_else(|| {
                crate::ParameterError::new("metal", s, "gold, silver, copper or aluminium")
            })
    }
}

/// Rows of wavelength in nm, η and k, by ascending wavelength.
fn rows(metal: MetalName) -> &'static [[f64; 3]] {
    static ROWS: OnceLock<[Vec<[f64; 3]>; 4]> = OnceLock::new();
    let all = ROWS.get_or_init(|| {
        MetalName::ALL.map(|metal| {
            DATA.lines()
                .filter_map(|line| line.split_once(','))
                .filter(|(name, _)| *name == metal.name())
                .map(|(_, rest)| {
                    let mut numbers = rest
                        .split(',')
                        .map(|t| t.trim().parse().expect("a number in metals.csv"));
                    [0; 3].map(|_| numbers.next().expect("three numbers in metals.csv"))
                })
                .collect()
        })
    });
    &all[metal as usize]
}

/// η and k at a wavelength in nm, linear between the measured ones, and held beyond them.
pub fn metal_index(metal: MetalName, nm: f64) -> (f64, f64) {
    let rows = rows(metal);
    let after = rows.partition_point(|r| r[0] < nm);
    if after == 0 {
        return (rows[0][1], rows[0][2]);
    }
    let Some(b) = rows.get(after) else {
        let last = rows[rows.len() - 1];
        return (last[1], last[2]);
    };
    let a = rows[after - 1];
    let t = (nm - a[0]) / (b[0] - a[0]);
    (a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))
}

/// The colour of a smooth metal at `cos_theta` (0 … 1) from the normal: its spectral
/// Fresnel reflectance under D65 as linear sRGB, white being (1, 1, 1).
///
/// Not clipped: a saturated metal can lie outside sRGB, with a channel above 1 or below 0
/// (the four here stay inside, tested). [`super::to_gamut`] is the gamut map for pictures.
pub fn metal_rgb(metal: MetalName, cos_theta: f64) -> [f64; 3] {
    Observer::standard().colour(&|nm| {
        let (eta, k) = metal_index(metal, nm);
        conductor(eta, k, cos_theta)
    })
}

/// [`metal_rgb`] as polynomials, for use inside integrals.
///
/// Chebyshev interpolation of degree 13 in √cosΘ, in 8 cells, at exactly computed nodes;
/// it differs from [`metal_rgb`] by less than 1e-12 for the metals here (tested). Cells are
/// even in √cosΘ since towards grazing a metal's reflectance bends the more.
#[derive(Debug, Clone, PartialEq)]
pub struct FresnelCurve {
    cells: Vec<[[f64; 3]; Self::TERMS]>,
}

impl FresnelCurve {
    const CELLS: usize = 8;
    const TERMS: usize = 14;

    /// The curve of a metal.
    pub fn of_metal(metal: MetalName) -> Self {
        static CURVES: [OnceLock<FresnelCurve>; 4] = [const { OnceLock::new() }; 4];
        CURVES[metal as usize]
            .get_or_init(|| Self::new(&|c| metal_rgb(metal, c)))
            .clone()
    }

    /// The interpolant of any smooth function of the cosine.
    pub fn new(f: &dyn Fn(f64) -> [f64; 3]) -> Self {
        let cells = (0..Self::CELLS).map(|cell| {
            // x runs from −1 to 1 in the cell.
            interpolant(&|x| {
                let root = (cell as f64 + 0.5 + 0.5 * x) / Self::CELLS as f64;
                f(root * root)
            })
        });
        Self {
            cells: cells.collect(),
        }
    }

    /// The value at a cosine (clamped to 0 … 1), by Clenshaw's recurrence.
    pub fn at(&self, cos_theta: f64) -> [f64; 3] {
        let place = cos_theta.clamp(0.0, 1.0).sqrt() * Self::CELLS as f64;
        let cell = (place as usize).min(Self::CELLS - 1);
        let x = 2.0 * (place - cell as f64) - 1.0;
        let coefficients = &self.cells[cell];
        let (mut b1, mut b2) = ([0.0; 3], [0.0; 3]);
        for c in coefficients[1..].iter().rev() {
            let b0 = [0, 1, 2].map(|i| (c[i] - b2[i]) + 2.0 * x * b1[i]);
            (b1, b2) = (b0, b1);
        }
        [0, 1, 2].map(|i| (coefficients[0][i] - b2[i]) + x * b1[i])
    }
}

/// Chebyshev coefficients of the interpolant of `f` over −1 … 1 at as many roots.
fn interpolant<const TERMS: usize>(f: &dyn Fn(f64) -> [f64; 3]) -> [[f64; 3]; TERMS] {
    let angle = |j: usize| std::f64::consts::PI * (j as f64 + 0.5) / TERMS as f64;
    let samples: [_; TERMS] = std::array::from_fn(|j| f(angle(j).cos()));
    std::array::from_fn(|k| {
        let mut sum = [0.0; 3];
        for (j, s) in samples.iter().enumerate() {
            let t = (k as f64 * angle(j)).cos();
            for (a, b) in sum.iter_mut().zip(s) {
                *a += t * b;
            }
        }
        let scale = if k == 0 { 1.0 } else { 2.0 } / TERMS as f64;
        sum.map(|s| s * scale)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_follows_the_exact_colour() {
        for metal in MetalName::ALL {
            let curve = FresnelCurve::of_metal(metal);
            for i in 0..=200 {
                let c = (f64::from(i) / 200.0).powi(3);
                let (a, b) = (curve.at(c), metal_rgb(metal, c));
                for k in 0..3 {
                    assert!((a[k] - b[k]).abs() < 1e-12, "{metal:?} {c}: {a:?} {b:?}");
                }
            }
        }
    }

    #[test]
    fn data_are_read_and_held_beyond_their_ends() {
        assert_eq!(metal_index(MetalName::Gold, 563.5), (0.613, 2.64));
        assert_eq!(metal_index(MetalName::Copper, 780.0), (0.215, 3.86));
        assert_eq!(metal_index(MetalName::Silver, 300.0), (0.211, 1.42));
        let (eta, k) = metal_index(MetalName::Aluminium, 454.6);
        assert!((eta - 0.6595).abs() < 1e-3 && (k - 5.455).abs() < 1e-3);
    }

    #[test]
    fn colours_are_the_metals_own() {
        let [r, g, b] = metal_rgb(MetalName::Gold, 1.0);
        assert!(r > 0.9 && r > g && g > b, "{r} {g} {b}");
        let [r, g, b] = metal_rgb(MetalName::Copper, 1.0);
        assert!(r > g && g > b, "{r} {g} {b}");
        let s = metal_rgb(MetalName::Silver, 1.0);
        assert!(s.iter().all(|c| *c > 0.85 && *c < 1.0), "{s:?}");
        for metal in MetalName::ALL {
            assert!(
                metal_rgb(metal, 0.0)
                    .iter()
                    .all(|c| (c - 1.0).abs() < 1e-13)
            );
        }
    }
}
