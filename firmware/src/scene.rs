//! What is shaded.

use microbrdf::shade::Linear;

/// A scene with its camera, materials and arithmetic chosen: rows of light.
pub trait Scene {
    /// Name, as the frame header gives it: ASCII, at most 32 bytes.
    const NAME: &'static str;
    /// Name of the arithmetic that shades it, such as `q31`.
    const ARITHMETIC: &'static str;
    /// Factor that all light was scaled by; finite.
    const EXPOSURE: f64;
    /// Whether displays of few levels dither.
    const DITHER: bool;
    /// Pixels in a row, at least 1.
    const WIDTH: u16;
    /// Rows, at least 1.
    const HEIGHT: u16;

    /// Shades row `y`, calling `sink` with each column and its light, left to right.
    fn shade_row(&self, y: usize, sink: impl FnMut(usize, Linear));
}
