//! Sampling of the elliptic patch: points of a circle, stretched (4.5.4).

use super::cosine::{disc, lifted};
use super::{Sampled, Sampler};
use crate::models::PatchElliptic;
use crate::quadrature::Accuracy;
use crate::{Brdf, Direction, albedo};

/// Uniform points of the smaller of ellipse and base circle, drawn again until they are in
/// the other: all weights are the albedo.
pub struct Elliptic {
    a: f64,
    b: f64,
    centre: (f64, f64),
    albedo: f64,
    model: PatchElliptic,
    v: Direction,
}

impl Elliptic {
    /// Finds a(V) by quadrature.
    pub fn new(model: PatchElliptic, v: Direction) -> Self {
        Self {
            a: model.a(),
            b: model.b(),
            centre: (-v.x, -v.y),
            albedo: albedo::directional_albedo_for(&model, &v, Accuracy::FINE).value,
            model,
            v,
        }
    }
}

impl Sampler for Elliptic {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        loop {
            let (x, y, inside) = if self.a * self.b < 1.0 {
                let (x, y) = disc(1.0, random);
                let (x, y) = (self.centre.0 + self.a * x, self.centre.1 + self.b * y);
                (x, y, x * x + y * y <= 1.0)
            } else {
                let (x, y) = disc(1.0, random);
                let (u, w) = ((x - self.centre.0) / self.a, (y - self.centre.1) / self.b);
                (x, y, u * u + w * w <= 1.0)
            };
            if inside {
                return Some(Sampled {
                    direction: lifted(x, y),
                    weight: [self.albedo; 3],
                });
            }
        }
    }

    fn pdf(&self, l: &Direction) -> f64 {
        self.model.eval(l, &self.v) * l.z / self.albedo
    }
}
