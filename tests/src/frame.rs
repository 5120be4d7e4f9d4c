//! Random frames: the same pair of directions with any normal.

use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::domain::Pair;

/// A seeded sequence of rotations.
pub struct Rotations(Pcg64Mcg);

impl Rotations {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// Uniform in (−1, 1).
    fn coordinate(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// N, L and V of a pair that was given in the shading frame, turned by a
    /// random rotation: a unit quaternion, uniform.
    pub fn turn(&mut self, [l, v]: Pair) -> [[f64; 3]; 3] {
        let mut q = [0.0; 4];
        let mut square = 0.0;
        while !(0.01..=1.0).contains(&square) {
            q = q.map(|_| self.coordinate());
            square = q.iter().map(|c| c * c).sum();
        }
        let length = f64::sqrt(square);
        let [w, x, y, z] = q.map(|c| c / length);
        let rows = [
            [
                1.0 - 2.0 * (y * y + z * z),
                2.0 * (x * y - z * w),
                2.0 * (x * z + y * w),
            ],
            [
                2.0 * (x * y + z * w),
                1.0 - 2.0 * (x * x + z * z),
                2.0 * (y * z - x * w),
            ],
            [
                2.0 * (x * z - y * w),
                2.0 * (y * z + x * w),
                1.0 - 2.0 * (x * x + y * y),
            ],
        ];
        [[0.0, 0.0, 1.0], l, v]
            .map(|a| rows.map(|row| row[0] * a[0] + row[1] * a[1] + row[2] * a[2]))
    }
}

/// L and V in a shading frame whose third axis is N.
pub fn in_frame(n: [f64; 3], l: [f64; 3], v: [f64; 3]) -> Pair {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let unit = |a: [f64; 3]| a.map(|c| c / dot(a, a).sqrt());
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let n = unit(n);
    // Any axis that is not nearly along N.
    let least = if n[0].abs() < 0.6 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let tangent = unit(cross(least, n));
    let bitangent = cross(n, tangent);
    [l, v].map(|a| [dot(tangent, a), dot(bitangent, a), dot(n, a)])
}
