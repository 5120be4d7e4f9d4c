//! sRGB codes of whole rows: the core's, by one look-up each.

use std::sync::LazyLock;

use microbrdf::shade::{LINEAR_ONE, Linear, srgb8};

/// Light of a cell, in the last places of 24: no two codes begin in one.
const CELL_BITS: u32 = 10;
const CELLS: usize = (LINEAR_ONE >> CELL_BITS) as usize + 1;

/// What [`srgb8`] finds in two decisions, in tables that are too large for a
/// microcontroller.
struct Codes {
    /// The code at the left end of each cell.
    starts: Box<[u8; CELLS]>,
    /// The least light whose code is above this one.
    ends: [u32; 256],
}

static CODES: LazyLock<Codes> = LazyLock::new(|| {
    let ends = std::array::from_fn(|code| {
        // The light below which codes are at most this, halved down.
        let mut end = 0;
        for bit in (0..=24).rev() {
            let next = end | 1 << bit;
            if next <= LINEAR_ONE && usize::from(srgb8(next)) <= code {
                end = next;
            }
        }
        end + 1
    });
    let start = |cell: usize| srgb8((cell as u32) << CELL_BITS);
    Codes {
        starts: Box::new(std::array::from_fn(start)),
        ends,
    }
});

/// The codes of a row, those of [`Linear::srgb8`].
pub fn encode(pixels: &[Linear], codes: &mut [[u8; 3]]) {
    let table = &*CODES;
    let code = |light: u32| {
        let cell = ((light >> CELL_BITS) as usize).min(CELLS - 1);
        let start = table.starts[cell];
        start + u8::from(light >= table.ends[usize::from(start)])
    };
    for (codes, pixel) in codes.iter_mut().zip(pixels) {
        *codes = pixel.to_raw().map(code);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_the_cores() {
        let light: Vec<u32> = (0..=LINEAR_ONE).collect();
        for light in light.chunks(4096) {
            let pixels: Vec<_> = light
                .iter()
                .map(|l| Linear::from_raw(*l, LINEAR_ONE - l, l / 3))
                .collect();
            let mut codes = vec![[0; 3]; pixels.len()];
            encode(&pixels, &mut codes);
            let expected: Vec<_> = pixels.iter().map(|pixel| pixel.srgb8()).collect();
            assert!(codes == expected, "from {}", light[0]);
        }
    }
}
