//! The nested integral over the hemisphere.

use super::chart::Placed;
use super::{Chart, Estimate, adaptive, find_root};
use crate::Direction;
use std::f64::consts::PI;

/// How far an integral is refined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Absolute error aimed at.
    pub tolerance: f64,
    /// Most halvings of the outer interval.
    pub outer_panels: usize,
    /// Most halvings of an inner one.
    pub inner_panels: usize,
}

impl Accuracy {
    /// 1e-11: where energy is tested.
    pub const FINE: Self = Self {
        tolerance: 1e-11,
        outer_panels: 400,
        inner_panels: 120,
    };
    /// 1e-7: for figures and long tables.
    pub const COARSE: Self = Self {
        tolerance: 1e-7,
        outer_panels: 60,
        inner_panels: 30,
    };
}

/// ∫ f(V) cosΘV dω over the upper hemisphere, with L fixed.
///
/// `creases` appends values that change sign where f is not smooth. With
/// `isotropic` only half of the azimuths is looked at. f is never called below
/// the horizon.
pub fn hemisphere(
    l: &Direction,
    chart: &Chart,
    isotropic: bool,
    accuracy: Accuracy,
    creases: &dyn Fn(&Direction, &mut Vec<f64>),
    f: &dyn Fn(&Direction) -> f64,
) -> Estimate {
    let placed = Placed::new(chart, l);
    let (span, symmetry) = if isotropic {
        (PI, 2.0)
    } else {
        (2.0 * PI, 1.0)
    };
    let grid = if isotropic { 6 } else { 24 };

    let switches = |q: f64, phi: f64, out: &mut Vec<f64>| {
        let point = placed.at(q, phi);
        out.clear();
        out.push(point.above);
        if point.above > 0.0 {
            creases(&point.v, out);
        } else {
            // Below the horizon the creases don't matter: keep their number out of play.
            out.resize(1, 0.0);
        }
    };

    // The azimuths at which something changes, for one radius, ascending.
    let breaks = |q: f64| -> Vec<f64> { azimuth_breaks(q, (0.0, span), grid, &switches) };

    let mut inner = |q: f64| -> Estimate {
        let breaks = breaks(q);
        let mut sum = Estimate::default();
        for w in breaks.windows(2) {
            if w[1] - w[0] <= 0.0 || placed.at(q, 0.5 * (w[0] + w[1])).above < 0.0 {
                continue;
            }
            sum = sum
                + adaptive(
                    &mut |phi| {
                        let point = placed.at(q, phi);
                        if point.above < 0.0 || point.measure == 0.0 {
                            return Estimate::default();
                        }
                        Estimate {
                            value: f(&point.v) * point.measure,
                            error: 0.0,
                        }
                    },
                    w,
                    accuracy.tolerance * 0.05,
                    accuracy.inner_panels,
                );
        }
        sum
    };

    // Radii where the number of breaks changes bend the outer integrand: make them ends too.
    let signature = |q: f64| -> (usize, bool) {
        let b = breaks(q);
        (b.len(), placed.at(q, 0.0).above < 0.0)
    };
    let mut radial = vec![0.0];
    const CELLS: u32 = 32;
    // Keep off q = 1, where an infinite radius has no point.
    let last = 1.0 - 1e-9;
    let mut before = signature(1e-9);
    let mut low = 1e-9;
    for i in 1..=CELLS {
        let high = (f64::from(i) / f64::from(CELLS)).min(last);
        let now = signature(high);
        if now != before {
            radial.push(find_root(
                &mut |q| if signature(q) == before { -1.0 } else { 1.0 },
                low,
                high,
            ));
        }
        before = now;
        low = high;
    }
    radial.extend(chart.edges.iter().filter_map(|&t| placed.q_of_radius(t)));
    radial.push(1.0);
    radial.sort_by(f64::total_cmp);

    adaptive(
        &mut inner,
        &radial,
        accuracy.tolerance,
        accuracy.outer_panels,
    )
    .scaled(symmetry)
}

