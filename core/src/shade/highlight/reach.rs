//! Where a lobe may be seen.

use super::angle::Angle;
use super::wide::{UNIT, UNIT_BITS, clamp, product, quotient, root};

/// How far, of offsets over the cutoff's mantissa, pixels may be beyond the ends
/// of a lobe and still be taken for reached; as much again is for what is rounded
/// from one to the next.
pub(super) const SLACK: i64 = UNIT >> 16;

/// Where a lobe is seen, 30 fraction bits.
pub(super) struct Reach {
    pub(super) heights: [i64; 2],
    pub(super) along: [i64; 2],
    /// Across the azimuth, at most.
    across: i64,
    /// How much farther pixels may be along it that are taken for those that the
    /// lobe may reach.
    slack: i64,
}

impl Reach {
    /// That whose d is at most `radius`, 32 fraction bits.
    pub(super) const fn new(angle: &Angle, radius: i64) -> Self {
        let (sine, cosine) = (angle.sine, angle.cosine);
        let across = if cosine > 0 {
            quotient(radius << (UNIT_BITS - 2), cosine)
        } else {
            2 * UNIT
        };
        // The least N·h.
        let least = if across < UNIT {
            root(UNIT * UNIT - across * across)
        } else {
            0
        };
        let (aside, down) = ((cosine * radius) >> 32, (sine * radius) >> 32);
        Self {
            heights: [
                clamp(product(cosine, least) - down, 0, UNIT - 1),
                clamp(cosine + down, 0, UNIT - 1),
            ],
            along: [
                clamp(product(sine, least) - aside, -UNIT, UNIT),
                clamp(sine + aside, -UNIT, UNIT),
            ],
            across: if across < 2 * UNIT { across } else { 2 * UNIT },
            slack: clamp(quotient((2 * SLACK) << UNIT_BITS, cosine), 0, UNIT),
        }
    }

    /// How far z² may be below and above `lowest` where the lobe may reach.
    pub(super) const fn squares(&self, lowest: i64) -> [i64; 2] {
        // The azimuth's side is the farther one: the middle of the lobe is sinθ along it.
        let [from, to] = [self.along[0] - self.slack, self.along[1] + self.slack];
        let nearest = if from > 0 { from } else { 0 };
        let least = UNIT - product(to, to) - product(self.across, self.across);
        let most = UNIT - product(nearest, nearest);
        [lowest - least, most - lowest]
    }
}
