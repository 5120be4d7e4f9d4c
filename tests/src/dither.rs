//! `docs/dither.md`: what displays of few levels make of dark ramps, with a
//! dither and without.

use std::fmt::Write as _;

use microbrdf::shade::{LINEAR_ONE, Linear, grey16, grey16_nearest};
use microbrdf_reference::colour::lab;
use microbrdf_reference::decode_srgb;

/// Columns of a ramp; a cell of the dither has 4.
const WIDTH: usize = 512;
const HEIGHT: usize = 16;
const CELL: usize = 4;

/// A ramp from black to a colour, in linear light.
#[derive(Clone, Copy, Debug)]
pub struct Ramp {
    /// What it is called.
    pub name: &'static str,
    /// Its end.
    pub end: [f64; 3],
}

/// The ramps.
pub const RAMPS: [Ramp; 3] = [
    Ramp {
        name: "dark grey",
        end: [0.05; 3],
    },
    Ramp {
        name: "whole grey",
        end: [1.0; 3],
    },
    Ramp {
        name: "dark gold",
        end: [0.05, 0.038, 0.017],
    },
];

/// A display and whether it dithers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Display {
    /// 65 536 colours.
    Rgb565(bool),
    /// 16 greys.
    Grey16(bool),
}

impl Display {
    /// Each.
    pub const ALL: [Self; 4] = [
        Self::Rgb565(false),
        Self::Rgb565(true),
        Self::Grey16(false),
        Self::Grey16(true),
    ];

    /// What a pixel is sent as, and the share of full scale in sRGB code that
    /// each channel shows.
    fn shown(self, light: Linear, x: usize, y: usize) -> (u16, [f64; 3]) {
        match self {
            Self::Rgb565(dither) => {
                let packed = if dither {
                    light.rgb565_dithered(x, y)
                } else {
                    light.rgb565()
                };
                let share = |bits: u16, levels: u16| f64::from(bits) / f64::from(levels);
                let rgb = [
                    share(packed >> 11, 31),
                    share((packed >> 5) & 63, 63),
                    share(packed & 31, 31),
                ];
                (packed, rgb)
            }
            Self::Grey16(dither) => {
                let luminance = light.luminance();
                let level = if dither {
                    grey16(luminance, x, y)
                } else {
                    grey16_nearest(luminance)
                };
                (level.into(), [f64::from(level) / 15.0; 3])
            }
        }
    }
}

/// What a ramp looks like on a display.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Greatest number of pixels side by side that are sent as the same.
    pub flat_run: usize,
    /// Greatest difference in a* and b* between the mean light of a cell of
    /// 4 x 4 pixels and what was to be shown.
    pub cast: f64,
    /// Greatest difference in L*.
    pub lightness: f64,
}

/// Shows a ramp on a display.
#[must_use]
pub fn look(display: Display, ramp: Ramp) -> Look {
    let exact = |x: usize| ramp.end.map(|end| end * (x as f64 + 0.5) / WIDTH as f64);
    let light = |x: usize| {
        let [r, g, b] = exact(x).map(|value| (value * f64::from(LINEAR_ONE)).round() as u32);
        Linear::from_raw(r, g, b)
    };
    let mut look = Look {
        flat_run: 0,
        cast: 0.0,
        lightness: 0.0,
    };
    for y in 0..HEIGHT {
        let mut run = (u16::MAX, 0);
        for x in 0..WIDTH {
            let (sent, _) = display.shown(light(x), x, y);
            run = if x > 0 && sent == run.0 {
                (sent, run.1 + 1)
            } else {
                (sent, 1)
            };
            look.flat_run = look.flat_run.max(run.1);
        }
    }
    for left in (0..WIDTH).step_by(CELL) {
        let (mut mean, mut wanted) = ([0.0; 3], [0.0; 3]);
        for (x, y) in (0..CELL * CELL).map(|i| (left + i % CELL, i / CELL)) {
            let (_, shown) = display.shown(light(x), x, y);
            for channel in 0..3 {
                let part = 1.0 / (CELL * CELL) as f64;
                mean[channel] += part * decode_srgb(shown[channel]);
                wanted[channel] += part * exact(x)[channel];
            }
        }
        let ([l, a, b], [l0, a0, b0]) = (lab(mean), lab(wanted));
        look.lightness = look.lightness.max((l - l0).abs());
        look.cast = look.cast.max((a - a0).hypot(b - b0));
    }
    look
}

/// `docs/dither.md`.
#[must_use]
pub fn document() -> String {
    let mut text = format!(
        "# Displays of few levels\n\n\
         Made by `cargo run -p microbrdf-tests --bin accuracy`; `tests/tests/dither.rs` fails \
         when it is out of date.\n\n\
         RGB565 and 16 greys are dithered between two levels by a cell of 4 x 4 thresholds that \
         is fixed to the screen, so that nothing crawls when the scene moves; `dither = false` \
         in a scene turns it off. Ramps of {WIDTH} pixels from black, linear in light. The \
         flat run is the greatest number of pixels side by side that are sent as the same. \
         Colour cast and lightness are the greatest distances in a*b* and in L* between the mean \
         light of a cell and what was to be shown; 16 greys have no colour to keep, so the \
         golden ramp's own is their cast. A dither averages codes, not light, and its cells of \
         dark levels come out somewhat too light: a price of having no table of its own. Cycles \
         stand in [trade.md](trade.md) once measured (`rgb565`, `rgb565_dithered`, `grey16`, \
         `grey16_nearest`).\n\n\
         | ramp | display | dither | greatest flat run | colour cast | lightness |\n\
         | --- | --- | --- | --- | --- | --- |\n"
    );
    for ramp in RAMPS {
        for display in Display::ALL {
            let (name, dither) = match display {
                Display::Rgb565(dither) => ("RGB565", dither),
                Display::Grey16(dither) => ("16 greys", dither),
            };
            let look = look(display, ramp);
            let _ = writeln!(
                text,
                "| {} | {name} | {} | {} | {:.1} | {:.1} |",
                ramp.name,
                if dither { "on" } else { "off" },
                look.flat_run,
                look.cast,
                look.lightness
            );
        }
    }
    text
}
