//! Profiles over m², for the core's tables.

use microbrdf::table::{SQUARE_KNOTS, SquareCurve};

/// 1.0 in a knot.
const ONE: f64 = 32_768.0;

/// A profile ξ/ξmax over m², linear between 129 knots from 0 to a clip, where
/// it is 1, and constant beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquareProfile {
    /// 15 fraction bits.
    knots: [u16; SQUARE_KNOTS],
    /// 65536/reach.
    inverse: u16,
}

impl SquareProfile {
    /// The profile that is `share` of m², for a `clip` of m from 1 to 2.
    ///
    /// Inner knots lie half of the chord's error off the curve, so that the
    /// error is centred on 0.
    #[must_use]
    pub fn new(share: impl Fn(f64) -> f64, clip: f64) -> Self {
        let inverse = (65_536.0 / (clip * clip)).round().clamp(16_384.0, 65_535.0) as u16;
        let last = SQUARE_KNOTS - 1;
        let at = |knot: f64| share(65_536.0 / f64::from(inverse) * knot / last as f64);
        let sag = |cell: usize| {
            let cell = cell as f64;
            0.5 * (at(cell) + at(cell + 1.0)) - at(cell + 0.5)
        };
        let mut knots = [0; SQUARE_KNOTS];
        for (index, knot) in knots.iter_mut().enumerate() {
            let value = if index == last {
                1.0
            } else if index == 0 {
                at(0.0)
            } else {
                at(index as f64) - 0.25 * (sag(index - 1) + sag(index))
            };
            *knot = (value.clamp(0.0, 1.0) * ONE).round() as u16;
        }
        Self { knots, inverse }
    }

    /// The core's table.
    ///
    /// # Panics
    /// Never: no knot passes 1, and no reach 4.
    #[must_use]
    pub fn curve(&self) -> SquareCurve {
        SquareCurve::new(self.knots, self.inverse)
            .expect("knots of at most 1, a reach of at most 4")
    }

    /// ξ/ξmax at m², as the table gives it.
    #[must_use]
    pub fn at(&self, square: f64) -> f64 {
        let last = SQUARE_KNOTS - 1;
        let position = (square * f64::from(self.inverse) / 65_536.0).min(1.0) * last as f64;
        let cell = (position as usize).min(last - 1);
        let [left, right] = [cell, cell + 1].map(|knot| f64::from(self.knots[knot]) / ONE);
        left + (right - left) * (position - cell as f64)
    }

    /// The arguments of the core's constructor, in Rust.
    #[must_use]
    pub fn code(&self) -> String {
        format!("{:?}, {}", self.knots, self.inverse)
    }
}
