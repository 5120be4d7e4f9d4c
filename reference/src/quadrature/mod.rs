//! Deterministic integrals over the hemisphere, with an error estimate.
//!
//! [`adaptive`] integrates over an interval; [`hemisphere`] nests it over a
//! [`Chart`], polar coordinates that follow the model's lobe. The horizon and the
//! creases that a model names are found as roots and become ends of panels, so
//! that every panel is smooth inside.

mod chart;
mod hemisphere;
mod interval;

pub use chart::{Chart, ChartKind};
pub use hemisphere::{Accuracy, chart_cell, hemisphere};
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
