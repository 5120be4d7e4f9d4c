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
/// Bits of each half of a shift's word.
const HALF_BITS: u32 = 16;
/// Fraction bits of a factor of x, and those of x that it does not see.
const RHO_BITS: u32 = 12;
const X_DROP: u32 = RHO_BITS;
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
/// A [`LitSphere`](super::LitSphere) says how exact that is. `CELLS` is a power of two up
/// to 4096; 2 · `CELLS` + 2056 bytes, the same in flash and filled at start-up.
///
/// `FLAT` are those of exponent 0, made by [`LobeColours::flat`]: a type of their own, so that
/// other lobes do not pay for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LobeColours<const CELLS: usize = 256, const FLAT: bool = false> {
    colours: [u16; CELLS],
    /// By what a ratio is less than 1; the last is beyond.
    shifts: [Shift; RATIOS],
    /// √(cutoff/2), 32 fraction bits.
    pub(super) radius: u32,
    /// Levels of green in a cutoff, at the slope of the lobe's darkest.
    pub(super) steepness: u32,
}

impl<const CELLS: usize> LobeColours<CELLS> {
    /// The lobe of exponent `n` with the gain K of each channel; too faint a gain
    /// leaves it black.
    ///
    /// # Errors
    /// `n` outside 1 to 1e8; for 0 there is [`LobeColours::flat`].
    pub const fn new(n: U32F32, gain: Rgb<U32F32>) -> Result<Self, ParameterError> {
        let n = match exponent::fixed(n) {
            Ok(n) if n > 0 => n,
            _ => return Err(ParameterError::new("exponent", "a number from 1 to 1e8")),
        };
        let gain = bits(gain);
        let cutoff = cutoff(n, gain);
        Ok(Self::of(
            n,
            gain,
            cutoff,
            radius(cutoff),
            steepness(n, cutoff),
        ))
    }
}

impl<const CELLS: usize> LobeColours<CELLS, true> {
    /// The lobe of exponent 0 with the gain K of each channel: K · cosΘL/cosΘmin (3.7)
    /// wherever α is below 90°, and nothing beyond.
    ///
    /// ```
    /// use microbrdf::Rgb;
    /// use microbrdf::fixed::types::U32F32;
    /// use microbrdf::shade::LobeColours;
    ///
    /// static SILVER: LobeColours<1024, true> = LobeColours::flat(Rgb::grey(U32F32::ONE));
    /// ```
    #[must_use]
    pub const fn flat(gain: Rgb<U32F32>) -> Self {
        // Of the exponent 1 a ratio is dimmed as it is; x is not seen.
        const ONCE: u64 = 1 << 32;
        let gain = bits(gain);
        Self::of(ONCE, gain, cutoff(ONCE, gain), radius(u64::MAX), 0)
    }
}

impl<const CELLS: usize, const FLAT: bool> LobeColours<CELLS, FLAT> {
    const CELL_SHIFT: u32 = SUM_BITS - CELLS.ilog2();

    const fn of(n: u64, gain: [u64; 3], cutoff: u64, radius: u32, steepness: u32) -> Self {
        const { assert!(CELLS.is_power_of_two() && CELLS <= 4096) }
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
        Self {
            colours,
            shifts,
            radius,
            steepness,
        }
    }

    /// What of a pixel's x tells its colour: of `FLAT` whether it is beyond.
    #[inline(always)]
    pub(super) const fn seen(x: i32) -> i32 {
        if FLAT { x >> SUM_BITS << SUM_BITS } else { x }
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
        self.shifts[HALF].moved_exactly(x)
    }

