//! The firmware: the application of the library on one board.
//!
//! `cargo xtask demo` builds it; `docs/adding-a-board.md` says how to do so by
//! hand, and what a board consists of. On a host it only says so.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod baked;
#[cfg(target_os = "none")]
mod boards;
#[cfg(target_os = "none")]
mod device;
#[cfg(target_os = "none")]
#[cfg_attr(feature = "brief", path = "brief_words.rs")]
mod last_words;
#[cfg(target_os = "none")]
#[cfg_attr(not(feature = "defmt"), path = "no_logger.rs")]
mod logger;
#[cfg(all(target_os = "none", feature = "brief"))]
mod memory_by_bytes;
#[cfg(all(target_os = "none", feature = "defmt"))]
mod stack;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    eprintln!(
        "This is firmware for a microcontroller, and does nothing on a host.\n\
         Run it in an emulator: cargo xtask demo --board lm3s6965evb\n\
         Act as a board would:  microbrdf device scenes/demo.toml --pty"
    );
    std::process::ExitCode::from(2)
}
