//! A display on the board, fed while the frame is shaded.

use core::convert::Infallible;
use core::fmt::Debug;

use microbrdf::shade::Linear;

/// A display that takes the frame's pixels as they come.
pub trait Panel {
    /// What can go wrong on the way to the display.
    type Error: Debug;

    /// Takes the light of the frame's pixel in column `x` of the row under way.
    fn pixel(&mut self, x: usize, light: Linear);

    /// Row `y` of the frame is whole: shows what it completes.
    ///
    /// # Errors
    /// Those of the display's bus and pins.
    fn end_row(&mut self, y: usize) -> Result<(), Self::Error>;
}

/// No display.
pub struct NoPanel;

impl Panel for NoPanel {
    type Error = Infallible;

    #[inline]
    fn pixel(&mut self, _x: usize, _light: Linear) {}

    fn end_row(&mut self, _y: usize) -> Result<(), Infallible> {
        Ok(())
    }
}
