//! Pixels where N·V is small: no step of z² is small enough for its root.

use super::angle::Angle;
use super::lit_sphere::COEFFICIENT_BITS;
use super::lobe_colours::{BLACK, LESS_BITS, LobeColours, SUM_BITS, in_ratios};
use super::walk::Offsets;
use super::wide::{UNIT, UNIT_BITS, clamp, product, quotient};
use super::word::{FAR, WAY_BITS};
use crate::shade::root::Root;

/// Fraction bits of a ratio of the cosines.
const RATIO_BITS: u32 = 31;
const ONE: u64 = 1 << RATIO_BITS;
/// Fraction bits of `slope`.
const SLOPE_BITS: u32 = 29;
/// Fraction bits of the part that a ratio lacks: those of `slope` over z, and of d.
const PART_BITS: u32 = SLOPE_BITS - 1 + COEFFICIENT_BITS;

/// What such pixels take from the light, by a root of z² where others look up a step of
/// it: z, d and the ratio of the cosines keep their digits however small z is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edge {
    /// sinθ over the cutoff's mantissa, 28 fraction bits.
    tilt: u32,
    /// 2sinθ times that mantissa.
    slope: u32,
    /// How much smaller than its mantissa the cutoff is, in halvings.
    narrowness: u32,
    /// What has been taken from d for the middle of the lobe, in d's unit.
    height: i64,
}

impl Edge {
    /// For sinθ with 30 fraction bits, the cutoff with 32, what the first is over the
    /// other's mantissa with 28, and z in the middle of the lobe with 30.
    pub(super) const fn new(sine: i64, radius: u32, tilt: i64, middle: i64) -> Self {
        let narrowness = radius.leading_zeros();
        let mantissa = (radius as i64) << narrowness;
        // Twice the product of 30 and 32 fraction bits.
        let slope = (sine * mantissa) >> (UNIT_BITS + 32 - 1 - SLOPE_BITS);
        Self {
            tilt: tilt as u32,
            slope: slope as u32,
            narrowness,
            height: product(tilt, middle) << narrowness,
        }
    }

    /// The code at offsets d and b, of which d lacks z's part, for z² with 30 fraction bits.
    // From both ends of a row: once.
    #[inline(never)]
    pub(super) fn pixel<const COLOURS: usize, const FLAT: bool>(
        &self,
        colours: &LobeColours<COLOURS, FLAT>,
        at: Offsets,
        square: i64,
    ) -> u16 {
        if square <= 0 {
            return BLACK;
        }
        let square = square.min(UNIT - 1) as u64;
        let (root, inverse, halvings) = Root::of(square << (64 - UNIT_BITS)).parts();
        // 28 and 32 fraction bits.
        let lowered = u64::from(self.tilt).wrapping_mul(u64::from(root))
            >> (32 + halvings).saturating_sub(self.narrowness);
        let height = self.height.wrapping_sub(lowered as i64);
        if height.unsigned_abs() > FAR as u64 {
            return BLACK;
        }
        let d = at.d.wrapping_add(height as i32);

        let rounded = |offset: i32| offset.wrapping_add(1 << (WAY_BITS - 1)) >> WAY_BITS;
        let [down, aside] = [rounded(d), rounded(at.b)];
        let sum = (down.wrapping_mul(down)).wrapping_add(aside.wrapping_mul(aside));
        let mut x = LobeColours::<COLOURS, FLAT>::seen(sum);
        if d >= 0 {
            return colours.at(x);
        }
        // What the ratio is less than 1.
        let steep = u64::from(self.slope).wrapping_mul(u64::from(inverse)) >> 32;
        let less = steep.wrapping_mul(u64::from(d.unsigned_abs()))
            >> (PART_BITS - RATIO_BITS + self.narrowness).saturating_sub(halvings);
        let Some(ratio @ 1..) = ONE.checked_sub(less) else {
            return BLACK;
        };
        let mut ratio = ratio as u32;
        // Steps of a ratio are as fine as it is small.
        while ratio < (ONE / 2) as u32 {
            if x >> SUM_BITS != 0 {
                return BLACK;
            }
            x = colours.halved(x);
            ratio <<= 1;
        }
        let less = in_ratios((ONE as i64 - i64::from(ratio)) >> (RATIO_BITS - LESS_BITS));
        colours.at(colours.dimmed(|| x, less as i32))
    }
}

