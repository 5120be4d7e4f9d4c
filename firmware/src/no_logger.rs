//! Without the feature `defmt` nothing is logged.

pub use microbrdf_firmware::NoLog as Logs;
