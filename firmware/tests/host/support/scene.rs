//! A scene without reflections, whose every pixel is another, and which takes its time.

use std::cell::RefCell;

use microbrdf::shade::{LINEAR_ONE, Linear};
use microbrdf_firmware::Scene;

use super::SlowLine;

/// What happened while a row was shaded.
#[derive(Clone, Copy, Debug)]
pub struct Shading {
    pub ticks: u64,
    /// Bytes that the line sent meanwhile.
    pub bytes_sent: usize,
}

/// A frame of `W` x `H`.
pub struct Stripes<'l, 'q, const W: u16, const H: u16> {
    line: Option<&'l SlowLine<'q>>,
    ticks_per_pixel: u64,
    rows: RefCell<Vec<Shading>>,
}

impl<'l, 'q, const W: u16, const H: u16> Stripes<'l, 'q, W, H> {
    /// Shading that takes no time.
    pub fn instant() -> Self {
        Self {
            line: None,
            ticks_per_pixel: 0,
            rows: RefCell::default(),
        }
    }

    /// Shading during which `line` goes on sending.
    pub fn slow(line: &'l SlowLine<'q>, ticks_per_pixel: u64) -> Self {
        Self {
            line: Some(line),
            ticks_per_pixel,
            rows: RefCell::default(),
        }
    }

    /// Light of a pixel.
    pub fn light(x: usize, y: usize) -> Linear {
        let part = |numerator: usize, denominator: u16| {
            (u64::from(LINEAR_ONE) * numerator as u64 / u64::from(denominator)) as u32
        };
        Linear::from_raw(part(x, W), part(y, H), part(x + y, W + H) / 3)
    }

    /// What happened in each row so far.
    pub fn rows(&self) -> Vec<Shading> {
        self.rows.borrow().clone()
    }
}

impl<const W: u16, const H: u16> Scene for Stripes<'_, '_, W, H> {
    const NAME: &'static str = "stripes";
    const ARITHMETIC: &'static str = "none";
    const EXPOSURE: f64 = 0.75;
    const DITHER: bool = true;
    const WIDTH: u16 = W;
    const HEIGHT: u16 = H;

    fn shade_row(&self, y: usize, mut sink: impl FnMut(usize, Linear)) {
        let before = self.line.map(|line| (line.now(), line.bytes_sent()));
        for x in 0..usize::from(W) {
            if let Some(line) = self.line {
                line.pass(self.ticks_per_pixel);
            }
            sink(x, Self::light(x, y));
        }
        if let (Some(line), Some((ticks, bytes))) = (self.line, before) {
            self.rows.borrow_mut().push(Shading {
                ticks: line.now() - ticks,
                bytes_sent: line.bytes_sent() - bytes,
            });
        }
    }
}
