//! The one table of tolerances.
//!
//! Each row bounds the arithmetic error of a model's displayed sRGB code, over
//! all sets of samples. The accuracy test fails when a bound is passed, when
//! it is wider than [`SLACK`] above what is found, and when nothing uses it.

/// How far a bound may lie above the greatest error found, in codes.
pub const SLACK: f64 = 0.02;

/// The exposure at which a row holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exposure {
    /// K = 1: the peak is at full scale.
    One,
    /// K = c, the model's own peak: unit irradiance, the highlight saturates.
    Peak,
}

/// A bound.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// Arithmetic.
    pub arithmetic: &'static str,
    /// Model, as in the registry.
    pub model: &'static str,
    /// Exposure.
    pub exposure: Exposure,
    /// Least and greatest peak in sr⁻¹.
    pub peaks: [f64; 2],
    /// Greatest |code − exact code|, in codes; 0.50 is perfect rounding.
    pub lsb_max: f64,
    /// Greatest share of codes off by one. None is off by more.
    pub off_by_one: f64,
}

const fn row(
    arithmetic: &'static str,
    model: &'static str,
    exposure: Exposure,
    peaks: [f64; 2],
    lsb_max: f64,
    off_by_one: f64,
) -> Tolerance {
    Tolerance {
        arithmetic,
        model,
        exposure,
        peaks,
        lsb_max,
        off_by_one,
    }
}

use Exposure::{One, Peak};

const ANY: [f64; 2] = [0.0, f64::INFINITY];
/// Peaks up to that of n = 1e5.
const MODERATE: [f64; 2] = [0.0, 2e4];
/// Peaks up to that of n = 1.2e4, and from there to that of n = 1e5.
const COMMON: [f64; 2] = [0.0, 2e3];
const SHARP: [f64; 2] = [2e3, 2e4];
/// Peaks beyond: exposed at their own, a share's last bit shows.
const EXTREME: [f64; 2] = [2e4, f64::INFINITY];

