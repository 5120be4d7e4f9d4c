//! How many rays a pixel is made of.

use super::Linear;

/// The rays of a pixel: [`OneSample`] or [`FourSamples`].
pub trait Samples: Copy {
    /// Columns and rows of the camera for each of the picture's.
    fn side(self) -> u16;
    /// The pixel in column `x` of row `y` of the picture, from what the camera
    /// sees in a column of a row of its own.
    fn pixel(self, x: usize, y: usize, seen: impl Fn(usize, usize) -> Linear) -> Linear;
}

/// One ray through the middle; this costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OneSample;

impl Samples for OneSample {
    #[inline]
    fn side(self) -> u16 {
        1
    }

    #[inline]
    fn pixel(self, x: usize, y: usize, seen: impl Fn(usize, usize) -> Linear) -> Linear {
        seen(x, y)
    }
}

/// Four rays, on a grid that is turned so that each has a column and a row to
/// itself: an edge near to either axis has four steps.
///
/// Each is traced and shaded in full; their light is averaged after it is
/// clamped and before it is encoded, so that the edge of what is too bright is
/// smooth, too. The camera has four columns and four rows for each of the
/// picture's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FourSamples;

impl FourSamples {
    /// Column and row of each ray within its pixel.
    pub const GRID: [[u8; 2]; 4] = [[1, 0], [3, 1], [0, 2], [2, 3]];
}

impl Samples for FourSamples {
    #[inline]
    fn side(self) -> u16 {
        4
    }

    #[inline]
    fn pixel(self, x: usize, y: usize, seen: impl Fn(usize, usize) -> Linear) -> Linear {
        let mut sum = [2; 3];
        for [column, row] in Self::GRID {
            let light = seen(4 * x + usize::from(column), 4 * y + usize::from(row)).to_raw();
            for (sum, light) in sum.iter_mut().zip(light) {
                // At most 4 · 2²⁴ and a half step.
                *sum += light;
            }
        }
        let [r, g, b] = sum.map(|sum: u32| sum / 4);
        Linear::from_raw(r, g, b)
    }
}
