//! Writes a synthetic 256 x 128 frame to standard output as it would go over
//! the wire, for receivers to be tried with:
//!
//! ```text
//! cargo run -p microbrdf-link --example synthetic_frame -- srgb8 > frame.bin
//! cargo run -p microbrdf-link --example synthetic_frame -- rgb565 7 > frame.bin
//! ```
//!
//! The first argument is the pixel format. With a second one, a number, the
//! frame goes over a bad line, and the number seeds the damage, which is told
//! on standard error. Red grows with the column, green with the row, blue with
//! both, modulo 256; `rgb565` keeps the upper bits of these.

use std::io::{self, Write as _};
use std::process::ExitCode;

use microbrdf_link::{FaultInjector, Faults, FrameWriter, Header, PixelFormat};

const WIDTH: u16 = 256;
const HEIGHT: u16 = 128;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((format, faults)) = parse(&arguments) else {
        eprintln!("usage: synthetic_frame srgb8|rgb565 [SEED], SEED from 0 to 2^64 - 1");
        return ExitCode::from(2);
    };
    match send(format, faults) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("synthetic_frame: {error}");
            ExitCode::FAILURE
        }
    }
}

fn parse(arguments: &[String]) -> Option<(PixelFormat, Faults)> {
    let (format, seed) = match arguments {
        [format] => (format, None),
        [format, seed] => (format, Some(seed.parse().ok()?)),
        _ => return None,
    };
    let format = match format.as_str() {
        "srgb8" => PixelFormat::Srgb8,
        "rgb565" => PixelFormat::Rgb565,
        _ => return None,
    };
    let faults = seed.map_or(Faults::default(), |seed| Faults {
        seed,
        drop_ppm: 10_000,
        duplicate_ppm: 10_000,
        flip_ppm: 10_000,
        lose_byte_ppm: 10_000,
        cut_after: None,
    });
    Some((format, faults))
}

fn send(format: PixelFormat, faults: Faults) -> Result<(), Box<dyn std::error::Error>> {
    let header = Header {
        exposure: Some(0.75),
        board: "none",
        core: "host",
        compiler: "rustc",
        arithmetic: "none",
        scene: "synthetic",
        ..Header::new(WIDTH, HEIGHT, format)
    };
    let mut line = FaultInjector::new(Vec::new(), faults);
    let mut writer = FrameWriter::begin(&mut line, &header)?;
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let [red, green, blue] = [x as u8, y as u8, (x + y) as u8];
            match format {
                PixelFormat::Srgb8 => writer.pixels(&[red, green, blue])?,
                PixelFormat::Rgb565 => {
                    let packed = u16::from(red >> 3) << 11
                        | u16::from(green >> 2) << 5
                        | u16::from(blue >> 3);
                    writer.pixels(&packed.to_le_bytes())?;
                }
            }
        }
    }
    writer.end()?;
    eprintln!("{:?}", line.damage());
    io::stdout().write_all(&line.into_inner())?;
    Ok(())
}
