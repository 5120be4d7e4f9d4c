//! The one scene that this firmware was built with.

use microbrdf::shade::Linear;
use microbrdf_firmware::Scene;
use microbrdf_link::{PixelFormat, max_row_wire_bytes};

/// Written by `microbrdf bake`: the scene's constants, and the row function for
/// them. No scene needs all that it may define.
#[allow(unused)]
mod scene {
    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}

/// How pixels are sent.
pub const PIXEL_FORMAT: PixelFormat = if cfg!(feature = "rgb565") {
    PixelFormat::Rgb565
} else {
    PixelFormat::Srgb8
};

/// Whether displays of few levels dither.
#[allow(unused)] // by boards without a display
pub const DITHER: bool = Baked::DITHER;

/// Bytes of a row of pixels.
pub const ROW_BYTES: usize = scene::WIDTH * PIXEL_FORMAT.bytes_per_pixel();

/// Bytes of a row of pixels in packets: what the queue must hold, so that a
/// row never waits for the one before it to leave.
pub const ROW_WIRE_BYTES: usize = max_row_wire_bytes(Baked::WIDTH, PIXEL_FORMAT);

/// The row in whose middle a provoked failure strikes.
#[cfg(any(feature = "provoke-panic", feature = "provoke-hardfault"))]
const FAILING_ROW: usize = scene::HEIGHT / 2;

/// The scene.
pub struct Baked;

impl Scene for Baked {
    const NAME: &'static str = scene::NAME;
    const ARITHMETIC: &'static str = scene::ARITHMETIC;
    const EXPOSURE: f64 = scene::EXPOSURE as _;
    const DITHER: bool = scene::DITHER;
    const WIDTH: u16 = wire_size(scene::WIDTH);
    const HEIGHT: u16 = wire_size(scene::HEIGHT);

    fn shade_row(&self, y: usize, sink: impl FnMut(usize, Linear)) {
        #[cfg(feature = "provoke-panic")]
        assert!(y != FAILING_ROW, "provoked in row {y}");
        #[cfg(feature = "provoke-hardfault")]
        if y == FAILING_ROW {
            cortex_m::asm::udf();
        }
        scene::shade_row(y, sink);
    }
}

/// A size in the type that the wire has for it; one that it hasn't is a compile error.
const fn wire_size(pixels: usize) -> u16 {
    assert!(
        pixels >= 1 && pixels <= u16::MAX as usize,
        "a scene's size must be 1 to 65535"
    );
    pixels as u16
}
