//! Rows of a lit sphere's pixels.

use core::slice::IterMut;

use fixed::types::I2F30;

use super::lit_sphere::{COEFFICIENT_BITS, LitSphere, STEP_BITS};
use super::lobe_colours::{BLACK, LESS_BITS, LobeColours};
use super::walk::{CHUNK, Offsets, Place, Step, Walk, upper};
use super::wide::UNIT_BITS;
use super::word::{OFFSET_BITS, SLOPE_BITS, WAY_BITS, Word};

/// Fraction bits of a step of z² from row to row: those of a step, and a word.
const SQUARE_BITS: u32 = STEP_BITS + 32;

/// An eighth of a step of z²: what a walk in words loses along a chunk is less, and
/// nothing is looked up before the first step.
const NEAR: i64 = 1 << (SQUARE_BITS - 3);

const _: () = assert!(OFFSET_BITS + SLOPE_BITS == LESS_BITS);

/// A picture of a sphere, row after row: made by [`LitSphere::rows`].
///
/// From a pixel to the next there are only sums.
#[derive(Clone, Copy, Debug)]
pub struct SphereRows<'a, const COLOURS: usize, const STEPS: usize, const FLAT: bool = false> {
    lit: &'a LitSphere<STEPS>,
    colours: &'a LobeColours<COLOURS, FLAT>,
    /// At the first pixel of the row that is next.
    coarse: Offsets,
    place: Place,
    /// From a pixel to the next.
    coarse_across: Offsets,
    across: Step,
    /// From a row to the next.
    coarse_down: Offsets,
    down: Step,
}

impl<const STEPS: usize> LitSphere<STEPS> {
    /// Rows of pixels that are `step` apart, along a row and from row to row,
    /// from `start` on: all in radii from the centre, x to the right and y
    /// upwards, each pixel within 2 of it in either. `colours` are those that the
    /// light was made for: others are shown with that one's width.
    #[must_use]
    pub fn rows<'a, const COLOURS: usize, const FLAT: bool>(
        &'a self,
        colours: &'a LobeColours<COLOURS, FLAT>,
        start: [I2F30; 2],
        step: [I2F30; 2],
    ) -> SphereRows<'a, COLOURS, STEPS, FLAT> {
        let [x, y] = start.map(|c| i64::from(c.to_bits()));
        let [across, down] = step.map(|c| i64::from(c.to_bits()));
        let zero = (1 << (2 * UNIT_BITS)) - (i64::from(self.lowest) << UNIT_BITS);
        let height = i64::from(self.height) << UNIT_BITS;
        SphereRows {
            lit: self,
            colours,
            coarse: self.coarse(x, y),
            place: Place {
                offsets: self.fine(x, y, height),
                square: self.in_steps(
                    zero.wrapping_sub(x.wrapping_mul(x))
                        .wrapping_sub(y.wrapping_mul(y)),
                ),
            },
            coarse_across: self.coarse(across, 0),
            across: self.step_of(self.fine(across, 0, 0), x, across),
            coarse_down: self.coarse(0, down),
            down: self.step_of(self.fine(0, down, 0), y, down),
        }
    }

    /// d and b of a point, with 58 fraction bits.
    const fn products(&self, x: i64, y: i64) -> [i64; 2] {
        let (p, q) = (self.azimuth[0] as i64, self.azimuth[1] as i64);
        [p * x + q * y, p * y - q * x]
    }

    fn coarse(&self, x: i64, y: i64) -> Offsets {
        let [d, b] = (self.products(x, y)).map(|offset| (offset >> UNIT_BITS) as i32);
        Offsets { d, b }
    }

    fn fine(&self, x: i64, y: i64, height: i64) -> Offsets {
        let drop = UNIT_BITS - (OFFSET_BITS + WAY_BITS - COEFFICIENT_BITS) - self.narrowness;
        let [d, b] = self.products(x, y);
        Offsets {
            d: ((d - height) >> drop) as i32,
            b: (b >> drop) as i32,
        }
    }

    /// From 60 fraction bits.
    // A picture begins with five of them, which need not stand there five times.
    #[inline(never)]
    const fn in_steps(&self, square: i64) -> i64 {
        const UP: u32 = SQUARE_BITS - UNIT_BITS;
        if self.step_bits <= UP {
            square << (UP - self.step_bits)
        } else {
            square >> (self.step_bits - UP)
        }
    }

    fn step_of(&self, offsets: Offsets, from: i64, step: i64) -> Step {
        Step {
            offsets,
            square: self.in_steps((2 * from + step).wrapping_mul(-step)),
            bend: self.in_steps((-2 * step).wrapping_mul(step)),
        }
    }

    /// Whether the lobe may reach a point.
    fn reaches(&self, at: Offsets) -> bool {
        // Each span in one comparison.
        let [from, length] = self.along;
        at.d.wrapping_sub(from) as u32 <= length as u32
            && at.b.wrapping_add(self.across) as u32 <= 2 * self.across as u32
    }

    /// Whether, of so many pixels, the one there is beyond the lobe's reach.
    #[inline(always)]
    fn misses(&self, at: Offsets, pixels: usize) -> bool {
        // That there is one at all is seen first where what is seen would else be
        // kept in a register; elsewhere it makes the code longer.
        (cfg!(long_multiply) || pixels > 0) && !self.reaches(at)
    }
}

