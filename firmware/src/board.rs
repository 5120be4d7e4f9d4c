//! What the application knows of the board it runs on.

/// A board: its names, and where pixels can go.
pub struct Board<W, P, L> {
    /// Name, as the frame header gives it.
    pub name: &'static str,
    /// Processor core, such as `cortex-m3`.
    pub core: &'static str,
    /// Version line of the compiler that built the firmware.
    pub compiler: &'static str,
    /// The serial line.
    pub serial: W,
    /// The display; [`NoPanel`](crate::NoPanel) if there is none.
    pub panel: P,
    /// Where log lines wait to be sent; [`NoLog`](crate::NoLog) if none are kept.
    pub log: L,
}
