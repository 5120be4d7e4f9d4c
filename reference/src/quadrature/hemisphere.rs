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
    let breaks = |q: f64| -> Vec<f64> {
        let mut found = vec![0.0];
        let (mut before, mut now) = (Vec::new(), Vec::new());
        switches(q, 0.0, &mut before);
        for i in 1..=grid {
            let (low, high) = (
                span * f64::from(i - 1) / f64::from(grid),
                span * f64::from(i) / f64::from(grid),
            );
            switches(q, high, &mut now);
            let mut here = Vec::new();
            for k in 0..before.len().max(now.len()) {
                let known = (before.get(k), now.get(k));
                let differs = match known {
                    (Some(a), Some(b)) => (*a < 0.0) != (*b < 0.0),
                    _ => false,
                };
                if differs {
                    let mut scratch = Vec::new();
                    here.push(find_root(
                        &mut |phi| {
                            switches(q, phi, &mut scratch);
                            scratch.get(k).copied().unwrap_or(0.0)
                        },
                        low,
                        high,
                    ));
                }
            }
            // A crease may meet the horizon inside this cell: look for it above the horizon only.
            if before.len() != now.len()
                && let Some(&edge) = here.first()
            {
                let (mut a, mut b) = if before.len() > now.len() {
                    (low, edge)
                } else {
                    (edge, high)
                };
                let inset = 1e-9 * (b - a);
                a += inset;
                b -= inset;
                let (mut at_a, mut at_b) = (Vec::new(), Vec::new());
                switches(q, a, &mut at_a);
                switches(q, b, &mut at_b);
                for k in 1..at_a.len().min(at_b.len()) {
                    if (at_a[k] < 0.0) != (at_b[k] < 0.0) {
                        let mut scratch = Vec::new();
                        here.push(find_root(
                            &mut |phi| {
                                switches(q, phi, &mut scratch);
                                scratch.get(k).copied().unwrap_or(0.0)
                            },
                            a,
                            b,
                        ));
                    }
                }
            }
            here.sort_by(f64::total_cmp);
            found.extend(here);
            std::mem::swap(&mut before, &mut now);
        }
        found.push(span);
        found
    };

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
    let above = |q: f64, phi: f64| placed.at(q, phi).above;
    let mut inner = |q: f64| {
        // In every chart the horizon is crossed at most once on either side of azimuth 0.
        let mut breaks = vec![azimuths.0, azimuths.1];
        for (a, b) in [
            (azimuths.0, azimuths.1.min(0.0)),
            (azimuths.0.max(0.0), azimuths.1),
        ] {
            if a < b && (above(q, a) < 0.0) != (above(q, b) < 0.0) {
                breaks.push(find_root(&mut |phi| above(q, phi), a, b));
            }
        }
        if azimuths.0 < 0.0 && azimuths.1 > 0.0 {
            breaks.push(0.0);
        }
        // Creases that change sign between neighbours of a small grid.
        let values = |phi: f64| {
            let mut out = Vec::new();
            creases(&placed.at(q, phi).v, &mut out);
            out
        };
        let step = (azimuths.1 - azimuths.0) / 6.0;
        let mut before = values(azimuths.0);
        for i in 1..=6 {
            let (a, b) = (
                azimuths.0 + step * f64::from(i - 1),
                azimuths.0 + step * f64::from(i),
            );
            let now = values(b);
            for k in 0..now.len() {
                if (before[k] < 0.0) != (now[k] < 0.0) {
                    breaks.push(find_root(&mut |phi| values(phi)[k], a, b));
                }
            }
            before = now;
        }
        breaks.sort_by(f64::total_cmp);
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
