//! Pictures as plain 8-bit RGB: reading what the emulator and the host made, and comparing.

use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::Path;

use png::{BitDepth, ColorType, Decoder, Encoder, Transformations};

use crate::failure::{During, Failure, Outcome};

/// A picture; rows from the top, three bytes a pixel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue of each pixel.
    pub rgb: Vec<u8>,
}

impl Picture {
    /// Reads a PNG file, of any colour type with 8 bits or fewer.
    pub fn read_png(path: &Path) -> Outcome<Self> {
        let name = || format!("reading {}", path.display());
        let mut decoder = Decoder::new(BufReader::new(File::open(path).during(name)?));
        decoder.set_transformations(Transformations::EXPAND | Transformations::STRIP_16);
        let mut reader = decoder.read_info().during(name)?;
        let size = reader
            .output_buffer_size()
            .ok_or_else(|| Failure::incomplete(format!("{}: too big", path.display())))?;
        let mut data = vec![0; size];
        let info = reader.next_frame(&mut data).during(name)?;
        data.truncate(info.buffer_size());
        let rgb = match info.color_type {
            ColorType::Rgb => data,
            ColorType::Rgba => data
                .chunks_exact(4)
                .flat_map(|p| [p[0], p[1], p[2]])
                .collect(),
            ColorType::Grayscale => data.iter().flat_map(|&p| [p, p, p]).collect(),
            ColorType::GrayscaleAlpha => data
                .chunks_exact(2)
                .flat_map(|p| [p[0], p[0], p[0]])
                .collect(),
            ColorType::Indexed => {
                return Err(Failure::incomplete(format!(
                    "{}: palette not expanded",
                    path.display()
                )));
            }
        };
        Ok(Self {
            width: info.width,
            height: info.height,
            rgb,
        })
    }

    /// Reads a binary PPM file, which every version of QEMU can write.
    pub fn read_ppm(path: &Path) -> Outcome<Self> {
        let data = fs::read(path).during(|| format!("reading {}", path.display()))?;
        parse_ppm(&data).ok_or_else(|| {
            Failure::incomplete(format!("{}: not a binary PPM of 8 bits", path.display()))
        })
    }

    /// Writes a PNG file.
    pub fn write_png(&self, path: &Path) -> Outcome<()> {
        let name = || format!("writing {}", path.display());
        let file = BufWriter::new(File::create(path).during(name)?);
        let mut encoder = Encoder::new(file, self.width, self.height);
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        let mut writer = encoder.write_header().during(name)?;
        writer.write_image_data(&self.rgb).during(name)?;
        writer.finish().during(name)
    }

    /// Pixels that differ; `None` where the sizes do.
    pub fn differing(&self, other: &Self) -> Option<usize> {
        if (self.width, self.height) != (other.width, other.height) {
            return None;
        }
        let pairs = self.rgb.chunks_exact(3).zip(other.rgb.chunks_exact(3));
        Some(pairs.filter(|(a, b)| a != b).count())
    }
}

/// `P6 WIDTH HEIGHT 255` and one white space, then the pixels.
fn parse_ppm(data: &[u8]) -> Option<Picture> {
    let mut at = 0;
    let mut word = || -> Option<&[u8]> {
        while data.get(at)?.is_ascii_whitespace() {
            at += 1;
        }
        let from = at;
        while !data.get(at)?.is_ascii_whitespace() {
            at += 1;
        }
        Some(&data[from..at])
    };
    if word()? != b"P6" {
        return None;
    }
    let mut number = || std::str::from_utf8(word()?).ok()?.parse::<u32>().ok();
    let (width, height, most) = (number()?, number()?, number()?);
    let rgb = data.get(at + 1..)?;
    let pixels = usize::try_from(u64::from(width) * u64::from(height)).ok()?;
    (most == 255 && rgb.len() == pixels.checked_mul(3)?).then(|| Picture {
        width,
        height,
        rgb: rgb.to_vec(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_by_one() -> Picture {
        Picture {
            width: 2,
            height: 1,
            rgb: vec![1, 2, 3, 10, 32, 255],
        }
    }

    #[test]
    fn ppm_whose_first_pixel_looks_like_white_space() {
        let picture = parse_ppm(b"P6\n1 1\n255\n\n \t").unwrap();
        assert_eq!(picture.rgb, [b'\n', b' ', b'\t']);
    }

    #[test]
    fn ppm_cut_short_or_of_another_kind_is_refused() {
        assert!(parse_ppm(b"P6\n2 1\n255\n12345").is_none());
        assert!(parse_ppm(b"P5\n1 1\n255\n1").is_none());
        assert!(parse_ppm(b"P6\n1 1\n65535\n123").is_none());
        assert!(parse_ppm(b"").is_none());
    }

    #[test]
    fn png_there_and_back() {
        let path = std::env::temp_dir().join(format!("microbrdf-{}.png", std::process::id()));
        two_by_one().write_png(&path).unwrap();
        let back = Picture::read_png(&path);
        fs::remove_file(&path).unwrap();
        assert_eq!(back.unwrap(), two_by_one());
    }

    #[test]
    fn differing_counts_pixels_not_bytes() {
        let mut other = two_by_one();
        assert_eq!(two_by_one().differing(&other), Some(0));
        other.rgb[3] = 0;
        other.rgb[5] = 0;
        assert_eq!(two_by_one().differing(&other), Some(1));
        other.width = 1;
        assert_eq!(two_by_one().differing(&other), None);
    }
}
