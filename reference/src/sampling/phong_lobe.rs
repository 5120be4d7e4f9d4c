//! Sampling of Phong's lobe (3.19 to 3.26).

use super::{Sampled, Sampler};
use crate::geometry::{power_lobe, retro_versine};
use crate::{Brdf, Direction};
use std::f64::consts::TAU;

/// Directions with the density (n + 1)/2π cosⁿα about R of V, V itself or a weighted V.
///
/// What falls below the horizon is rejected: half of the lobe at 90°. The weight of a
/// metallic Phong sample is (n + 2)/(n + 1) · cosΘL/max(cosΘL, cosΘV) (3.26).
pub struct PhongLobe<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
    exponent: f64,
    axis: Direction,
}

impl<'a> PhongLobe<'a> {
    /// For a model whose lobe is cosⁿα about R of V.
    pub fn new(brdf: &'a dyn Brdf, exponent: f64, v: Direction) -> Self {
        Self::about(brdf, exponent, v, v.mirrored())
    }

    /// For a retro-reflective model, about V.
    pub fn retro(brdf: &'a dyn Brdf, exponent: f64, v: Direction) -> Self {
        Self::about(brdf, exponent, v, v)
    }

    /// For a lobe [(wx LxVx + wy LyVy + wz LzVz)⁺]ⁿ (1.66, 3.14): it is cosⁿ of the angle
    /// to (wx Vx, wy Vy, wz Vz), as high as that vector is long.
    pub fn weighted(brdf: &'a dyn Brdf, weights: [f64; 3], exponent: f64, v: Direction) -> Self {
        let [x, y, z] = weights;
        let axis = Direction::new(x * v.x, y * v.y, z * v.z).normalised();
        Self::about(brdf, exponent, v, axis)
    }

    fn about(brdf: &'a dyn Brdf, exponent: f64, v: Direction, axis: Direction) -> Self {
        Self {
            brdf,
            v,
            exponent,
            axis,
        }
    }

    /// The drawn direction, also below the horizon.
    fn draw(&self, random: &mut dyn FnMut() -> f64) -> Direction {
        // x = 1 − u^(1/(n+1)) without cancellation; 1 − random() is never 0.
        let x = -((1.0 - random()).ln() / (self.exponent + 1.0)).exp_m1();
        let sine = (x * (2.0 - x)).max(0.0).sqrt();
        let phi = TAU * random();
        around(self.axis, x, sine, phi)
    }
}

/// The direction at versine x (and its sine) from an axis, azimuth φ about it; φ = 0 is
/// away from the normal.
pub(super) fn around(axis: Direction, x: f64, sine: f64, phi: f64) -> Direction {
    let s = axis.x.hypot(axis.y);
    // At the normal any azimuth will do.
    let (cx, cy) = if s > 0.0 {
        (axis.x / s, axis.y / s)
    } else {
        (1.0, 0.0)
    };
    let (u, w) = (sine * phi.cos(), sine * phi.sin());
    let along = s * (1.0 - x) + axis.z * u;
    Direction::new(
        along * cx - w * cy,
        along * cy + w * cx,
        axis.z * (1.0 - x) - s * u,
    )
}

impl Sampler for PhongLobe<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        let direction = self.draw(random);
        if direction.z < 0.0 {
            return None;
        }
        let pdf = self.pdf(&direction);
        let reflect = self.brdf.reflect(&direction, &self.v);
        let weight = reflect.map(|r| if r == 0.0 { 0.0 } else { r / pdf });
        Some(Sampled::spread(direction, weight))
    }

    fn pdf(&self, l: &Direction) -> f64 {
        if l.z < 0.0 {
            return 0.0;
        }
        let x = retro_versine(l, &self.axis);
        (self.exponent + 1.0) / TAU * power_lobe(self.exponent, x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::versine;
    use crate::models::{Energy, MetallicPhong};
    use crate::sampling::Random;

    #[test]
    fn weights_are_as_printed() {
        let n = 60.0;
        let m = MetallicPhong::new(n, Energy::Published).unwrap();
        let v = Direction::from_degrees(75.0, 30.0);
        let s = PhongLobe::new(&m, n, v);
        let mut random = Random::new(1);
        for _ in 0..1000 {
            if let Some(d) = s.sample(&mut || random.uniform()) {
                let ratio = d.direction.z / d.direction.z.max(v.z);
                let expected = (n + 2.0) / (n + 1.0) * ratio;
                assert!((d.weight[0] / expected - 1.0).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn a_sharp_lobe_has_many_cosines() {
        // u^(1/(n+1)) in f32 would give three distinct values at n = 1e8.
        let m = MetallicPhong::new(1e8, Energy::Published).unwrap();
        let v = Direction::from_degrees(30.0, 0.0);
        let s = PhongLobe::new(&m, 1e8, v);
        let mut random = Random::new(2);
        let mut versines: Vec<u64> = (0..200)
            .map(|_| versine(&s.draw(&mut || random.uniform()), &v).to_bits())
            .collect();
        versines.sort_unstable();
        versines.dedup();
        assert!(versines.len() > 190);
    }
}
