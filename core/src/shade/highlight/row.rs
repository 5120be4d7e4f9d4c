//! A row of a lit sphere's pixels.

use fixed::types::I2F30;

use super::lit_sphere::{COEFFICIENT_BITS, LitSphere, OFFSET_BITS, SLOPE_BITS, STEP_BITS, UNIT_BITS};
use super::lobe_colours::{LESS_BITS, LobeColours, SUM_BITS};

const _: () = assert!(OFFSET_BITS + SLOPE_BITS == LESS_BITS);

/// Fraction bits of an offset on its way along a row.
const WAY_BITS: u32 = 16;
/// Fraction bits of an offset where the lobe's ends are sought.
const COARSE_BITS: u32 = 26;

/// A row's way through a lobe.
struct Way {
    at: Offsets,
    apart: Offsets,
    squares: [i32; 3],
}

/// Offsets along and across the azimuth, with all their fraction bits.
#[derive(Clone, Copy)]
struct Wide {
    d: i64,
    b: i64,
}

impl Wide {
    fn plus(self, other: Self, times: usize) -> Self {
        Self {
            d: self.d.wrapping_add(other.d.wrapping_mul(times as i64)),
            b: self.b.wrapping_add(other.b.wrapping_mul(times as i64)),
        }
    }

    fn coarse(self) -> Offsets {
        const DROP: u32 = UNIT_BITS + COEFFICIENT_BITS - COARSE_BITS;
        Offsets {
            d: (self.d >> DROP) as i32,
            b: (self.b >> DROP) as i32,
        }
    }
}

/// The same in one word each.
#[derive(Clone, Copy)]
struct Offsets {
    d: i32,
    b: i32,
}

impl Offsets {
    fn plus(self, other: Self) -> Self {
        Self {
            d: self.d.wrapping_add(other.d),
            b: self.b.wrapping_add(other.b),
        }
    }

    fn minus(self, other: Self) -> Self {
        Self {
            d: self.d.wrapping_sub(other.d),
            b: self.b.wrapping_sub(other.b),
        }
    }
}

impl<const STEPS: usize> LitSphere<STEPS> {
    /// RGB565 codes of the pixels from `x` on, `step` apart, in the row at `y`:
    /// all in radii from the centre, each pixel within 2 of it. Beside the sphere
    /// and the lobe they are 0.
    pub fn row<const COLOURS: usize>(
        &self,
        colours: &LobeColours<COLOURS>,
        [x, y]: [I2F30; 2],
        step: I2F30,
        pixels: &mut [u16],
    ) {
        let [x, y, step] = [x, y, step].map(I2F30::to_bits);
        let start = self.offsets(x, y);
        let apart = self.offsets(step, 0);
        let coarse = apart.coarse();
        // From both ends to where the lobe may begin: what is left is contiguous.
        let mut at = start.coarse();
        let mut last = start.plus(apart, pixels.len().saturating_sub(1)).coarse();
        let mut first = 0;
        let mut rest = pixels.iter_mut();
        while !self.reaches(at) {
            let Some(pixel) = rest.next() else { return };
            *pixel = 0;
            first += 1;
            at = at.plus(coarse);
        }
        while !self.reaches(last) {
            let Some(pixel) = rest.next_back() else { return };
            *pixel = 0;
            last = last.minus(coarse);
        }
        let lobe = Way {
            at: self.fine(start.plus(apart, first), self.height),
            apart: self.fine(apart, 0),
            squares: self.squares(x.wrapping_add(step.wrapping_mul(first as i32)), y, step),
        };
        self.lobe(colours, lobe, rest.into_slice());
    }

    /// A point along and across the azimuth, or a difference of two.
    fn offsets(&self, x: i32, y: i32) -> Wide {
        let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
        let [p, q] = self.azimuth;
        Wide {
            d: product(p, x) + product(q, y),
            b: product(p, y) - product(q, x),
        }
    }

    /// The same in steps of 2⁻²⁸ of the cutoff's.
    fn fine(&self, wide: Wide, height: i32) -> Offsets {
        let drop = UNIT_BITS - (OFFSET_BITS + WAY_BITS - COEFFICIENT_BITS) - self.narrowness;
        Offsets {
            d: ((wide.d - (i64::from(height) << UNIT_BITS)) >> drop) as i32,
            b: (wide.b >> drop) as i32,
        }
    }

    /// z² in steps, its first and its second difference.
    fn squares(&self, x: i32, y: i32, step: i32) -> [i32; 3] {
        let [x, y, step] = [x, y, step].map(i64::from);
        let drop = UNIT_BITS - STEP_BITS + self.step_bits;
        let lowest = i64::from(self.lowest) << UNIT_BITS;
        [
            (1i64 << (2 * UNIT_BITS)) - x * x - y * y - lowest,
            -(2 * x + step) * step,
            -2 * step * step,
        ]
        .map(|square| (square >> drop) as i32)
    }

    /// Whether the lobe may reach a point.
    fn reaches(&self, at: Offsets) -> bool {
        const DROP: u32 = COEFFICIENT_BITS - COARSE_BITS;
        let [from, to] = self.along.map(|end| end >> DROP);
        // A step more, for what is rounded down.
        at.d >= from - 1 && at.d <= to + 1 && at.b.wrapping_abs() <= (self.across >> DROP) + 1
    }

    /// The pixels that may be in the lobe.
    fn lobe<const COLOURS: usize>(
        &self,
        colours: &LobeColours<COLOURS>,
        way: Way,
        pixels: &mut [u16],
    ) {
        let Way {
            mut at,
            apart,
            squares: [mut square, mut change, bend],
        } = way;
        for pixel in pixels {
            let cell = self.at(square);
            square = square.wrapping_add(change);
            change = change.wrapping_add(bend);
            let d = (at.d >> WAY_BITS).wrapping_add(i32::from(cell as u16 as i16));
            let b = at.b >> WAY_BITS;
            at = at.plus(apart);
            let x = d.wrapping_mul(d).wrapping_add(b.wrapping_mul(b)) as u32;
            *pixel = if x >= 1 << SUM_BITS {
                0
            } else if d >= 0 {
                colours.at(x)
            } else {
                colours.dimmed(x, (cell >> 16).wrapping_mul(d.unsigned_abs()))
            };
        }
    }
}
