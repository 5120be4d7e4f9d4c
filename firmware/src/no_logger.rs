//! Without the feature `defmt` nothing is logged.

use crate::boards::Board;

pub use microbrdf_firmware::NoLog as Logs;

/// The board is up.
pub fn started(_board: &Board) {}