/// The azimuths within `range` at which a switch changes its sign, with both ends.
///
/// A switch is looked at on a grid that reaches one cell beyond the range. Between
/// neighbours of different sign there is a root; where its size has a least value between
/// three of the same sign it is followed to that value, so that a sliver narrower than a
/// cell is not lost.
fn azimuth_breaks(
    q: f64,
    range: (f64, f64),
    grid: u32,
    switches: &dyn Fn(f64, f64, &mut Vec<f64>),
) -> Vec<f64> {
    let step = (range.1 - range.0) / f64::from(grid);
    let azimuth = |i: usize| range.0 + step * (i as f64 - 1.0);
    let all: Vec<Vec<f64>> = (0..grid as usize + 3)
        .map(|i| {
            let mut values = Vec::new();
            switches(q, azimuth(i), &mut values);
            values
        })
        .collect();
    let mut found = vec![range.0, range.1];
    let value = |k: usize, phi: f64| {
        let mut values = Vec::new();
        switches(q, phi, &mut values);
        values.get(k).copied()
    };
    let mut root = |k: usize, a: f64, b: f64| {
        let phi = find_root(&mut |phi| value(k, phi).unwrap_or(0.0), a, b);
        if phi > range.0 && phi < range.1 {
            found.push(phi);
        }
    };
    for i in 1..=grid as usize {
        let (a, b) = (azimuth(i), azimuth(i + 1));
        let (before, now) = (&all[i], &all[i + 1]);
        for k in 0..before.len().min(now.len()) {
            if (before[k] < 0.0) != (now[k] < 0.0) {
                root(k, a, b);
            }
        }
        if before.len() != now.len() {
            // The horizon is crossed: look for creases above it only.
            let edge = find_root(&mut |phi| value(0, phi).unwrap_or(0.0), a, b);
            let inset = 1e-9 * (b - a);
            let (low, high) = if before.len() > now.len() {
                (a, edge - inset)
            } else {
                (edge + inset, b)
            };
            let (mut at_low, mut at_high) = (Vec::new(), Vec::new());
            switches(q, low, &mut at_low);
            switches(q, high, &mut at_high);
            for k in 1..at_low.len().min(at_high.len()) {
                if (at_low[k] < 0.0) != (at_high[k] < 0.0) {
                    root(k, low, high);
                }
            }
        }
    }
    for i in 1..=grid as usize + 1 {
        let (before, now, after) = (&all[i - 1], &all[i], &all[i + 1]);
        for k in 0..before.len().min(now.len()).min(after.len()) {
            let (a, b, c) = (before[k], now[k], after[k]);
            let one_sign = (a < 0.0) == (b < 0.0) && (b < 0.0) == (c < 0.0);
            if !one_sign || b.abs() > a.abs() || b.abs() > c.abs() {
                continue;
            }
            let (low, high) = (azimuth(i - 1), azimuth(i + 1));
            if let Some(phi) = crossing(&|phi| value(k, phi), low, high) {
                root(k, low, phi);
                root(k, phi, high);
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

/// An azimuth at which `f` has the other sign than at both ends, by golden-section search
/// for the least size; nothing if there is none.
fn crossing(f: &dyn Fn(f64) -> Option<f64>, mut low: f64, mut high: f64) -> Option<f64> {
    let negative = f(low)? < 0.0;
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..40 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        let (fa, fb) = (f(a)?, f(b)?);
        if (fa < 0.0) != negative {
            return Some(a);
        }
        if (fb < 0.0) != negative {
            return Some(b);
        }
        if fa.abs() < fb.abs() {
            high = b;
        } else {
            low = a;
        }
    }
    None
}

/// ∫ f(V) cosΘV dω over a cell of a chart: radii and azimuths between two values, and
/// above the horizon. `creases` as for [`hemisphere`].
pub fn chart_cell(
    l: &Direction,
    chart: &Chart,
    radii: (f64, f64),
    azimuths: (f64, f64),
    accuracy: Accuracy,
    creases: &dyn Fn(&Direction, &mut Vec<f64>),
    f: &dyn Fn(&Direction) -> f64,
) -> Estimate {
    let placed = Placed::new(chart, l);
    let q_of = |t: f64| {
        if t == 0.0 {
            0.0
        } else {
            placed.q_of_radius(t).unwrap_or(1.0)
        }
    };
    let mut radial = vec![q_of(radii.0), q_of(radii.1)];
    radial.extend(
        (chart.edges.iter())
            .filter(|t| **t > radii.0 && **t < radii.1)
            .map(|t| q_of(*t)),
    );
    radial.sort_by(f64::total_cmp);
    let switches = |q: f64, phi: f64, out: &mut Vec<f64>| {
        let point = placed.at(q, phi);
        out.clear();
        out.push(point.above);
        if point.above > 0.0 {
            creases(&point.v, out);
        }
    };
    let mut inner = |q: f64| {
        let breaks = azimuth_breaks(q, azimuths, 4, &switches);
        adaptive(
            &mut |phi| {
                let point = placed.at(q, phi);
                let value = if point.above < 0.0 {
                    0.0
                } else {
                    f(&point.v) * point.measure
                };
                Estimate { value, error: 0.0 }
            },
            &breaks,
            accuracy.tolerance * 0.05,
            accuracy.inner_panels,
        )
    };
    adaptive(
        &mut inner,
        &radial,
        accuracy.tolerance,
        accuracy.outer_panels,
    )
}
