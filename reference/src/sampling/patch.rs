//! Sampling of the basic patch (4.2.4): uniform points common to two circles.

use super::cosine::{disc, lifted};
use super::{Sampled, Sampler};
use crate::Direction;
use crate::models::patch::lens_area;
use std::f64::consts::PI;

/// What happens to a point of the smaller circle that misses the larger one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatchMethod {
    /// Another one is drawn: all weights are a_R(V).
    Rejection,
    /// The sample is rejected: all weights are 1.
    Roulette,
}

/// Directions of a basic patch of radius R about R of V, or about V (retro-reflective).
pub struct PatchDisc {
    centre: (f64, f64),
    radius: f64,
    method: PatchMethod,
    /// The lens area and that of the smaller circle.
    area: f64,
    whole: f64,
}

impl PatchDisc {
    /// For the radius (0 … 2) of a [`crate::models::Patch`].
    pub fn new(radius: f64, v: Direction, method: PatchMethod) -> Self {
        Self::about((-v.x, -v.y), radius, v.z, method)
    }

    /// For the radius of a [`crate::models::PatchRetro`].
    pub fn retro(radius: f64, v: Direction, method: PatchMethod) -> Self {
        Self::about((v.x, v.y), radius, v.z, method)
    }

    fn about(centre: (f64, f64), radius: f64, cos: f64, method: PatchMethod) -> Self {
        Self {
            centre,
            radius,
            method,
            area: lens_area(radius, cos),
            whole: PI * (radius * radius).min(1.0),
        }
    }

    /// The albedo a_R(V).
    pub fn albedo(&self) -> f64 {
        self.area / self.whole
    }

    fn in_patch(&self, x: f64, y: f64) -> bool {
        let (dx, dy) = (x - self.centre.0, y - self.centre.1);
        dx * dx + dy * dy <= self.radius * self.radius
    }

    /// One try: a point of the smaller circle, if it is in the larger one.
    pub(super) fn attempt(&self, random: &mut dyn FnMut() -> f64) -> Option<Direction> {
        let (x, y, inside) = if self.radius < 1.0 {
            let (dx, dy) = disc(self.radius, random);
            let (x, y) = (self.centre.0 + dx, self.centre.1 + dy);
            (x, y, x * x + y * y <= 1.0)
        } else {
            let (x, y) = disc(1.0, random);
            (x, y, self.in_patch(x, y))
        };
        inside.then(|| lifted(x, y))
    }
}

impl Sampler for PatchDisc {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        match self.method {
            PatchMethod::Rejection => loop {
                if let Some(direction) = self.attempt(random) {
                    return Some(Sampled::spread(direction, [self.albedo(); 3]));
                }
            },
            PatchMethod::Roulette => {
                let direction = self.attempt(random)?;
                Some(Sampled::spread(direction, [1.0; 3]))
            }
        }
    }

    fn pdf(&self, l: &Direction) -> f64 {
        if l.z < 0.0 || !self.in_patch(l.x, l.y) {
            return 0.0;
        }
        match self.method {
            PatchMethod::Rejection => l.z / self.area,
            PatchMethod::Roulette => l.z / self.whole,
        }
    }
}
