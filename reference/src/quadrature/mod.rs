//! Deterministic integrals over the hemisphere, with an error estimate.
//!
//! [`adaptive`] integrates over an interval; [`hemisphere`] nests it over a
//! [`Chart`], polar coordinates that follow the model's lobe. The horizon and the
//! creases that a model names are found as roots and become ends of panels, so
//! that every panel is smooth inside.

mod breaks;
mod chart;
mod hemisphere;
mod interval;

pub use chart::{Chart, ChartKind};
pub use hemisphere::{Accuracy, chart_cell, hemisphere, hemisphere_all};
pub use interval::{adaptive, find_root};

/// A computed value and a bound on its error, both in the same unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// The estimated absolute error, rounding included.
    pub error: f64,
}

impl Estimate {
    /// A value that is exact up to rounding.
    pub fn exact(value: f64) -> Self {
        Self {
            value,
            error: value.abs() * f64::EPSILON,
        }
    }

    /// Both multiplied by a constant.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            error: self.error * factor.abs(),
        }
    }
}

impl std::ops::Add for Estimate {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            error: self.error + other.error,
        }
    }
}

/// Values that are integrated together, and a bound on the error of each, all in one unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimates<const N: usize> {
    /// The values.
    pub values: [f64; N],
    /// The greatest of their estimated absolute errors, rounding included.
    pub error: f64,
}

impl<const N: usize> Estimates<N> {
    /// Nothing, without an error.
    pub const ZERO: Self = Self {
        values: [0.0; N],
        error: 0.0,
    };

    /// All multiplied by a constant.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            values: self.values.map(|value| value * factor),
            error: self.error * factor.abs(),
        }
    }
}

impl<const N: usize> std::ops::Add for Estimates<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            values: std::array::from_fn(|i| self.values[i] + other.values[i]),
            error: self.error + other.error,
        }
    }
}

impl From<Estimate> for Estimates<1> {
    fn from(one: Estimate) -> Self {
        Self {
            values: [one.value],
            error: one.error,
        }
    }
}

impl From<Estimates<1>> for Estimate {
    fn from(one: Estimates<1>) -> Self {
        Self {
            value: one.values[0],
            error: one.error,
        }
    }
}
