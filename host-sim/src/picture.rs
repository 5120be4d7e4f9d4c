//! 8-bit pictures and their files.

use std::fs::File;
use std::io::{BufReader, Write};
use std::path::Path;

use crate::exit::{Failure, Outcome};

/// An 8-bit RGB picture, sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Pixels from the top left, row by row.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// The picture with `factor` x `factor` pixels for each.
    pub fn magnified(&self, factor: usize) -> Self {
        let (width, height) = (self.width * factor, self.height * factor);
        let pixel = |i: usize| self.pixels[i / width / factor * self.width + i % width / factor];
        Self {
            width,
            height,
            pixels: (0..width * height).map(pixel).collect(),
        }
    }

    /// Writes a PNG; the file appears whole or not at all.
    pub fn write_png(&self, path: &Path) -> Outcome<()> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let encoded = encoder.write_header().and_then(|mut writer| {
            writer.write_image_data(self.pixels.as_flattened())?;
            writer.finish()
        });
        encoded.map_err(|error| Failure::Incomplete(format!("{}: {error}", path.display())))?;
        write_whole(path, &bytes)
    }

    /// Reads a PNG of 8 bits a channel, RGB or RGBA.
    pub fn read_png(path: &Path) -> Outcome<Self> {
        let fault = |message: String| Failure::Usage(format!("{}: {message}", path.display()));
        let file = File::open(path).map_err(|error| fault(error.to_string()))?;
        let mut reader = png::Decoder::new(BufReader::new(file))
            .read_info()
            .map_err(|error| fault(error.to_string()))?;
        let size = reader
            .output_buffer_size()
            .ok_or_else(|| fault("is too large".to_owned()))?;
        let mut bytes = vec![0; size];
        let frame = reader
            .next_frame(&mut bytes)
            .map_err(|error| fault(error.to_string()))?;
        let step = match (frame.color_type, frame.bit_depth) {
            (png::ColorType::Rgb, png::BitDepth::Eight) => 3,
            (png::ColorType::Rgba, png::BitDepth::Eight) => 4,
            (color, depth) => {
                return Err(fault(format!(
                    "is {color:?} of {depth:?} bits: must be 8-bit RGB"
                )));
            }
        };
        let pixels = bytes
            .chunks_exact(step)
            .map(|pixel| [pixel[0], pixel[1], pixel[2]])
            .collect();
        Ok(Self {
            width: frame.width as usize,
            height: frame.height as usize,
            pixels,
        })
    }
}

/// Writes a file by way of a temporary one beside it; a link stays one, and what is no
/// file, a device or a pipe, is written to as it is.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Outcome<()> {
    let fault = |error: std::io::Error| Failure::Usage(format!("{}: {error}", path.display()));
    let linked = std::fs::canonicalize(path);
    let path = linked.as_deref().unwrap_or(path);
    if path.exists() && !path.is_file() {
        return std::fs::write(path, bytes).map_err(fault);
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let written = File::create(&part)
        .and_then(|mut file| file.write_all(bytes))
        .and_then(|()| std::fs::rename(&part, path));
    if written.is_err() {
        let _ = std::fs::remove_file(&part);
    }
    written.map_err(fault)
}