    /// The level of green, or what the other channels' are worth in it, where x is
    /// square(`offset`/`radius`), both in the same unit.
    pub(super) const fn level_at(&self, offset: i64, radius: i64) -> i64 {
        if offset >= radius {
            return 0;
        }
        // Below 1, with 15 fraction bits; of its square, 30.
        let part = if FLAT {
            0
        } else {
            quotient(offset << 15, radius)
        };
        let cell = (part * part * CELLS as i64) >> 30;
        let code = self.colours[cell as usize % CELLS] as i64;
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

const fn bits(gain: Rgb<U32F32>) -> [u64; 3] {
    [gain.r.to_bits(), gain.g.to_bits(), gain.b.to_bits()]
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

/// Of a cutoff of x, 64 fraction bits.
const fn radius(cutoff: u64) -> u32 {
    (cutoff >> 1).isqrt() as u32
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

/// How a ratio of the cosines moves x: with ρ = ratio^(1/n), in the upper half of a word
/// 1 − ρ over the cutoff with 16 fraction bits, in the lower half ρ with 12.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shift(u32);

impl Shift {
    /// Beyond any x.
    const BEYOND: Self = Self(u32::MAX << HALF_BITS);

    /// For the middle of a step of the ratio, from 1 down.
    const fn new(step: u64, n: u64, cutoff: u64) -> Self {
        const HALF_STEP: u64 = (ONE / (2 * (RATIOS as u128 - 1))) as u64;
        let y = divide(
            neg_ln_one_minus((2 * step + 1) * HALF_STEP) << 32,
            n as u128,
        );
        let rho = exp_neg(y);
        let shift = (divide((ONE - rho) << (HALF_BITS + 1), cutoff as u128) + 1) >> 1;
        // A cutoff is not told from more.
        let shift = if shift < 1 << HALF_BITS {
            shift as u32
        } else {
            u32::MAX >> HALF_BITS
        };
        Self(shift << HALF_BITS | round_to(rho, RHO_BITS))
    }

    /// The x that is as dim as this one with the ratio.
    #[inline(always)]
    pub(super) fn moved(self, x: i32) -> i32 {
        // 1 − (1 − x)·ρ, of x without its last bits.
        let kept = (x as u32 >> X_DROP).wrapping_mul(self.rho());
        kept.wrapping_add(self.shift()) as i32
    }

    /// As [`Self::moved`] for an x below the cutoff, of all of its bits but four.
    pub(super) fn moved_exactly(self, x: i32) -> i32 {
        const LOST: u32 = 4;
        let kept = (x as u32 >> LOST).wrapping_mul(self.rho()) >> (X_DROP - LOST);
        kept.wrapping_add(self.shift()) as i32
    }

    #[inline(always)]
    fn rho(self) -> u32 {
        u32::from(self.0 as u16)
    }

    /// The lower half, which is none of it, adds 2⁻²⁰ at most.
    #[inline(always)]
    fn shift(self) -> u32 {
        self.0 >> (2 * HALF_BITS - SUM_BITS)
    }
}

#[cfg(test)]
mod tests {
    use fixed::types::U32F32;

    use super::{BLACK, LESS_BITS, LobeColours, SUM_BITS, cell, in_ratios, saturated};
    use crate::Rgb;

    #[test]
    fn of_a_ratio_of_0_nothing_is_left() {
        let none = in_ratios(1 << LESS_BITS) as i32;
        let colours = LobeColours::<512>::new(20u32.into(), Rgb::grey(50u32.into())).unwrap();
        for x in [0, 1 << 20, (1 << SUM_BITS) - 1] {
            assert_eq!(colours.at(colours.dimmed(|| x, none)), BLACK);
        }
    }

    #[test]
    fn a_level_is_that_of_the_greatest_channel() {
        let tints = [
            ["1", "0.5", "0.2"],
            ["0.3", "0.8", "0.5"],
            ["0", "0.2", "0.4"],
        ];
        for tint in tints.map(|tint| tint.map(|share| share.parse::<U32F32>().unwrap())) {
            let colours = LobeColours::<512>::new(20u32.into(), Rgb::from_array(tint)).unwrap();
            for offset in 0..300 {
                let x = ((offset * offset) << SUM_BITS) / (256 * 256);
                let code = i64::from(colours.at(x as i32));
                let [red, green, blue] = [code >> 11, code >> 5 & 63, code & 31];
                // A level of red or blue is two of green, to one of them.
                let greatest = (2 * red).max(green).max(2 * blue);
                let level = colours.level_at(offset, 256);
                assert!(
                    (greatest..=greatest + 1).contains(&level),
                    "{offset}: {level}"
                );
            }
        }
    }

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
