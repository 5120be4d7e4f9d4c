//! What a metallic lobe shows under one light, by the versine.

use fixed::types::U32F32;

use super::wide::quotient;
use crate::arithmetic::exponent;
use crate::colour::{Rgb, greatest};
use crate::error::ParameterError;
use crate::shade::Linear;
use crate::table::integer::{ONE, divide, exp_neg, neg_ln_one_minus, power_of_one_minus, round_to};

/// Fraction bits of x over its cutoff.
pub(super) const SUM_BITS: u32 = 24;
/// Fraction bits of what a ratio is less than 1.
pub(super) const LESS_BITS: u32 = 20;
/// Steps of the ratio of two cosines.
const RATIO_BITS: u32 = 9;
const RATIOS: usize = 1 << RATIO_BITS;
/// Fraction bits of a shift over the cutoff.
const SHIFT_BITS: u32 = 31;
/// Fraction bits of a shift by itself, and where a word has it.
const OWN_BITS: u32 = 12;
const OWN: u32 = (1 << OWN_BITS) - 1;
/// Fraction bits of x that are multiplied with it.
const X_BITS: u32 = SUM_BITS - OWN_BITS;
/// The code of no light.
pub(super) const BLACK: u16 = 0;
/// Light, 64 fraction bits, that no channel of RGB565 shows: half of the
/// least level of green.
const UNSEEN: u128 = ONE / 1640;
/// ln 5, 64 fraction bits.
const LN_5: u128 = 0x1_9C04_1F7E_D8D3_36AF;

/// RGB565 codes of K · cosⁿα · cosΘL/cosΘmin (3.7), in `CELLS` steps of
/// x = 1 − cosα from the mirror direction to where nothing is seen.
///
/// Where cosΘL is less than cosΘV the ratio of the two dims the lobe as much as
/// a greater x would, by a second table: x with a ratio r is 1 − (1 − x)·r^(1/n).
/// A [`LitSphere`](super::LitSphere) says how exact that is. 2 · `CELLS` + 2056 bytes,
/// the same in flash and filled at start-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LobeColours<const CELLS: usize = 256> {
    colours: [u16; CELLS],
    /// By what a ratio is less than 1; the last is beyond.
    shifts: [Shift; RATIOS],
    /// √(cutoff/2), 32 fraction bits.
    pub(super) radius: u32,
    /// Levels of green in a cutoff, at the slope of the lobe's darkest.
    pub(super) steepness: u32,
}

impl<const CELLS: usize> LobeColours<CELLS> {
    const CELL_SHIFT: u32 = SUM_BITS - CELLS.ilog2();

    /// The lobe of exponent `n` with the gain K of each channel; too faint a gain
    /// leaves it black.
    ///
    /// # Errors
    /// `n` outside 1 to 1e8.
    pub const fn new(n: U32F32, gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        const { assert!(CELLS.is_power_of_two() && CELLS <= 4096) }
        let n = match exponent::fixed(n) {
            Ok(n) if n > 0 => n,
            _ => return Err(ParameterError::new("exponent", "a number from 1 to 1e8")),
        };
        let gain = [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()];
        let cutoff = cutoff(n, gain);
        let mut colours = [0; CELLS];
        let mut cell = 0;
        // The last one is black, for what is beyond.
        while cell < CELLS - 1 {
            let x = (cutoff as u128 * (2 * cell as u128 + 1)) >> (CELLS.ilog2() + 1);
            let share = power_of_one_minus(x as u64, n);
            colours[cell] = Linear::from_raw(
                light(gain[0], share),
                light(gain[1], share),
                light(gain[2], share),
            )
            .rgb565();
            cell += 1;
        }
        let mut shifts = [Shift::BEYOND; RATIOS];
        let mut cell = 0;
        while cell < RATIOS - 1 {
            shifts[cell] = Shift::new(cell as u64, n, cutoff);
            cell += 1;
        }
        Ok(Self {
            colours,
            shifts,
            radius: (cutoff >> 1).isqrt() as u32,
            steepness: steepness(n, cutoff),
        })
    }

    /// The code at x, in cutoffs with 24 fraction bits; black beyond.
    #[inline(always)]
    pub(super) fn at(&self, x: i32) -> u16 {
        match self.colours.get(cell::<CELLS>(x, Self::CELL_SHIFT)) {
            Some(code) => *code,
            None => BLACK,
        }
    }

    /// The x that is as dim as this one with a ratio of the cosines below 1, less
    /// by `less` as [`in_ratios`] has it.
    #[inline(always)]
    pub(super) fn dimmed(&self, x: impl FnOnce() -> i32, less: i32) -> i32 {
        match (self.shifts).get(cell::<RATIOS>(less, LESS_BITS - RATIO_BITS)) {
            Some(shift) => shift.moved(x()),
            None => i32::MAX,
        }
    }

    /// The x that is half as bright as this one.
    pub(super) fn halved(&self, x: i32) -> i32 {
        // Its middle is a half.
        const HALF: usize = RATIOS / 2 - 1;
        self.shifts[HALF].moved(x)
    }

