//! The grid of angles on which the albedo is iterated: entries, weights, interpolation.

use crate::Direction;
use std::f64::consts::FRAC_PI_2;

/// Adds the weights of Gregory's rule of fourth order for the entries `from` … `to`.
pub(super) fn add_gregory(weights: &mut [f64], from: usize, to: usize) {
    if from == to {
        return;
    }
    for w in &mut weights[from..=to] {
        *w += 1.0;
    }
    if to == from + 1 {
        weights[from] -= 0.5;
        weights[to] -= 0.5;
        return;
    }
    for (k, correction) in [-5.0 / 8.0, 1.0 / 6.0, -1.0 / 24.0].into_iter().enumerate() {
        weights[from + k] += correction;
        weights[to - k] += correction;
    }
}

/// 90° less the angle of entry i: the entries crowd quadratically towards the horizon,
/// where the albedo of a model that was pumped often has a boundary layer.
pub(super) fn elevation(i: usize, cells: usize) -> f64 {
    FRAC_PI_2 * (1.0 - i as f64 / cells as f64).powi(2)
}

pub(super) fn cosine(i: usize, cells: usize) -> f64 {
    elevation(i, cells).sin()
}

pub(super) fn sine(i: usize, cells: usize) -> f64 {
    elevation(i, cells).cos()
}

pub(super) fn node(i: usize, cells: usize, phi: f64) -> Direction {
    let s = sine(i, cells);
    Direction::new(s * phi.cos(), s * phi.sin(), cosine(i, cells))
}

/// Catmull–Rom interpolation at an elevation of 0 … π/2.
pub(super) fn read(table: &[f64], elevation: f64) -> f64 {
    let last = table.len() - 1;
    let x = (1.0 - (elevation / FRAC_PI_2).max(0.0).sqrt()) * last as f64;
    let x = x.clamp(0.0, last as f64);
    let i = (x as usize).min(last - 1);
    let t = x - i as f64;
    let at = |k: isize| table[(i as isize + k).clamp(0, last as isize) as usize];
    let (a, b) = (at(0), at(1));
    let before = if i == 0 { 2.0 * a - b } else { at(-1) };
    let after = if i + 1 == last { 2.0 * b - a } else { at(2) };
    let (da, db) = (0.5 * (b - before), 0.5 * (after - a));
    let (t2, t3) = (t * t, t * t * t);
    a * (2.0 * t3 - 3.0 * t2 + 1.0)
        + da * (t3 - 2.0 * t2 + t)
        + b * (3.0 * t2 - 2.0 * t3)
        + db * (t3 - t2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_read_back_and_a_cubic_between_them() {
        let cells = 40;
        let of_entry = |x: f64| 0.3 + 0.5 * x - 0.2 * x * x;
        let table: Vec<f64> = (0..=cells)
            .map(|i| of_entry(i as f64 / cells as f64))
            .collect();
        for i in 1..cells {
            assert!((read(&table, elevation(i, cells)) - table[i]).abs() < 1e-13);
            let x = (i as f64 + 0.4) / cells as f64;
            let between = FRAC_PI_2 * (1.0 - x).powi(2);
            // A parabola is met exactly where both neighbours are there.
            if i + 2 <= cells {
                assert!((read(&table, between) - of_entry(x)).abs() < 1e-13, "{i}");
            }
        }
    }

    #[test]
    fn gregorys_weights_integrate_a_cubic() {
        let mut weights = vec![0.0; 21];
        add_gregory(&mut weights, 0, 20);
        let sum: f64 = (weights.iter().enumerate())
            .map(|(i, w)| w * (i as f64).powi(3))
            .sum();
        assert!((sum / (20f64.powi(4) / 4.0) - 1.0).abs() < 1e-12, "{sum}");
    }
}