impl<const COLOURS: usize, const STEPS: usize, const FLAT: bool>
    SphereRows<'_, COLOURS, STEPS, FLAT>
{
    /// RGB565 codes of the next row, of fewer than 2¹⁶ pixels: 0 beside the sphere
    /// and the lobe. From 2¹⁶ on, and for pixels farther from the centre than
    /// [`LitSphere::rows`] allows, they are any.
    pub fn shade(&mut self, pixels: &mut [u16]) {
        let count = pixels.len() as i32;
        // From both ends to where the lobe may begin: what is left is contiguous.
        let mut at = self.coarse;
        self.coarse = at.plus(self.coarse_down);
        let mut last = at.plus_times(self.coarse_across, count - 1);
        let mut first = 0u32;
        let mut rest = pixels.iter_mut();
        while self.lit.misses(at, rest.len()) {
            let Some(pixel) = rest.next() else { break };
            *pixel = BLACK;
            first += 1;
            at = at.plus(self.coarse_across);
        }
        while self.lit.misses(last, rest.len()) {
            let Some(pixel) = rest.next_back() else { break };
            *pixel = BLACK;
            last = last.plus_times(self.coarse_across, -1);
        }
        for pixels in rest.into_slice().chunks_mut(CHUNK as usize) {
            self.lobe(first, pixels);
            first = first.wrapping_add(CHUNK as u32);
        }

        let down = &mut self.down;
        self.place.offsets = self.place.offsets.plus(down.offsets);
        self.place.square = self.place.square.wrapping_add(down.square);
        down.square = down.square.wrapping_add(down.bend);
    }

    /// Pixels that may be in the lobe, so many before which there are in the row.
    // Inlined into the loop over chunks, it leaves more of its state on the stack.
    #[inline(never)]
    fn lobe(&self, before: u32, pixels: &mut [u16]) {
        let mut before = before;
        let mut walk = self.walk(before);
        let mut rest = pixels.iter_mut();
        if walk.square < upper(NEAR) {
            before = before.wrapping_add(self.edge_at_first(before, &mut rest));
            walk = self.walk(before);
        }
        let others = rest.len() as i32 - 1;
        if walk.square_after(others) < upper(NEAR) {
            self.edge_at_last(before.wrapping_add(others as u32), &mut rest);
        }
        if cfg!(long_multiply) {
            self.in_one_run(walk, rest.into_slice());
        } else {
            self.in_two_runs(walk, rest.into_slice());
        }
    }

    /// What is known where there are so many pixels before.
    #[inline(always)]
    fn walk(&self, before: u32) -> Walk {
        let (place, step) = self.place.beyond(self.across, before);
        Walk::new(place, step)
    }

    /// The pixels that are the edge's, from the first on; how many.
    #[cold]
    #[inline(never)]
    fn edge_at_first(&self, before: u32, pixels: &mut IterMut<'_, u16>) -> u32 {
        let (mut place, mut step) = self.place.beyond(self.across, before);
        let mut count = 0;
        while place.square < NEAR {
            let Some(pixel) = pixels.next() else { break };
            *pixel = self.edge(place);
            place.forwards(&mut step);
            count += 1;
        }
        count
    }

    /// The same from the last on.
    #[cold]
    #[inline(never)]
    fn edge_at_last(&self, before: u32, pixels: &mut IterMut<'_, u16>) {
        let (mut place, mut step) = self.place.beyond(self.across, before);
        while place.square < NEAR {
            let Some(pixel) = pixels.next_back() else {
                break;
            };
            *pixel = self.edge(place);
            place.backwards(&mut step);
        }
    }

    #[inline(always)]
    fn edge(&self, place: Place) -> u16 {
        if upper(place.square) < self.lit.beside {
            return BLACK;
        }
        let above = place.square >> (SQUARE_BITS - self.lit.step_bits);
        let square = i64::from(self.lit.lowest) + above;
        self.lit.edge.pixel(self.colours, place.offsets, square)
    }

    /// Pixels between the edges.
    #[inline(always)]
    fn in_one_run(&self, mut walk: Walk, pixels: &mut [u16]) {
        // Two pixels a turn: no core has registers for all of the loop's state.
        let mut pairs = pixels.chunks_exact_mut(2);
        for pair in &mut pairs {
            for pixel in pair {
                *pixel = self.pixel(walk.offsets, self.lit.at(walk.square));
                walk.forwards();
            }
        }
        for pixel in pairs.into_remainder() {
            *pixel = self.pixel(walk.offsets, self.lit.at(walk.square));
        }
    }

    /// The same in two runs, each of which needs fewer registers: z² alone, of
    /// which half a word waits where the code will be, and all else.
    #[inline(always)]
    fn in_two_runs(&self, walk: Walk, pixels: &mut [u16]) {
        let above = LitSphere::<STEPS>::ABOVE;
        let mut height = Walk {
            square: walk.square << above,
            change: walk.change << above,
            bend: walk.bend << above,
            ..walk
        };
        // Were the change's own change known to be the same all along, the compiler would
        // take multiples of it, for which there are no registers.
        let steady = core::hint::black_box(0);
        let mut fours = pixels.chunks_exact_mut(4);
        for four in &mut fours {
            for pixel in four {
                *pixel = (height.square as u32 >> 16) as u16;
                height.climb();
            }
            height.bend = height.bend.wrapping_add(steady);
        }
        for pixel in fours.into_remainder() {
            *pixel = (height.square as u32 >> 16) as u16;
            height.climb();
        }
        self.second_run(walk.offsets, walk.step, pixels);
    }

    // Not inlined, it has all registers.
    #[inline(never)]
    fn second_run(&self, first: Offsets, step: Offsets, pixels: &mut [u16]) {
        // In a `for` the next pixel is kept, too.
        pixels.iter_mut().fold(first, |at, pixel| {
            *pixel = self.pixel(at, self.lit.at_half(*pixel));
            at.plus(step)
        });
    }

    #[inline(always)]
    fn pixel(&self, at: Offsets, word: Word) -> u16 {
        // A word's lower half is part of its offset: it is rounded so.
        let d = at.d.wrapping_add(word.offset()) >> WAY_BITS;
        let x = || {
            let b = at.b >> WAY_BITS;
            LobeColours::<COLOURS, FLAT>::seen(d.wrapping_mul(d).wrapping_add(b.wrapping_mul(b)))
        };
        // Once for both ways, or, so that there is a register more until then, on each.
        let early = cfg!(long_multiply).then(x);
        let x = || early.unwrap_or_else(x);
        let x = if d < 0 {
            self.colours.dimmed(x, word.slope().wrapping_mul(d))
        } else {
            x()
        };
        self.colours.at(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rgb;
    use crate::arithmetic::Q31;
    use crate::geometry::Direction;
    use fixed::types::U32F32;

    fn both_ways<const COLOURS: usize, const STEPS: usize>(n: u32) {
        let gain = Rgb::from_array([U32F32::ONE, U32F32::ONE / 2, U32F32::ONE / 3]);
        let colours = LobeColours::<COLOURS>::new(n.into(), gain).unwrap();
        for x in [-0x3000_0000, 0, 0x2000_0000] {
            let l = Direction::<Q31>::new(
                I2F30::from_bits(x),
                I2F30::from_bits(0x1000_0000),
                I2F30::ONE / 2,
            );
            let lit = LitSphere::<STEPS>::new(&colours, l);
            let start = [I2F30::ONE / -2, I2F30::ONE / 8];
            let rows = lit.rows(&colours, start, [I2F30::ONE / 128; 2]);
            for before in 0..80 {
                let walk = rows.walk(before);
                let (mut once, mut twice) = ([1; CHUNK as usize], [2; CHUNK as usize]);
                let count = 3 * before as usize % CHUNK as usize;
                rows.in_one_run(walk, &mut once[..count]);
                rows.in_two_runs(walk, &mut twice[..count]);
                assert_eq!(once[..count], twice[..count]);
            }
        }
    }

    #[test]
    fn one_run_and_two_give_the_same_bits() {
        both_ways::<512, 512>(20);
        both_ways::<256, 256>(500);
        both_ways::<4096, 2048>(5);
        both_ways::<1, 1>(1);
    }
}