    /// The level of green, or what the other channels' are worth in it, where x is
    /// square(`offset`/`radius`), both in the same unit.
    pub(super) const fn level_at(&self, offset: i64, radius: i64) -> i64 {
        if offset >= radius {
            return 0;
        }
        // Below 1, with 15 fraction bits; of its square, 30.
        let part = quotient(offset << 15, radius);
        let cell = (part * part * CELLS as i64) >> 30;
        let code = self.colours[cell as usize] as i64;
        let [red, green, blue] = [code >> 10 & 63, code >> 5 & 63, code << 1 & 63];
        let most = if red > green { red } else { green };
        if most > blue { most } else { blue }
    }
}

/// What a ratio is less than 1, so that nothing is left of it at the last cell.
pub(super) const fn in_ratios(less: i64) -> i64 {
    (less * (RATIOS as i64 - 1)) >> RATIO_BITS
}

/// The index of a cell, from so many bits up; for pixels that are within the picture
/// it is not negative. What is beyond is the last cell, or none, which is the same.
#[inline(always)]
fn cell<const CELLS: usize>(number: i32, bits: u32) -> usize {
    if cfg!(saturates) {
        saturated::<CELLS>(number, bits)
    } else {
        (number as u32 >> bits) as usize
    }
}

/// In one instruction, where a comparison takes two.
#[inline(always)]
fn saturated<const CELLS: usize>(number: i32, bits: u32) -> usize {
    (number >> bits).clamp(0, CELLS as i32 - 1) as usize
}

/// x, 64 fraction bits, beyond which `UNSEEN` is more than the light.
const fn cutoff(n: u64, gain: [u64; 3]) -> u64 {
    let most = greatest(gain);
    let least = divide(UNSEEN << 32, most as u128);
    // An unseen lobe has a cutoff all the same.
    let y = if most == 0 || least >= ONE / 2 {
        ONE / 2
    } else {
        neg_ln_one_minus((ONE - least) as u64)
    };
    let cutoff = ONE - exp_neg(divide(y << 32, n as u128));
    if cutoff < ONE {
        cutoff as u64
    } else {
        u64::MAX
    }
}

/// By how many levels of green a cutoff of x would change the code if all of it were as
/// steep as the darkest: K · (1 − x)ⁿ has the slope n/(1 − x) of itself, and sRGB is
/// straight up to five times what is seen last, half a level.
const fn steepness(n: u64, cutoff: u64) -> u32 {
    const MOST: u128 = 1 << 20;
    // 32 fraction bits, as of n.
    let power = (n as u128 * (cutoff as u128 >> 32)) >> 32;
    let fifth_root = exp_neg(divide(LN_5 << 32, n as u128));
    let slope = (5 * power * (fifth_root >> 32)) >> 33;
    let steepness = divide(slope << 32, ONE - cutoff as u128);
    if steepness < MOST {
        steepness as u32
    } else {
        MOST as u32
    }
}

/// Linear light of 24 fraction bits.
const fn light(gain: u64, share: u128) -> u32 {
    // 32 and 40 fraction bits.
    let light = (gain as u128 * (share >> 24)) >> 48;
    if light < u32::MAX as u128 {
        light as u32
    } else {
        u32::MAX
    }
}

/// How a ratio of the cosines moves x: 1 − ρ, ρ = ratio^(1/n), over the cutoff
/// with 31 fraction bits, of which the lowest 9 are those of 1 − ρ itself. All is
/// doubled: from the middle of a word two shifts take these, without a mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shift(u32);

impl Shift {
    /// Beyond any x.
    const BEYOND: Self = Self(!OWN << 1);

    /// For the middle of a step of the ratio, from 1 down.
    const fn new(step: u64, n: u64, cutoff: u64) -> Self {
        const HALF_STEP: u64 = (ONE / (2 * (RATIOS as u128 - 1))) as u64;
        let y = divide(
            neg_ln_one_minus((2 * step + 1) * HALF_STEP) << 32,
            n as u128,
        );
        let moved = ONE - exp_neg(y);
        let own = round_to(moved, OWN_BITS);
        let shift = divide(moved << SHIFT_BITS, cutoff as u128);
        // A cutoff is not told from more.
        let shift = if shift < 1 << SHIFT_BITS {
            shift as u32
        } else {
            u32::MAX >> 1
        };
        Self(((shift & !OWN) | if own < OWN { own } else { OWN }) << 1)
    }

    /// The x that is as dim as this one with the ratio.
    #[inline(always)]
    pub(super) fn moved(self, x: i32) -> i32 {
        // 1 − (1 − x)·ρ: x + (1 − ρ) − x(1 − ρ), at least 1 where x is. A word's last
        // bits, which are not the sum's, add 3 · 2⁻²⁴.
        let own = (self.0 >> 1) & OWN;
        let taken = (x as u32 >> (SUM_BITS - X_BITS)).wrapping_mul(own);
        let moved = (x as u32).wrapping_add(self.0 >> (SHIFT_BITS + 1 - SUM_BITS));
        moved.wrapping_sub(taken) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::{cell, saturated};

    #[test]
    fn both_ways_to_a_cell_agree() {
        for number in (0..=i32::MAX).step_by(0xFFF1).chain([1 << 24, i32::MAX]) {
            for bits in [11, 16] {
                let plain = cell::<256>(number, bits).min(255);
                assert_eq!(saturated::<256>(number, bits), plain, "{number}");
            }
        }
        assert_eq!(saturated::<256>(-1, 16), 0);
    }
}
