//! The test card: pictures whose pixels are pairs of directions, so that what
//! no scene shows has room: lobes of n = 1e8, cosines of 1e-8.

mod band;
mod pair;
mod panel;

pub use band::{Across, BANDS, Band};
pub use pair::{Plane, pair};
pub use panel::{HEIGHT, Panel, WIDTH, Worst, error_colour, panel};
