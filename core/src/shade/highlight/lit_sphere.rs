//! A light's geometry on a sphere that is seen from afar.

use super::angle::Angle;
use super::edge::{self, Edge};
use super::lobe_colours::{LobeColours, in_ratios};
use super::reach::Reach;
use super::wide::{UNIT, UNIT_BITS, clamp, product, quotient, root};
use super::word::{OFFSET_BITS, SLOPE_BITS, WAY_BITS, Word};
use crate::arithmetic::Q31;
use crate::geometry::Direction;

/// Fraction bits of the coefficients.
pub(super) const COEFFICIENT_BITS: u32 = 28;
/// How far from the ends of a lobe pixels are still taken for reached, in the
/// unit of the coefficients.
const SLACK: i32 = (super::reach::SLACK >> (UNIT_BITS - COEFFICIENT_BITS)) as i32;
/// cosθ below which the highlight is a hair at the sphere's edge that no pixel shows.
const DARK: i64 = UNIT >> 12;
/// Fraction bits of a step of z².
pub(super) const STEP_BITS: u32 = 18;

/// A unit sphere, seen along −z from afar, under one distant light: what
/// [`Self::rows`] needs of the light and of the lobe's width, 4 · `STEPS` + 64
/// bytes; `STEPS` is a power of two.
///
/// With θ half of the angle between L and V, and the normal's components d
/// along L − V and b along V × L, 1 − R·V = 2d² + 2cos²θ·b²: a sum of squares,
/// so that 16 bits are enough for a lobe of any width. N·L < N·V where d < 0.
///
/// For a light that moves it is made anew for each picture: what that takes is
/// `q15_lit_sphere` in `docs/trade.md`. For one that does not it is a constant.
///
/// Codes are at most one level off, under a light in any direction, with 512 steps and
/// 512 colours for n from 1.5 on, to 1e8 at K = 1 and to 500 at the lobe's peak,
/// K = (n + 2)/2π; with 1024 of both for n from 1 on, and for n = 0 at K up to 1; with
/// 256 of both at K = 1 from n = 20 to 1e5. Pixels whose centre is within 1e-5 radii of
/// the sphere's edge have no bound, for n = 0 nor have those with |cosα| below 0.004, and
/// none is lit by a light within 0.03° of straight behind.
/// Tested in `tests/tests/highlight.rs`, in pictures of up to 3000 by 3000 pixels, and
/// in parts of spheres whose radius is up to 8192 pixels.
///
/// Where N·V is too small for a step of z² pixels take a root, and several times as
/// long: a rim for a light in front, narrower with more steps, and all that is lit for one
/// from behind whose highlight is along the edge. `q15_sphere_row_20_behind` in
/// `docs/trade.md` is what that takes.
///
/// ```
/// use microbrdf::arithmetic::Q31;
/// use microbrdf::fixed::types::{I2F30, U32F32};
/// use microbrdf::geometry::Direction;
/// use microbrdf::shade::{LitSphere, LobeColours};
/// use microbrdf::{Rgb, constant};
///
/// const GOLDEN: Rgb<U32F32> = Rgb {
///     r: U32F32::ONE,
///     g: U32F32::lit("0.7"),
///     b: U32F32::lit("0.3"),
/// };
/// static BALL: LobeColours = constant!(LobeColours::new(U32F32::lit("40"), GOLDEN));
/// // From the upper left, in front.
/// static LAMP: LitSphere = LitSphere::new(
///     &BALL,
///     Direction::<Q31>::new(I2F30::lit("-0.5"), I2F30::lit("0.5"), I2F30::lit("0.7071")),
/// );
///
/// // 32 rows of 32 pixels, the sphere's outline in their square.
/// let step = I2F30::ONE / 16;
/// let first = I2F30::ONE - step / 2;
/// let mut rows = LAMP.rows(&BALL, [-first, first], [step, -step]);
/// let mut brightest = 0;
/// for _ in 0..32 {
///     let mut row = [0; 32];
///     rows.shade(&mut row);
///     // To the display; here, to see that there is red at its greatest.
///     brightest = row.into_iter().fold(brightest, |most: u16, code| most.max(code >> 11));
/// }
/// assert_eq!(brightest, 31);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LitSphere<const STEPS: usize = 256> {
    /// Over steps of z², from the edge's pixels to where the lobe may reach.
    cells: [Word; STEPS],
    /// For those where z² is less: z falls steeply there.
    pub(super) edge: Edge,
    /// cosθ times the highlight's azimuth, over the cutoff's mantissa.
    pub(super) azimuth: [i32; 2],
    /// What is taken from d, in the same unit.
    pub(super) height: i32,
    /// How much smaller the cutoff is than that mantissa, in halvings.
    pub(super) narrowness: u32,
    /// z² where `cells` begins, and the binary logarithm of its steps.
    pub(super) lowest: i32,
    pub(super) step_bits: u32,
    /// z² in steps from there, 18 fraction bits, below which nothing is seen: of what is
    /// beside the sphere, or of all where the lobe reaches no pixels of the edge.
    pub(super) beside: i32,
    /// From where the lobe reaches along the azimuth, and how far.
    pub(super) along: [i32; 2],
    /// How far across it, to either side.
    pub(super) across: i32,
}

