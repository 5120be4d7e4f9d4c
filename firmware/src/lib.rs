//! The device's application, apart from any device.
//!
//! [`send_frame`] shades a [`Scene`] row by row and sends each row over the
//! serial line of a [`Board`], and to its [`Panel`] where it has one. The line
//! is a [`QueuedSerial`]: a row is put into a queue, an interrupt takes it out
//! byte by byte, and meanwhile the next row is shaded.
//!
//! What touches registers is the binary's and lives in `src/boards`; all that
//! is here runs, and is tested, on a host as well.
#![no_std]

mod app;
mod board;
mod fault;
mod greys;
mod log;
mod panel;
mod pixel;
mod scene;
mod serial;
mod ssd0323;
mod uart;

pub use app::{FrameError, send_frame};
pub use board::Board;
pub use fault::{report, report_code};
pub use greys::Greys;
pub use log::{LogSource, NoLog};
pub use panel::{NoPanel, Panel};
pub use pixel::encode_pixel;
pub use scene::Scene;
pub use serial::{Dequeue, Drain, Enqueue, QueuedSerial};
pub use ssd0323::{Ssd0323, Ssd0323Error};
pub use uart::{Polled, Uart, drain};
