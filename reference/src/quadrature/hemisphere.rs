//! The nested integral over the hemisphere.

use super::breaks::Breaks;
use super::chart::Placed;
use super::interval::{adaptive_all, root_between};
use super::{Chart, Estimate, Estimates, adaptive};
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
    hemisphere_all::<1>(l, chart, isotropic, accuracy, creases, &|v| [f(v)]).into()
}

/// [`hemisphere`] of several functions with the same creases, over the same panels; the
/// worst of them decides how far those are refined.
pub fn hemisphere_all<const N: usize>(
    l: &Direction,
    chart: &Chart,
    isotropic: bool,
    accuracy: Accuracy,
    creases: &dyn Fn(&Direction, &mut Vec<f64>),
    f: &dyn Fn(&Direction) -> [f64; N],
) -> Estimates<N> {
    let placed = Placed::new(chart, l);
    let (span, symmetry) = if isotropic {
        (PI, 2.0)
    } else {
        (2.0 * PI, 1.0)
    };
    let grid = if isotropic { 6 } else { 24 };

    // The azimuths at which something changes, for one radius, ascending.
    let breaks = Breaks::new((0.0, span), grid, creases);

    let mut inner = |q: f64| -> Estimates<N> {
        let circle = placed.circle(q);
        let mut sum = Estimates::ZERO;
        for w in breaks.of(&circle).windows(2) {
            if w[1] - w[0] <= 0.0 || circle.at(0.5 * (w[0] + w[1])).above < 0.0 {
                continue;
            }
            sum = sum
                + adaptive_all(
                    &mut |phi| {
                        let point = circle.at(phi);
                        if point.above < 0.0 || point.measure == 0.0 {
                            return Estimates::ZERO;
                        }
                        Estimates {
                            values: f(&point.v).map(|value| value * point.measure),
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
        let circle = placed.circle(q);
        (breaks.count(&circle), circle.at(0.0).above < 0.0)
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
            radial.push(root_between(
                &mut |q| if signature(q) == before { -1.0 } else { 1.0 },
                (low, -1.0),
                (high, 1.0),
            ));
        }
        before = now;
        low = high;
    }
    radial.extend(chart.edges.iter().filter_map(|&t| placed.q_of_radius(t)));
    radial.push(1.0);
    radial.sort_by(f64::total_cmp);

    adaptive_all(
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
    let breaks = Breaks::new(azimuths, 4, creases);
    let mut inner = |q: f64| {
        let circle = placed.circle(q);
        adaptive(
            &mut |phi| {
                let point = circle.at(phi);
                let value = if point.above < 0.0 {
                    0.0
                } else {
                    f(&point.v) * point.measure
                };
                Estimate { value, error: 0.0 }
            },
            &breaks.of(&circle),
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
