//! Ordered dither, fixed to the screen.

/// Thresholds of a 4 x 4 cell (Bayer), in sixteenths of a step.
const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The middle of the sixteenth of a step that pixel (`x`, `y`) rounds at, in
/// thirty-seconds: odd, 1 … 31. A cell of 4 x 4 pixels has each once.
#[inline]
pub(crate) fn threshold(x: usize, y: usize) -> u32 {
    2 * u32::from(BAYER[y % 4][x % 4]) + 1
}

/// ⌊code · `levels`/255 + `threshold`/32⌋ for an 8-bit code, by multiplies and
/// shifts alone; exact for 31 and 63 levels, tested for every code.
#[inline]
pub(crate) fn level(code: u8, levels: u32, threshold: u32) -> u32 {
    // n/(255 · 32) in two steps; m/255 is exact below 65 535.
    let m = (u32::from(code) * levels * 32 + 255 * threshold) >> 5;
    (m + 1 + (m >> 8)) >> 8
}

#[cfg(test)]
mod tests {
    use super::{level, threshold};

    #[test]
    fn levels_are_exact() {
        for levels in [31, 63] {
            for code in 0..=255u8 {
                for t in (1..32).step_by(2) {
                    let exact = (u32::from(code) * levels * 32 + 255 * t) / (255 * 32);
                    assert_eq!(level(code, levels, t), exact, "{code} of {levels} at {t}");
                    assert!(exact <= levels);
                }
            }
        }
    }

    #[test]
    fn a_cell_has_each_threshold_once() {
        let mut seen = [0; 16];
        for i in 0..16 {
            seen[(threshold(4 + i % 4, 8 + i / 4) / 2) as usize] += 1;
        }
        assert_eq!(seen, [1; 16]);
    }
}
