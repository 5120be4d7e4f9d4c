//! From linear light to a pixel's bytes on the wire.

use heapless::VecView;
use microbrdf::shade::Linear;
use microbrdf_link::PixelFormat;

/// Appends one pixel to a row; `place` is its column and row where a display
/// of few levels dithers.
///
/// A row that is full stays as it is: [`FrameWriter`](microbrdf_link::FrameWriter)
/// refuses one of the wrong length, once for all its pixels.
#[inline]
pub fn encode_pixel(
    format: PixelFormat,
    place: Option<[usize; 2]>,
    light: Linear,
    row: &mut VecView<u8>,
) {
    let _ = match format {
        PixelFormat::Srgb8 => row.extend_from_slice(&light.srgb8()),
        PixelFormat::Rgb565 => {
            let packed = match place {
                Some([x, y]) => light.rgb565_dithered(x, y),
                None => light.rgb565(),
            };
            row.extend_from_slice(&packed.to_le_bytes())
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use microbrdf::shade::LINEAR_ONE;

    fn encoded(format: PixelFormat, light: Linear) -> heapless::Vec<u8, 4> {
        let mut row = heapless::Vec::new();
        encode_pixel(format, None, light, &mut row);
        row
    }

    #[test]
    fn channels_keep_their_order() {
        let light = Linear::from_raw(LINEAR_ONE, 0, LINEAR_ONE / 2);
        assert_eq!(encoded(PixelFormat::Srgb8, light), [255, 0, 188]);
        // Red 31, green 0, blue 23: 0xF817, low byte first.
        assert_eq!(encoded(PixelFormat::Rgb565, light), [0x17, 0xF8]);
    }

    #[test]
    fn a_full_row_stays_as_it_is() {
        let mut row = heapless::Vec::<u8, 4>::from_slice(&[1, 2]).expect("2 fit in 4");
        encode_pixel(PixelFormat::Srgb8, None, Linear::default(), &mut row);
        assert_eq!(row, [1, 2]);
    }
}
