//! Stand-ins for what a board has: a slow line, a panel, and a scene to show.

mod panel;
mod scene;
mod slow_line;

pub use panel::FakePanel;
pub use scene::{Shading, Stripes};
pub use slow_line::{SlowLine, SlowUart};
