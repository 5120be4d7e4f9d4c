//! Seeded pairs of directions, the same for every arithmetic.

use std::f64::consts::TAU;

use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// L and V in the shading frame.
pub type Pair = [[f64; 3]; 2];

/// A set of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Set {
    /// τ uniform within the lobe, any azimuth about R, log₁₀ of the larger
    /// cosine uniform in [−8, 0].
    Lobe,
    /// Exactly R, and a step beside it.
    Mirror,
    /// One or both cosines from 1e-8 to 1e-2.
    Grazing,
    /// Uniform on both hemispheres.
    Random,
    /// Below the horizon, or beyond the lobe.
    Outside,
}

impl Set {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Lobe,
        Self::Mirror,
        Self::Grazing,
        Self::Random,
        Self::Outside,
    ];

    /// `count` pairs for a lobe in which τ = n·x reaches `reach`.
    pub fn pairs(self, n: f64, reach: f64, count: usize) -> Vec<Pair> {
        let mut random = Random(Pcg64Mcg::seed_from_u64(0x5EED + self as u64));
        (0..count)
            .map(|index| random.pair(self, n, reach, index))
            .collect()
    }
}

struct Random(Pcg64Mcg);

impl Random {
    /// Uniform in [0, 1).
    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn pair(&mut self, set: Set, n: f64, reach: f64, index: usize) -> Pair {
        match set {
            Set::Lobe => {
                let cosine = 10f64.powf(-8.0 * self.unit());
                let x = (reach * self.unit() / n.max(1e-9)).min(0.999 * self.unit());
                self.about_mirror(cosine, x)
            }
            Set::Mirror => {
                let cosine = 10f64.powf(-8.0 * self.unit());
                // One step of a 32-bit direction moves x by 2⁻⁶¹.
                let x = [0.0, 0.5f64.powi(60), 0.5f64.powi(46)][index % 3];
                self.about_mirror(cosine, x)
            }
            Set::Grazing => {
                let mut low = || 10f64.powf(-2.0 - 6.0 * self.unit());
                let (first, second) = (low(), low());
                let other = if index % 2 == 0 { second } else { self.unit() };
                let spread = TAU / 2.0 + (self.unit() - 0.5) * (2.0 * reach / n.max(1.0)).sqrt();
                let azimuth = TAU * self.unit();
                let pair = [
                    direction(first, azimuth),
                    direction(other, azimuth + spread),
                ];
                self.swapped(pair)
            }
            Set::Random => [
                direction(self.unit(), TAU * self.unit()),
                direction(self.unit(), TAU * self.unit()),
            ],
            Set::Outside => {
                let below = direction(-10f64.powf(-8.0 * self.unit()), TAU * self.unit());
                let above = direction(self.unit(), TAU * self.unit());
                match index % 3 {
                    0 => self.swapped([below, above]),
                    1 => [below, direction(-self.unit(), TAU * self.unit())],
                    _ => {
                        let x = (1.0 + self.unit()) * reach.max(1.0) / n.max(1.0);
                        let cosine = self.unit();
                        self.about_mirror(cosine, x.min(1.9))
                    }
                }
            }
        }
    }

    /// L at a cosine and V with 1 − R·V = x, on the horizon's side where that
    /// lies above it, so that L's cosine is the larger; in either order.
    fn about_mirror(&mut self, cosine: f64, x: f64) -> Pair {
        let azimuth = TAU * self.unit();
        let l = direction(cosine, azimuth);
        let r = [-l[0], -l[1], l[2]];
        let phi = TAU * self.unit();
        let v = turned(r, x, phi);
        let lower = if v[2] > r[2] {
            turned(r, x, phi + TAU / 2.0)
        } else {
            v
        };
        let higher = if v[2] > r[2] {
            v
        } else {
            turned(r, x, phi + TAU / 2.0)
        };
        self.swapped([l, if lower[2] >= 0.0 { lower } else { higher }])
    }

    fn swapped(&mut self, [l, v]: Pair) -> Pair {
        if self.unit() < 0.5 { [l, v] } else { [v, l] }
    }
}

/// The unit vector with a cosine and an azimuth.
pub fn direction(cosine: f64, azimuth: f64) -> [f64; 3] {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
    [sine * azimuth.cos(), sine * azimuth.sin(), cosine]
}

/// The unit vector whose versine from `axis` is `x`, in the azimuth `phi`
/// about it.
pub fn turned(axis: [f64; 3], x: f64, phi: f64) -> [f64; 3] {
    let sine = (x * (2.0 - x)).max(0.0).sqrt();
    let horizontal = axis[0].hypot(axis[1]);
    let (first, second) = if horizontal > 1e-12 {
        let across = [-axis[1] / horizontal, axis[0] / horizontal, 0.0];
        let up = [
            -axis[2] * axis[0] / horizontal,
            -axis[2] * axis[1] / horizontal,
            horizontal,
        ];
        (across, up)
    } else {
        ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    };
    let (s, c) = phi.sin_cos();
    let v = [0, 1, 2].map(|i| axis[i] - x * axis[i] + sine * (c * first[i] + s * second[i]));
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|component| component / length)
}
