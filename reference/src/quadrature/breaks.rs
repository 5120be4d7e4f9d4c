//! The azimuths on a circle of a chart where the horizon or a crease is crossed.

use super::chart::{Circle, Point};
use super::interval::root_between;
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
    /// Azimuths of the grid, with their sines and cosines.
    grid: Vec<(f64, (f64, f64))>,
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
        let step = (range.1 - range.0) / grid as f64;
        let azimuths = (0..grid + 3).map(|i| range.0 + step * (i as f64 - 1.0));
        Self {
            range,
            grid: azimuths.map(|phi| (phi, phi.sin_cos())).collect(),
            creases,
            all: RefCell::new(vec![Vec::new(); grid + 3]),
            one: RefCell::default(),
        }
    }

    /// The switches at a point. Below the horizon the creases don't matter.
    fn switches(&self, point: &Point, out: &mut Vec<f64>) {
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
        self.switches(&circle.at(phi), &mut one);
        one.get(k).copied()
    }

    /// The azimuth between two others at which one changes its sign, from its values there.
    fn root(&self, circle: &Circle<'_>, cell: &Cell) -> f64 {
        let Cell { switch, low, high } = *cell;
        root_between(
            &mut |phi| self.switch(circle, switch, phi).unwrap_or(0.0),
            low,
            high,
        )
    }

    /// The azimuths on a circle, ascending, with both ends of the range.
    pub fn of(&self, circle: &Circle<'_>) -> Vec<f64> {
        let range = self.range;
        let mut found = vec![range.0, range.1];
        self.scan(circle, &mut |cell| {
            let phi = self.root(circle, cell);
            if phi > range.0 && phi < range.1 {
                found.push(phi);
            }
        });
        found.sort_by(f64::total_cmp);
        found
    }

    /// How many they are; they need not be found for that.
    pub fn count(&self, circle: &Circle<'_>) -> usize {
        let range = self.range;
        let mut count = 2;
        self.scan(circle, &mut |cell| {
            let inside = cell.low.0 >= range.0 && cell.high.0 <= range.1;
            let phi = || self.root(circle, cell);
            if inside || (range.0..range.1).contains(&phi()) {
                count += 1;
            }
        });
        count
    }

    /// Visits the cells in which a switch changes its sign.
    fn scan(&self, circle: &Circle<'_>, visit: &mut dyn FnMut(&Cell)) {
        let azimuth = |i: usize| self.grid[i].0;
        let cells = self.grid.len() - 3;
        let mut all = self.all.borrow_mut();
        for (values, (_, angle)) in all.iter_mut().zip(&self.grid) {
            self.switches(&circle.toward(*angle), values);
        }
        let mut between = |switch: usize, low: (f64, f64), high: (f64, f64)| {
            if (low.1 < 0.0) != (high.1 < 0.0) {
                visit(&Cell { switch, low, high });
            }
        };
        for i in 1..=cells {
            let (a, b) = (azimuth(i), azimuth(i + 1));
            let (before, now) = (&all[i], &all[i + 1]);
            for k in 0..before.len().min(now.len()) {
                between(k, (a, before[k]), (b, now[k]));
            }
            if before.len() != now.len() {
                // The horizon is crossed: look for creases above it only.
                let (low, high) = ((a, before[0]), (b, now[0]));
                let edge = self.root(
                    circle,
                    &Cell {
                        switch: 0,
                        low,
                        high,
                    },
                );
                let inset = 1e-9 * (b - a);
                let (low, high) = if before.len() > now.len() {
                    (a, edge - inset)
                } else {
                    (edge + inset, b)
                };
                let (mut at_low, mut at_high) = (Vec::new(), Vec::new());
                self.switches(&circle.at(low), &mut at_low);
                self.switches(&circle.at(high), &mut at_high);
                for k in 1..at_low.len().min(at_high.len()) {
                    between(k, (low, at_low[k]), (high, at_high[k]));
                }
            }
        }
        for i in 1..=cells + 1 {
            let (before, now, after) = (&all[i - 1], &all[i], &all[i + 1]);
            for k in 0..before.len().min(now.len()).min(after.len()) {
                let (a, b, c) = (before[k], now[k], after[k]);
                let one_sign = (a < 0.0) == (b < 0.0) && (b < 0.0) == (c < 0.0);
                let is_least = b.abs() <= a.abs() && b.abs() <= c.abs();
                if !one_sign || !is_least || keeps_its_sign(a, b, c) {
                    continue;
                }
                let (low, high) = ((azimuth(i - 1), a), (azimuth(i + 1), c));
                let f = |phi| self.switch(circle, k, phi);
                if let Some(middle) = crossing(&f, low, high) {
                    between(k, low, middle);
                    between(k, middle, high);
                }
            }
        }
    }
}

