//! The azimuths on a circle of a chart where the horizon or a crease is crossed.

use super::chart::Circle;
use super::find_root;
use crate::Direction;
use std::cell::RefCell;

/// Finds them. A switch, the height above the horizon or a value that a model names, changes
/// its sign there.
///
/// A switch is looked at on a grid that reaches one cell beyond the range. Between
/// neighbours of different sign there is a root; where its size has a least value between
/// three of the same sign it is followed to that value, so that a sliver narrower than a
/// cell is not lost.
pub(super) struct Breaks<'a> {
    range: (f64, f64),
    grid: usize,
    creases: &'a dyn Fn(&Direction, &mut Vec<f64>),
    /// The switches at each point of the grid, and at one azimuth: kept, since circles are
    /// many and memory is asked for slowly.
    all: RefCell<Vec<Vec<f64>>>,
    one: RefCell<Vec<f64>>,
}

impl<'a> Breaks<'a> {
    /// Within `range`, on so many cells. `creases` as for [`super::hemisphere`].
    pub fn new(
        range: (f64, f64),
        grid: usize,
        creases: &'a dyn Fn(&Direction, &mut Vec<f64>),
    ) -> Self {
        Self {
            range,
            grid,
            creases,
            all: RefCell::new(vec![Vec::new(); grid + 3]),
            one: RefCell::default(),
        }
    }

    /// The switches at an azimuth. Below the horizon the creases don't matter.
    fn switches(&self, circle: &Circle<'_>, phi: f64, out: &mut Vec<f64>) {
        let point = circle.at(phi);
        out.clear();
        out.push(point.above);
        if point.above > 0.0 {
            (self.creases)(&point.v, out);
        }
    }

    /// One of them; nothing if there are fewer.
    fn switch(&self, circle: &Circle<'_>, k: usize, phi: f64) -> Option<f64> {
        if k == 0 {
            return Some(circle.at(phi).above);
        }
        let mut one = self.one.borrow_mut();
        self.switches(circle, phi, &mut one);
        one.get(k).copied()
    }

    /// The azimuth between two others at which one changes its sign.
    fn root(&self, circle: &Circle<'_>, k: usize, a: f64, b: f64) -> f64 {
        find_root(&mut |phi| self.switch(circle, k, phi).unwrap_or(0.0), a, b)
    }

    /// The azimuths on a circle, ascending, with both ends of the range.
    pub fn of(&self, circle: &Circle<'_>) -> Vec<f64> {
        let (range, grid) = (self.range, self.grid);
        let step = (range.1 - range.0) / grid as f64;
        let azimuth = |i: usize| range.0 + step * (i as f64 - 1.0);
        let mut all = self.all.borrow_mut();
        for (i, values) in all.iter_mut().enumerate() {
            self.switches(circle, azimuth(i), values);
        }
        let mut found = vec![range.0, range.1];
        let mut root = |k: usize, a: f64, b: f64| {
            let phi = self.root(circle, k, a, b);
            if phi > range.0 && phi < range.1 {
                found.push(phi);
            }
        };
        for i in 1..=grid {
            let (a, b) = (azimuth(i), azimuth(i + 1));
            let (before, now) = (&all[i], &all[i + 1]);
            for k in 0..before.len().min(now.len()) {
                if (before[k] < 0.0) != (now[k] < 0.0) {
                    root(k, a, b);
                }
            }
            if before.len() != now.len() {
                // The horizon is crossed: look for creases above it only.
                let edge = self.root(circle, 0, a, b);
                let inset = 1e-9 * (b - a);
                let (low, high) = if before.len() > now.len() {
                    (a, edge - inset)
                } else {
                    (edge + inset, b)
                };
                let (mut at_low, mut at_high) = (Vec::new(), Vec::new());
                self.switches(circle, low, &mut at_low);
                self.switches(circle, high, &mut at_high);
                for k in 1..at_low.len().min(at_high.len()) {
                    if (at_low[k] < 0.0) != (at_high[k] < 0.0) {
                        root(k, low, high);
                    }
                }
            }
        }
        for i in 1..=grid + 1 {
            let (before, now, after) = (&all[i - 1], &all[i], &all[i + 1]);
            for k in 0..before.len().min(now.len()).min(after.len()) {
                let (a, b, c) = (before[k], now[k], after[k]);
                let one_sign = (a < 0.0) == (b < 0.0) && (b < 0.0) == (c < 0.0);
                if !one_sign || b.abs() > a.abs() || b.abs() > c.abs() {
                    continue;
                }
                let (low, high) = (azimuth(i - 1), azimuth(i + 1));
                if let Some(phi) = crossing(&|phi| self.switch(circle, k, phi), low, high) {
                    root(k, low, phi);
                    root(k, phi, high);
                }
            }
        }
        found.sort_by(f64::total_cmp);
        found
    }
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
