//! Where a lobe may be seen.

use super::angle::Angle;
use super::wide::{UNIT, UNIT_BITS, clamp, product, quotient, root};

/// Where a lobe is seen, 30 fraction bits.
pub(super) struct Reach {
    pub(super) heights: [i64; 2],
    pub(super) along: [i64; 2],
    /// Across the azimuth, at most.
    across: i64,
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
        }
    }

    /// How far z² is from `lowest` at most, for points within the lobe's reach.
    pub(super) const fn farthest(&self, lowest: i64) -> i64 {
        let [from, to] = self.along;
        let nearest = if from > 0 {
            from
        } else if to < 0 {
            to
        } else {
            0
        };
        let greatest = if to > -from { to } else { -from };
        let above = UNIT - product(nearest, nearest) - lowest;
        let below = lowest + product(greatest, greatest) + product(self.across, self.across) - UNIT;
        if above > below { above } else { below }
    }
}