/// z² up to which pixels are the edge's if a step of z² is `1 << step_bits`, both with
/// 30 fraction bits: beyond, half a step is less than a level.
pub(super) const fn end<const COLOURS: usize, const FLAT: bool>(
    colours: &LobeColours<COLOURS, FLAT>,
    angle: &Angle,
    step_bits: u32,
) -> i64 {
    let (sine, cosine) = (angle.sine, angle.cosine);
    let radius = (colours.radius as i64) >> (32 - UNIT_BITS);

    // Half a step is sinθ · step/4z of d: in the middle of the lobe, where z is cosθ, too
    // much for all of it? Light that is white well beyond the middle shows more.
    let shift = quotient(sine << step_bits, product(cosine, radius) << 2);
    let white = colours.level_at(1, 4) == GREENS;
    if shift > (if white { 3 } else { 8 }) * (UNIT >> 11) {
        return UNIT;
    }
    // At the lobe's end x is twice as wrong as d: three quarters of a level.
    let steepness = colours.steepness as i64;
    let z = clamp(
        quotient(2 * sine * steepness, 3 * radius) << step_bits,
        0,
        UNIT,
    );
    // Where the ratio of the cosines goes to 0 it is −L·V · step/4z² wrong, half a level,
    // and 1 − R·V is 2cos²θ: if that is seen, the light is behind.
    let level = colours.level_at(cosine, radius);
    if level > BRIGHT {
        return UNIT;
    }
    let behind = UNIT - 2 * product(cosine, cosine);
    let steps = quotient(
        product(DARKEST / 2 * level * level, behind),
        GREENS * GREENS,
    );
    greater(product(z, z), greater(steps, LEAST) << step_bits)
}

/// Steps of z², whatever is seen there.
const LEAST: i64 = 4;
/// Levels of green.
const GREENS: i64 = 63;
/// Those that the whole of light would be at the slope of the darkest.
const DARKEST: i64 = 814;
/// A level beside the ratio's 0 from which on no step is fine enough.
const BRIGHT: i64 = 34;

const fn greater(a: i64, b: i64) -> i64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use fixed::types::U32F32;

    use super::*;
    use crate::Rgb;

    const ONE_UNIT: f64 = UNIT as f64;

    /// Which of its rules decides.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    enum Rule {
        Middle,
        White,
        End,
        Ratio,
        Bright,
        Least,
    }
    use Rule::*;

    /// The least and the greatest that [`end`] may be, as truncated as it is, in f64.
    fn expected(colours: &LobeColours<512>, angle: &Angle, step_bits: u32) -> (f64, f64, Rule) {
        let [sine, cosine] = [angle.sine, angle.cosine].map(|c| c as f64 / ONE_UNIT);
        let radius = f64::from(colours.radius >> (32 - UNIT_BITS)) / ONE_UNIT;
        let step = (f64::from(step_bits) - f64::from(UNIT_BITS)).exp2();

        let shift = sine * step / (4.0 * cosine * radius);
        let white = colours.level_at(1, 4) == 63;
        if shift > if white { 3.0 } else { 8.0 } / 2048.0 {
            return (1.0, 1.0, if white { White } else { Middle });
        }
        let level = colours.level_at(angle.cosine, i64::from(colours.radius) >> 2) as f64;
        if level >= 35.0 {
            return (1.0, 1.0, Bright);
        }
        let z = (sine * f64::from(colours.steepness) * step / (1.5 * radius)).min(1.0);
        let behind = 1.0 - 2.0 * cosine * cosine;
        let steps = 407.0 * level * level * behind / (63.0 * 63.0);
        let rules = [(z * z, End), (steps * step, Ratio), (4.0 * step, Least)];
        let (most, rule) =
            (rules.into_iter()).fold(
                (0.0, Least),
                |most, rule| {
                    if rule.0 > most.0 { rule } else { most }
                },
            );
        let least = (z - step)
            .max(0.0)
            .powi(2)
            .max((steps - 1.0).max(4.0) * step);
        (least, most, rule)
    }

    #[test]
    fn the_edge_ends_where_each_rule_says() {
        let mut decided = std::vec::Vec::new();
        for n in ["1", "1.5", "20", "500", "1e5", "1e8"] {
            for gain in ["0.002", "0.03", "1", "50"] {
                let [n, gain] = [n, gain]
                    .map(|number| U32F32::from_num(number.parse::<f64>().expect("a number")));
                let colours = LobeColours::<512>::new(n, Rgb::from_array([gain; 3])).unwrap();
                for angle in [0.0f64, 1e-3, 0.1, 0.9, 1.5, 1.6, 2.0, 2.6, 3.0, 3.1, 3.139] {
                    let angle = Angle::new([
                        (angle.sin() * ONE_UNIT) as i64,
                        0,
                        (angle.cos() * ONE_UNIT) as i64,
                    ]);
                    for step_bits in 2..27 {
                        let found = end(&colours, &angle, step_bits) as f64 / ONE_UNIT;
                        let (least, most, rule) = expected(&colours, &angle, step_bits);
                        let slack = 4.0 / ONE_UNIT + 1e-6 * most;
                        assert!(
                            (least - slack..=most + slack).contains(&found),
                            "{found} is not {least} to {most}: {rule:?}, n = {n}, K = {gain}, \
                             sin = {}, {step_bits}",
                            angle.sine,
                        );
                        decided.push(rule);
                    }
                }
            }
        }
        for rule in [Middle, White, End, Ratio, Bright, Least] {
            let count = decided.iter().filter(|decided| **decided == rule).count();
            assert!(count > 50, "{rule:?}: {count}");
        }
    }
}
