//! A colour over the cosine of an angle: Fresnel reflectance, albedo.

use crate::colour::Rgb;

/// Cells in [0, 1/4), each 1/256 wide.
const FINE_CELLS: usize = 64;
/// Cells in [1/4, 1], each 1/64 wide.
const COARSE_CELLS: usize = 48;
/// Number of knots of a [`CosineCurve`].
pub const COSINE_KNOTS: usize = FINE_CELLS + COARSE_CELLS + 1;

/// Three channels tabulated over a cosine in [0, 1], 678 bytes.
///
/// Fresnel reflectance and albedo bend near grazing, so the quarter nearest
/// to it has four times narrower cells. Entries have 15 fraction bits and
/// reach just below 2: a spectral metal's red can pass 1. The host computes
/// them ([`CosineCurve::from_entries`]); the greatest error for each metal is
/// in `docs/accuracy.md`, tested in `tests/tests/tables.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CosineCurve {
    entries: [[u16; 3]; COSINE_KNOTS],
}

impl CosineCurve {
    /// A curve from the values at its knots, red, green and blue with 15
    /// fraction bits, from cosine 0 to 1; [`Self::knot`] tells which cosine
    /// each entry is at.
    #[must_use]
    pub const fn from_entries(entries: [[u16; 3]; COSINE_KNOTS]) -> Self {
        Self { entries }
    }

    /// The entries, as given to [`Self::from_entries`].
    #[must_use]
    pub const fn entries(&self) -> &[[u16; 3]; COSINE_KNOTS] {
        &self.entries
    }

    /// Cosine of knot `index` in units of 1/256; `index` past the last knot
    /// gets 256.
    #[must_use]
    pub const fn knot(index: usize) -> u16 {
        let units = if index < FINE_CELLS {
            index
        } else {
            FINE_CELLS + 4 * (index - FINE_CELLS)
        };
        if units < 256 { units as u16 } else { 256 }
    }

    /// Red, green and blue at cosine `knot`/`cells`, for `cells` a power of two
    /// to 256, with 15 fraction bits.
    pub(crate) const fn at_knot(&self, knot: usize, cells: usize) -> [u32; 3] {
        let units = knot * (256 / cells);
        let (left, within) = if units < FINE_CELLS {
            (units, 0)
        } else {
            let past = units - FINE_CELLS;
            (FINE_CELLS + past / 4, past as u32 % 4)
        };
        // Nothing lies beyond the last.
        if left >= COSINE_KNOTS - 1 {
            let [r, g, b] = self.entries[COSINE_KNOTS - 1];
            return [r as u32, g as u32, b as u32];
        }
        let [from, to] = [self.entries[left], self.entries[left + 1]];
        let mut values = [0; 3];
        let mut channel = 0;
        while channel < 3 {
            let (from, to) = (from[channel] as u32, to[channel] as u32);
            values[channel] = (from * (4 - within) + to * within + 2) / 4;
            channel += 1;
        }
        values
    }

    /// Red, green and blue at a cosine with 30 fraction bits; the result has
    /// 31. A cosine outside [0, 1] gets the nearest end.
    #[inline]
    pub(crate) fn at(&self, cosine: i32) -> [u32; 3] {
        let cosine = cosine.clamp(0, 1 << 30) as u32;
        // Cell, and the position within it with 16 fraction bits.
        let (cell, fraction) = if cosine < 1 << 28 {
            (cosine >> 22, (cosine >> 6) & 0xFFFF)
        } else {
            (
                FINE_CELLS as u32 - 16 + (cosine >> 24),
                (cosine >> 8) & 0xFFFF,
            )
        };
        let cell = cell as usize;
        let Some(left) = self.entries.get(cell) else {
            return [0; 3];
        };
        // At cosine 1 the cell is the last knot itself.
        let right = self.entries.get(cell + 1).unwrap_or(left);
        [0, 1, 2].map(|channel| {
            let (from, to) = (i32::from(left[channel]), i32::from(right[channel]));
            let rise = i64::from(to - from) * i64::from(fraction);
            ((i64::from(from) << 16) + rise) as u32
        })
    }

    /// As [`Self::at`] for a cosine that is not negative, in 32-bit steps; the
    /// result has 15 fraction bits.
    #[inline]
    pub(crate) fn at_short(&self, cosine: u32) -> [u32; 3] {
        // Cells with 8 fraction bits.
        let position = if cosine < 1 << 28 {
            cosine >> 14
        } else {
            (cosine >> 16) + ((FINE_CELLS as u32 - 16) << 8)
        };
        let cell = (position >> 8) as usize;
        let (Some(left), Some(right)) = (self.entries.get(cell), self.entries.get(cell + 1)) else {
            // From cosine 1 on.
            return self.entries[COSINE_KNOTS - 1].map(u32::from);
        };
        let within = (position & 0xFF) as i32;
        [0, 1, 2].map(|channel| {
            let (from, to) = (i32::from(left[channel]), i32::from(right[channel]));
            (from + (((to - from) * within) >> 8)) as u32
        })
    }

    /// As [`Self::at`], in single precision.
    #[inline]
    pub(crate) fn at_f32(&self, cosine: f32) -> Rgb<f32> {
        // False for what is not a number, too: it gets the first entry.
        let cosine = if cosine > 0.0 { cosine.min(1.0) } else { 0.0 };
        let position = if cosine < 0.25 {
            cosine * (4 * FINE_CELLS) as f32
        } else {
            cosine * 64.0 + (FINE_CELLS - 16) as f32
        };
        let cell = position as u32 as usize;
        let Some(left) = self.entries.get(cell) else {
            return Rgb::grey(0.0);
        };
        let right = self.entries.get(cell + 1).unwrap_or(left);
        let fraction = position - cell as f32;
        Rgb::from_array([0, 1, 2].map(|channel| {
            let (from, to) = (f32::from(left[channel]), f32::from(right[channel]));
            (from + (to - from) * fraction) / 32768.0
        }))
    }
}
