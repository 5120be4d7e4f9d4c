//! Pictures as the core computes them.

mod encode;
mod renderer;

pub use renderer::Renderer;

use std::convert::Infallible;

use microbrdf::shade::{Linear, grey16, grey16_nearest};
use microbrdf_link::{FrameWriter, Header, PixelFormat, SendError};
use microbrdf_scene::Description;
use rayon::prelude::*;

use crate::arithmetic::ArithmeticName;
use crate::exit::Outcome;
use crate::picture::Picture;

/// Columns and rows of the grey panel.
const PANEL: [usize; 2] = [128, 64];
/// How many times the emulated panel is enlarged on each side.
const PANEL_MAGNIFICATION: usize = 4;

/// A scene's pixels in linear light, row by row.
pub struct Frame {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Pixels from the top left.
    pub pixels: Vec<Linear>,
    /// Whether displays of few levels dither.
    pub dither: bool,
}

/// Shades the scene in an arithmetic.
pub fn frame(description: &Description, arithmetic: ArithmeticName) -> Outcome<Frame> {
    Ok(Renderer::new(description, arithmetic)?.frame())
}

impl Frame {
    /// A header that says the frame's size and nothing else.
    pub fn header(&self, format: PixelFormat) -> Header<'static> {
        Header::new(self.width as u16, self.height as u16, format)
    }

    /// Sends the frame as a device does.
    ///
    /// # Errors
    /// A header that the wire can't carry.
    pub fn send(
        &self,
        sink: &mut Vec<u8>,
        header: &Header<'_>,
    ) -> Result<(), SendError<Infallible>> {
        let mut writer = FrameWriter::begin(sink, header)?;
        match header.pixel_format {
            PixelFormat::Srgb8 => {
                for pixel in &self.pixels {
                    writer.pixels(&pixel.srgb8())?;
                }
            }
            PixelFormat::Rgb565 => {
                for packed in self.rgb565() {
                    writer.pixels(&packed.to_le_bytes())?;
                }
            }
        }
        writer.end()?;
        Ok(())
    }

    /// The picture in 8-bit sRGB.
    pub fn srgb(&self) -> Picture {
        Picture {
            width: self.width,
            height: self.height,
            pixels: self.pixels.par_iter().map(|pixel| pixel.srgb8()).collect(),
        }
    }

    /// Pixels as a display of 65 536 colours is sent them.
    pub fn rgb565(&self) -> impl Iterator<Item = u16> + '_ {
        self.pixels.iter().enumerate().map(|(i, pixel)| {
            if self.dither {
                pixel.rgb565_dithered(i % self.width, i / self.width)
            } else {
                pixel.rgb565()
            }
        })
    }

    /// The picture as such a display shows it: each channel the nearest 8-bit
    /// code, as the receiver takes it.
    pub fn rgb565_shown(&self) -> Picture {
        let shown = |packed: u16| {
            let (r, g, b) = (packed >> 11, (packed >> 5) & 63, packed & 31);
            [(r, 31), (g, 63), (b, 31)]
                .map(|(bits, levels)| ((2 * u32::from(bits) * 255 + levels) / (2 * levels)) as u8)
        };
        Picture {
            width: self.width,
            height: self.height,
            pixels: self.rgb565().map(shown).collect(),
        }
    }

    /// The grey panel as its photograph shows it: each of its pixels the mean
    /// of a 2 x 2 box in linear light, in one of 16 levels; black where the
    /// frame has no pixel.
    pub fn panel(&self) -> Picture {
        let [width, height] = PANEL;
        let pixels = (0..width * height).map(|i| {
            let (x, y) = (i % width, i / width);
            if 2 * x + 1 >= self.width || 2 * y + 1 >= self.height {
                return [0; 3];
            }
            let light = |dx: usize, dy: usize| {
                self.pixels[(2 * y + dy) * self.width + 2 * x + dx].luminance()
            };
            let mean = (light(0, 0) + light(1, 0) + light(0, 1) + light(1, 1)) / 4;
            // The levels are shown 17 codes apart.
            let level = if self.dither {
                grey16(mean, x, y)
            } else {
                grey16_nearest(mean)
            };
            [17 * level; 3]
        });
        Picture {
            width,
            height,
            pixels: pixels.collect(),
        }
        .magnified(PANEL_MAGNIFICATION)
    }
}
