//! The inverse of a distribution function that is known by its density alone (4.28).

use crate::quadrature::{Estimate, adaptive};

/// A cell is halved at most so often: beyond, a jump or a pole is inside.
const HALVINGS: u32 = 40;

/// Most steps towards a root, which take three as a rule: enough for bisection alone.
const ROUNDS: u32 = 60;

/// The integral of a density in cells, each fine enough for one rule of quadrature.
///
/// Not a table to interpolate in: within its cell the integral is formed anew, so that what
/// is drawn has the density itself, to about 1e-12 of the total.
pub struct Inverse<'a> {
    density: Box<dyn Fn(f64) -> f64 + 'a>,
    edges: Vec<f64>,
    /// The integral up to each edge.
    sums: Vec<f64>,
}

impl<'a> Inverse<'a> {
    /// `density` is not negative between the first and the last of `breaks` (ascending).
    pub fn new(density: Box<dyn Fn(f64) -> f64 + 'a>, breaks: &[f64]) -> Self {
        let tolerance = breaks
            .windows(2)
            .map(|w| 1e-13 * cell(&density, w[0], w[1]).value)
            .sum::<f64>();
        let mut inverse = Self {
            density,
            edges: vec![breaks[0]],
            sums: vec![0.0],
        };
        for w in breaks.windows(2) {
            inverse.add(w[0], w[1], tolerance, HALVINGS);
        }
        inverse
    }

    fn add(&mut self, low: f64, high: f64, tolerance: f64, halvings: u32) {
        let e = cell(&self.density, low, high);
        if e.error > tolerance && halvings > 0 {
            let middle = 0.5 * (low + high);
            self.add(low, middle, tolerance, halvings - 1);
            self.add(middle, high, tolerance, halvings - 1);
        } else {
            self.edges.push(high);
            self.sums.push(self.total() + e.value);
        }
    }

    /// The integral over all of the range.
    pub fn total(&self) -> f64 {
        *self.sums.last().expect("never empty")
    }

    /// Where the integral from the lower end reaches `mass`, 0 … [`Self::total`].
    pub fn at(&self, mass: f64) -> f64 {
        let last = self.edges.len() - 1;
        let i = self.sums.partition_point(|s| *s <= mass).clamp(1, last);
        let (mut low, mut high) = (self.edges[i - 1], self.edges[i]);
        let (from, whole) = (low, self.sums[i] - self.sums[i - 1]);
        let rest = (mass - self.sums[i - 1]).clamp(0.0, whole);
        // Newton's method, and bisection where that leaves the bracket.
        let mut x = low + (high - low) * (rest / whole.max(f64::MIN_POSITIVE)).min(1.0);
        for _ in 0..ROUNDS {
            let excess = cell(&self.density, from, x).value - rest;
            if excess.abs() <= 1e-15 * self.total() {
                break;
            }
            if excess > 0.0 {
                high = x;
            } else {
                low = x;
            }
            let newton = x - excess / (self.density)(x);
            x = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
        }
        x
    }
}

fn cell(density: &dyn Fn(f64) -> f64, low: f64, high: f64) -> Estimate {
    let mut f = |x| Estimate {
        value: density(x),
        error: 0.0,
    };
    adaptive(&mut f, &[low, high], 0.0, 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_forms_are_inverted() {
        let cubic = Inverse::new(Box::new(|x: f64| 3.0 * x * x), &[0.0, 2.0]);
        let sharp = Inverse::new(Box::new(|x: f64| 1e4 * (-1e4 * x).exp()), &[0.0, 2.0]);
        assert!((cubic.total() - 8.0).abs() < 1e-12 && (sharp.total() - 1.0).abs() < 1e-12);
        for u in [1e-9, 0.1, 0.5, 0.99] {
            assert!((cubic.at(8.0 * u) - 2.0 * u.cbrt()).abs() < 1e-11, "{u}");
            let expected = -(-u).ln_1p() * 1e-4;
            assert!((sharp.at(u) / expected - 1.0).abs() < 1e-9, "{u}");
        }
    }

    #[test]
    fn jumps_are_found() {
        let step = Inverse::new(
            Box::new(|x: f64| if x < 0.3 { 2.0 } else { 0.0 }),
            &[0.0, 2.0],
        );
        assert!((step.total() - 0.6).abs() < 1e-11);
        assert!((step.at(0.3) - 0.15).abs() < 1e-11);
    }
}