impl<const STEPS: usize> LitSphere<STEPS> {
    /// The light in the direction `l`, of any length, for the lobe of `colours`;
    /// of no length, nothing is lit.
    #[must_use]
    pub const fn new<const COLOURS: usize, const FLAT: bool>(
        colours: &LobeColours<COLOURS, FLAT>,
        l: Direction<Q31>,
    ) -> Self {
        const { assert!(STEPS.is_power_of_two()) }
        let angle = Angle::new([
            l.x.to_bits() as i64,
            l.y.to_bits() as i64,
            l.z.to_bits() as i64,
        ]);
        let (sine, cosine) = (angle.sine, angle.cosine);
        let radius = colours.radius as i64;
        // 1/radius as a mantissa from 1 to 2 and halvings.
        let narrowness = colours.radius.leading_zeros();
        let mantissa = quotient(1 << (32 + COEFFICIENT_BITS), radius << narrowness);

        let reach = Reach::new(&angle, radius);
        let [low, high] = reach.heights;
        let least = (low * low) >> UNIT_BITS;
        let mut step_bits = 0;
        let mut lowest;
        loop {
            let end = edge::end(colours, &angle, step_bits);
            lowest = if least > end { least } else { end };
            let [below, above] = reach.squares(lowest);
            // Nor must it wrap round where the lobe is sought.
            if above >> step_bits < STEPS as i64 && below >> step_bits < 1 << (31 - STEP_BITS) {
                break;
            }
            step_bits += 1;
        }
        let middle = (low + high) / 2;
        let tilt = product(sine, mantissa);
        let height = Height {
            tilt,
            middle,
            narrowness,
            steepness: (2 * sine * radius) >> 32,
        };
        let mut cells = [Word::BEYOND; STEPS];
        let mut cell = 0;
        while cell < STEPS {
            let steps = 2 * cell as i64 + 1;
            cells[cell] = height.word(lowest + (steps << step_bits) / 2);
            cell += 1;
        }
        let scaled = product(cosine, mantissa);
        // Nothing for a light straight behind.
        let [from, to] = if cosine < DARK {
            [1, 0]
        } else {
            [
                product(scaled, reach.along[0]) as i32,
                product(scaled, reach.along[1]) as i32,
            ]
        };
        Self {
            cells,
            edge: Edge::new(sine, colours.radius, tilt, middle),
            azimuth: [
                product(scaled, angle.azimuth[0]) as i32,
                product(scaled, angle.azimuth[1]) as i32,
            ],
            height: product(tilt, middle) as i32,
            narrowness,
            lowest: lowest as i32,
            beside: if lowest == least {
                i32::MAX
            } else {
                // Of steps so small there is nothing beside the sphere within the reach.
                -clamp((lowest << STEP_BITS) >> step_bits, 0, i32::MAX as i64) as i32
            },
            step_bits,
            along: [from - SLACK, to - from + 2 * SLACK],
            across: ((1 << COEFFICIENT_BITS) >> narrowness) + SLACK,
        }
    }

    /// The word at z² in steps from the first; where the lobe may reach
    /// it is none beyond the last.
    #[inline(always)]
    pub(super) const fn at(&self, square: i32) -> Word {
        self.cells[(square >> STEP_BITS) as usize % STEPS]
    }

    /// Bits of z² in steps above a cell's number.
    pub(super) const ABOVE: u32 = (32 - STEP_BITS).saturating_sub(STEPS.ilog2());

    /// The same for the upper half of z² without those bits.
    #[inline(always)]
    pub(super) const fn at_half(&self, half: u16) -> Word {
        self.cells[(half as u32 >> (STEP_BITS + Self::ABOVE - 16)) as usize % STEPS]
    }
}

/// What a word is made of.
struct Height {
    /// sinθ over the cutoff's mantissa.
    tilt: i64,
    middle: i64,
    narrowness: u32,
    /// 2sinθ · cutoff.
    steepness: i64,
}

impl Height {
    const fn word(&self, square: i64) -> Word {
        let z = if square < UNIT {
            root(square << UNIT_BITS)
        } else {
            UNIT
        };
        const DROP: u32 = COEFFICIENT_BITS - OFFSET_BITS - WAY_BITS;
        let offset = (product(self.tilt, self.middle - z) << self.narrowness) >> DROP;
        let slope = quotient(self.steepness << SLOPE_BITS, z);
        Word::new(offset, in_ratios(slope))
    }
}