/// Every bound.
pub const TABLE: &[Tolerance] = &[
    row("f32", "lambert", One, ANY, 0.51, 0.01),
    row("f32", "lambert", Peak, ANY, 0.51, 0.01),
    row("f32", "phong", One, ANY, 0.51, 0.01),
    row("f32", "phong", Peak, ANY, 0.51, 0.01),
    row("f32", "metallic-phong", One, ANY, 0.51, 0.01),
    row("f32", "metallic-phong", Peak, ANY, 0.51, 0.01),
    row("f32", "retro-phong", One, ANY, 0.51, 0.01),
    row("f32", "retro-phong", Peak, ANY, 0.51, 0.01),
    row("f32", "plastic", One, ANY, 0.51, 0.01),
    row("f32", "plastic", Peak, ANY, 0.51, 0.01),
    row("f32", "plastic with index", One, ANY, 0.52, 0.01),
    row("f32", "plastic with index", Peak, ANY, 0.52, 0.01),
    row("f32", "patch", One, ANY, 0.51, 0.01),
    row("f32", "patch", Peak, ANY, 0.51, 0.01),
    row("f32", "patch-exponential", One, ANY, 0.51, 0.01),
    row("f32", "patch-exponential", Peak, ANY, 0.51, 0.01),
    row("f32", "profile", One, ANY, 0.51, 0.01),
    row("f32", "profile", Peak, ANY, 0.51, 0.01),
    row("f32", "patch-metal", One, ANY, 0.51, 0.01),
    row("f32", "patch-metal", Peak, ANY, 0.51, 0.01),
    row("f32", "metallic-paint", One, ANY, 0.51, 0.01),
    row("f32", "metallic-paint", Peak, ANY, 0.51, 0.01),
    row("f32", "generalised-lambert", One, ANY, 0.51, 0.01),
    row("f32", "generalised-lambert", Peak, ANY, 0.51, 0.01),
    row("f32", "metal", One, ANY, 0.53, 0.01),
    row("f32", "metal", Peak, ANY, 0.53, 0.01),
    row("q31", "lambert", One, ANY, 0.51, 0.01),
    row("q31", "lambert", Peak, ANY, 0.51, 0.01),
    row("q31", "phong", One, ANY, 0.51, 0.01),
    row("q31", "phong", Peak, MODERATE, 0.52, 0.01),
    row("q31", "phong", Peak, EXTREME, 15.41, 0.36),
    row("q31", "metallic-phong", One, ANY, 0.51, 0.01),
    row("q31", "metallic-phong", Peak, MODERATE, 0.52, 0.01),
    row("q31", "metallic-phong", Peak, EXTREME, 12.11, 0.36),
    row("q31", "retro-phong", One, ANY, 0.51, 0.01),
    row("q31", "retro-phong", Peak, MODERATE, 0.52, 0.01),
    row("q31", "retro-phong", Peak, EXTREME, 12.11, 0.36),
    row("q31", "plastic", One, ANY, 0.52, 0.01),
    row("q31", "plastic", Peak, MODERATE, 0.51, 0.01),
    row("q31", "plastic", Peak, EXTREME, 6.87, 0.53),
    row("q31", "plastic with index", One, ANY, 0.52, 0.01),
    row("q31", "plastic with index", Peak, ANY, 0.52, 0.01),
    row("q31", "patch", One, ANY, 0.51, 0.01),
    row("q31", "patch", Peak, MODERATE, 0.51, 0.01),
    row("q31", "patch", Peak, EXTREME, 0.47, 0.01),
    row("q31", "patch-exponential", One, ANY, 0.51, 0.01),
    row("q31", "patch-exponential", Peak, MODERATE, 0.51, 0.01),
    row("q31", "patch-exponential", Peak, EXTREME, 3.44, 0.53),
    row("q31", "profile", One, ANY, 0.51, 0.01),
    row("q31", "profile", Peak, MODERATE, 0.51, 0.01),
    row("q31", "profile", Peak, EXTREME, 1.31, 0.01),
    row("q31", "patch-metal", One, ANY, 0.51, 0.01),
    row("q31", "patch-metal", Peak, ANY, 0.51, 0.01),
    row("q31", "metallic-paint", One, ANY, 0.51, 0.01),
    row("q31", "metallic-paint", Peak, ANY, 0.51, 0.01),
    row("q31", "generalised-lambert", One, ANY, 0.51, 0.01),
    row("q31", "generalised-lambert", Peak, ANY, 0.51, 0.01),
    row("q31", "metal", One, ANY, 0.53, 0.01),
    row("q31", "metal", Peak, ANY, 0.53, 0.01),
    row("micromath", "lambert", One, ANY, 0.51, 0.01),
    row("micromath", "lambert", Peak, ANY, 0.51, 0.01),
    row("micromath", "phong", One, ANY, 0.71, 0.03),
    row("micromath", "phong", Peak, ANY, 0.77, 0.06),
    row("micromath", "metallic-phong", One, ANY, 0.69, 0.04),
    row("micromath", "metallic-phong", Peak, ANY, 0.84, 0.05),
    row("micromath", "retro-phong", One, ANY, 0.69, 0.04),
    row("micromath", "retro-phong", Peak, ANY, 0.84, 0.05),
    row("micromath", "plastic", One, ANY, 0.70, 0.03),
    row("micromath", "plastic", Peak, ANY, 0.74, 0.03),
    row("micromath", "plastic with index", One, ANY, 0.69, 0.02),
    row("micromath", "plastic with index", Peak, ANY, 0.73, 0.03),
    row("micromath", "patch", One, ANY, 0.51, 0.01),
    row("micromath", "patch", Peak, ANY, 0.51, 0.01),
    row("micromath", "patch-exponential", One, ANY, 0.63, 0.03),
    row("micromath", "patch-exponential", Peak, ANY, 0.69, 0.03),
    row("micromath", "profile", One, ANY, 0.51, 0.01),
    row("micromath", "profile", Peak, ANY, 0.51, 0.01),
    row("micromath", "patch-metal", One, ANY, 0.68, 0.02),
    row("micromath", "patch-metal", Peak, ANY, 0.70, 0.02),
    row("micromath", "metallic-paint", One, ANY, 0.65, 0.02),
    row("micromath", "metallic-paint", Peak, ANY, 0.71, 0.02),
    row("micromath", "generalised-lambert", One, ANY, 0.51, 0.01),
    row("micromath", "generalised-lambert", Peak, ANY, 0.51, 0.01),
    row("micromath", "metal", One, ANY, 0.70, 0.04),
    row("micromath", "metal", Peak, ANY, 0.85, 0.05),
    row("q15", "lambert", One, ANY, 0.51, 0.01),
    row("q15", "lambert", Peak, ANY, 0.51, 0.01),
    row("q15", "phong", One, ANY, 0.62, 0.04),
    row("q15", "phong", Peak, COMMON, 0.77, 0.08),
    row("q15", "phong", Peak, SHARP, 1.03, 0.10),
    row("q15", "phong", Peak, EXTREME, 99.41, 0.24),
    row("q15", "metallic-phong", One, ANY, 0.71, 0.08),
    row("q15", "metallic-phong", Peak, COMMON, 0.64, 0.05),
    row("q15", "metallic-phong", Peak, SHARP, 1.49, 0.32),
    row("q15", "metallic-phong", Peak, EXTREME, 130.89, 0.12),
    row("q15", "retro-phong", One, ANY, 0.71, 0.08),
    row("q15", "retro-phong", Peak, COMMON, 0.64, 0.05),
    row("q15", "retro-phong", Peak, SHARP, 1.49, 0.32),
    row("q15", "retro-phong", Peak, EXTREME, 130.89, 0.12),
    row("q15", "plastic", One, ANY, 0.73, 0.07),
    row("q15", "plastic", Peak, COMMON, 0.66, 0.04),
    row("q15", "plastic", Peak, SHARP, 1.04, 0.10),
    row("q15", "plastic", Peak, EXTREME, 75.89, 0.25),
    row("q15", "plastic with index", One, ANY, 0.71, 0.06),
    row("q15", "plastic with index", Peak, ANY, 0.67, 0.03),
    row("q15", "patch", One, ANY, 0.51, 0.01),
    row("q15", "patch", Peak, COMMON, 0.51, 0.01),
    row("q15", "patch", Peak, SHARP, 0.42, 0.01),
    row("q15", "patch", Peak, EXTREME, 0.01, 0.01),
    row("q15", "patch-exponential", One, ANY, 0.56, 0.02),
    row("q15", "patch-exponential", Peak, COMMON, 0.67, 0.04),
    row("q15", "patch-exponential", Peak, SHARP, 0.69, 0.04),
    row("q15", "patch-exponential", Peak, EXTREME, 50.83, 0.30),
    row("q15", "profile", One, ANY, 0.56, 0.01),
    row("q15", "profile", Peak, ANY, 0.57, 0.01),
    row("q15", "patch-metal", One, ANY, 0.62, 0.02),
    row("q15", "patch-metal", Peak, ANY, 0.70, 0.04),
    row("q15", "metallic-paint", One, ANY, 0.61, 0.02),
    row("q15", "metallic-paint", Peak, ANY, 0.69, 0.04),
    row("q15", "generalised-lambert", One, ANY, 0.51, 0.01),
    row("q15", "generalised-lambert", Peak, ANY, 0.51, 0.01),
    row("q15", "metal", One, ANY, 0.72, 0.09),
    row("q15", "metal", Peak, ANY, 0.67, 0.06),
];

/// The row for a model at a peak and an exposure.
pub fn find(arithmetic: &str, model: &str, exposure: Exposure, peak: f64) -> Option<usize> {
    TABLE.iter().position(|row| {
        row.arithmetic == arithmetic
            && row.model == model
            && row.exposure == exposure
            && (row.peaks[0]..row.peaks[1]).contains(&peak)
    })
}