/// Two azimuths, each with the value of a switch there.
struct Cell {
    switch: usize,
    low: (f64, f64),
    high: (f64, f64),
}

/// An azimuth at which `f` has the other sign than at both ends, and its value there, by
/// golden-section search for the least size; nothing if there is none.
fn crossing(
    f: &dyn Fn(f64) -> Option<f64>,
    (mut low, mut at_low): (f64, f64),
    (mut high, mut at_high): (f64, f64),
) -> Option<(f64, f64)> {
    let negative = at_low < 0.0;
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let inner = |low: f64, high: f64| (high - ratio * (high - low), low + ratio * (high - low));
    let (mut a, mut b) = inner(low, high);
    let (mut at_a, mut at_b) = (f(a)?, f(b)?);
    for _ in 0..40 {
        if (at_a < 0.0) != negative {
            return Some((a, at_a));
        }
        if (at_b < 0.0) != negative {
            return Some((b, at_b));
        }
        if at_a.abs() < at_b.abs() {
            if keeps_its_sign(at_low, at_a, at_b) {
                return None;
            }
            (high, at_high) = (b, at_b);
            (b, at_b) = (a, at_a);
            a = inner(low, high).0;
            at_a = f(a)?;
        } else {
            if keeps_its_sign(at_a, at_b, at_high) {
                return None;
            }
            (low, at_low) = (a, at_a);
            (a, at_a) = (b, at_b);
            b = inner(low, high).1;
            at_b = f(b)?;
        }
    }
    None
}

/// Whether a value of the same sign as its neighbours, and smaller than they are, is too far
/// from 0 for a root between them: farther than they are from it. A parabola through the
/// three comes at most a quarter of that nearer to 0, a kink at most 0.81, where the
/// neighbours' distances are in the golden ratio (an eighth and a half where they are equal).
fn keeps_its_sign(before: f64, least: f64, after: f64) -> bool {
    2.0 * least.abs() > before.abs().max(after.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sliver_is_crossed_and_few_looks_tell_that_there_is_none() {
        use std::cell::Cell;
        let looks = Cell::new(0);
        let find = |f: &dyn Fn(f64) -> f64| {
            looks.set(0);
            crossing(
                &|x| {
                    looks.set(looks.get() + 1);
                    Some(f(x))
                },
                (-0.6, f(-0.6)),
                (0.4, f(0.4)),
            )
            .map(|(x, _)| x)
        };
        for least in [1e-3, 1e-6, 1e-9] {
            let crossed: [&dyn Fn(f64) -> f64; 4] = [
                &|x| x * x - least,
                &|x| x.abs() - least,
                &|x| least - x.abs(),
                &|x| 1.0 - least - x.cos(),
            ];
            for f in crossed {
                let x = find(f).expect("a crossing");
                assert!((f(x) < 0.0) != (f(0.4) < 0.0), "{least}: {x}");
            }
            assert_eq!(find(&|x| x * x + least), None);
            assert!(looks.get() < 50, "{least}: {} looks", looks.get());
        }
        assert_eq!(find(&|x| x * x + 0.1), None);
        assert!(looks.get() <= 8, "{} looks", looks.get());
    }
}
