//! A row of the baked scene.

/// Written by `microbrdf bake`. No scene needs all that it may define.
#[allow(unused)]
mod scene {
    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}

/// Bytes of a row of pixels, in whole words.
const BYTES: usize = (3 * scene::WIDTH).next_multiple_of(4);

/// Shades row `y` into 8-bit sRGB.
#[allow(unsafe_code)]
#[unsafe(export_name = "row")]
pub extern "C" fn row(y: u32, out: &mut [u8; BYTES]) {
    scene::shade_row(y as usize, |x, light| {
        if let Some(pixel) = out.get_mut(3 * x..3 * x + 3) {
            pixel.copy_from_slice(&light.srgb8());
        }
    });
}
