//! A curve in cells of equal width, of which each has one value.

use super::scaled::ScaledTable;

/// A falling curve over a coordinate from 0, held at the middle of `CELLS`
/// cells: a power of two. Their width is one, too, so that half of them or more
/// are in use.
///
/// It is read with a shift and one look-up. Within a cell a curve that falls by
/// δ of its value is off by δ/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub(crate) struct DirectTable<const CELLS: usize> {
    // First, so that the table's address is theirs.
    cells: [u32; CELLS],
    /// From a coordinate to its cell.
    shift: u32,
    /// The last coordinate.
    end: u32,
}

impl<const CELLS: usize> DirectTable<CELLS> {
    /// Binary logarithm of the number of cells.
    const CELL_BITS: u32 = {
        assert!(
            CELLS >= 256 && CELLS <= 1 << 16 && CELLS.is_power_of_two(),
            "the number of cells must be a power of two from 256 to 65536"
        );
        CELLS.ilog2()
    };

    /// The values of `curve` down to `least`, which has an entry's fraction
    /// bits, times a `gain` with 32 fraction bits and shifted to the right.
    pub(crate) const fn new<const KNOTS: usize>(
        curve: &ScaledTable<KNOTS>,
        least: u32,
        gain: u64,
        shift: u32,
    ) -> Self {
        // The first coordinate that is below.
        let (mut above, mut end) = (0, 1u32 << 31);
        while end - above > 1 {
            let middle = above + (end - above) / 2;
            match curve.entry_at(middle) {
                Some(entry) if entry >= least => above = middle,
                _ => end = middle,
            }
        }
        let end = short(end);
        let end = if end.is_power_of_two() { end - 1 } else { end };
        let bits = u32::BITS - end.leading_zeros();
        let width = bits.saturating_sub(Self::CELL_BITS);
        let mut cells = [0; CELLS];
        let mut cell = 0;
        while cell < CELLS {
            let middle = ((2 * cell as u64 + 1) << width) / 2;
            cells[cell] = match curve.entry_at(middle as u32) {
                Some(entry) => ((entry as u128 * gain as u128) >> (32 + shift)) as u32,
                None => 0,
            };
            cell += 1;
        }
        Self {
            cells,
            shift: width,
            end,
        }
    }

    /// The entry at `coordinate`; `None` where the curve is below the least.
    #[inline(always)]
    pub(crate) fn entry_at(&self, coordinate: u32) -> Option<u32> {
        if coordinate <= self.end {
            Some(self.cells[(coordinate >> (self.shift % 32)) as usize % CELLS])
        } else {
            beyond();
            None
        }
    }
}

/// Says that what calls it is jumped to: light is what takes the most of its time.
#[cold]
const fn beyond() {}

/// The next number of eight significant bits, which an instruction of a core
/// with Thumb-2 holds.
const fn short(end: u32) -> u32 {
    let places = 24u32.saturating_sub(end.leading_zeros());
    end.div_ceil(1 << places) << places
}
