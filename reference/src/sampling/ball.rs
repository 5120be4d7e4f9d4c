//! Uniform points of a patch in any metric (4.2.4, 4.5.4), and sampling of the basic patches.

use super::cosine::{disc, lifted};
use super::{Sampled, Sampler};
use crate::models::Metric;
use crate::quadrature::Accuracy;
use crate::{Brdf, Direction, albedo};
use std::f64::consts::PI;

/// The points within a distance of the centre that V gives, in any metric.
#[derive(Debug, Clone, Copy)]
pub struct Ball {
    metric: Metric,
    radius: f64,
    centre: (f64, f64),
}

impl Ball {
    /// About R of V, or about V for a retro-reflective metric; radius above 0.
    pub fn new(metric: Metric, radius: f64, v: Direction) -> Self {
        let side = if metric.is_retro() { 1.0 } else { -1.0 };
        Self {
            metric,
            radius,
            centre: (side * v.x, side * v.y),
        }
    }

    /// One try: a point of the smaller of ball and base circle, if it is in the other.
    pub fn attempt(&self, random: &mut dyn FnMut() -> f64) -> Option<Direction> {
        let (x, y, inside);
        if self.metric.unit_area() * self.radius * self.radius < PI {
            let (dx, dy) = unit_point(self.metric, random);
            x = self.centre.0 + self.radius * dx;
            y = self.centre.1 + self.radius * dy;
            inside = x * x + y * y <= 1.0;
        } else {
            (x, y) = disc(1.0, random);
            let (dx, dy) = (x - self.centre.0, y - self.centre.1);
            inside = self.metric.length(dx, dy) <= self.radius;
        }
        inside.then(|| lifted(x, y))
    }
}

/// A uniform point of a metric's unit ball: of a circle, stretched, or of the box around it
/// until it is inside.
fn unit_point(metric: Metric, random: &mut dyn FnMut() -> f64) -> (f64, f64) {
    let (a, b) = metric.unit_axes();
    if metric.is_round() {
        let (x, y) = disc(1.0, random);
        return (a * x, b * y);
    }
    loop {
        let x = a * (2.0 * random() - 1.0);
        let y = b * (2.0 * random() - 1.0);
        if metric.length(x, y) <= 1.0 {
            return (x, y);
        }
    }
}

/// Directions of a basic patch in any metric, drawn again until one is inside: all weights
/// are the albedo.
pub struct MetricPatch<'a> {
    brdf: &'a dyn Brdf,
    v: Direction,
    ball: Ball,
    albedo: f64,
}

impl<'a> MetricPatch<'a> {
    /// For a model that is constant in the ball and 0 outside; finds a(V) by quadrature.
    pub fn new(brdf: &'a dyn Brdf, metric: Metric, radius: f64, v: Direction) -> Self {
        Self {
            brdf,
            v,
            ball: Ball::new(metric, radius, v),
            albedo: albedo::directional_albedo_for(brdf, &v, Accuracy::FINE).value,
        }
    }
}

impl Sampler for MetricPatch<'_> {
    fn sample(&self, random: &mut dyn FnMut() -> f64) -> Option<Sampled> {
        loop {
            if let Some(direction) = self.ball.attempt(random) {
                return Some(Sampled::spread(direction, [self.albedo; 3]));
            }
        }
    }

    fn pdf(&self, l: &Direction) -> f64 {
        self.brdf.eval(l, &self.v) * l.z.max(0.0) / self.albedo
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::Random;

    #[test]
    fn areas_are_those_of_the_points() {
        // The share of a box's points that are in the ball, against the closed form.
        let mut random = Random::new(3);
        for metric in [
            Metric::EUCLIDEAN,
            Metric::elliptic(0.4).unwrap(),
            Metric::power(0.7, 1.0).unwrap(),
            Metric::power(0.7, 4.0).unwrap(),
        ] {
            let (a, b) = metric.unit_axes();
            let n = 200_000;
            let inside = (0..n)
                .filter(|_| {
                    let (x, y) = (2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0);
                    metric.length(a * x, b * y) <= 1.0
                })
                .count();
            let area = 4.0 * a * b * inside as f64 / f64::from(n);
            // Four standard errors.
            let error = 4.0 * 4.0 * a * b * (0.25 / f64::from(n)).sqrt();
            assert!((area - metric.unit_area()).abs() < error, "{metric:?}");
        }
    }
}
