//! Profiles of patch mixtures, given as points.

use microbrdf::table::{PROFILE_KNOTS, ProfileCurve};

/// 1.0 in a knot.
const ONE: f64 = 2_147_483_648.0;

/// A profile ξ(m) of greatest value 1: linear between 129 distances, evenly
/// spaced from 0 to a reach of 2, 1, 1/2, … 2⁻¹⁰, and constant beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// 31 fraction bits.
    knots: [u32; PROFILE_KNOTS],
    halvings: u32,
}

impl Profile {
    /// The profile that is read off the lines between points (m, ξ), in the
    /// order of their distances, of which the first is 0; the reach is the
    /// least that holds them all. ξ is divided by its first value, which must
    /// be the greatest and above 0.
    #[must_use]
    pub fn through(points: &[[f64; 2]]) -> Self {
        let last = points.last().map_or(2.0, |point| point[0]);
        let halvings = (0..=ProfileCurve::MOST_HALVINGS)
            .rev()
            .find(|halvings| last <= reach(*halvings))
            .unwrap_or(0);
        let first = points.first().map_or(1.0, |point| point[1]);
        let mut knots = [0; PROFILE_KNOTS];
        for (index, knot) in knots.iter_mut().enumerate() {
            let m = reach(halvings) * index as f64 / (PROFILE_KNOTS - 1) as f64;
            let share = read(points, m) / first;
            *knot = (share.clamp(0.0, 1.0) * ONE).round() as u32;
        }
        Self { knots, halvings }
    }

    /// ξ at a distance m ≥ 0.
    #[must_use]
    pub fn at(&self, m: f64) -> f64 {
        let last = PROFILE_KNOTS - 1;
        let position = (m / reach(self.halvings)).clamp(0.0, 1.0) * last as f64;
        let cell = (position as usize).min(last - 1);
        let [left, right] = [cell, cell + 1].map(|knot| f64::from(self.knots[knot]) / ONE);
        left + (right - left) * (position - cell as f64)
    }

    /// The core's table.
    ///
    /// # Panics
    /// Never: no knot passes 1.
    #[must_use]
    pub fn curve(&self) -> ProfileCurve {
        ProfileCurve::new(self.knots, self.halvings).expect("knots of at most 1")
    }

    /// Where it stops to change.
    #[must_use]
    pub fn reach(&self) -> f64 {
        reach(self.halvings)
    }

    /// The arguments of the core's constructor, in Rust.
    pub(crate) fn code(&self) -> String {
        format!("{:?}, {}", self.knots, self.halvings)
    }
}

fn reach(halvings: u32) -> f64 {
    2.0 * 0.5f64.powi(halvings as i32)
}

/// The line between the points at m.
fn read(points: &[[f64; 2]], m: f64) -> f64 {
    for pair in points.windows(2) {
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        if m <= to {
            return low + (high - low) * (m - from) / (to - from);
        }
    }
    points.last().map_or(0.0, |point| point[1])
}

#[cfg(test)]
mod tests {
    use super::Profile;

    #[test]
    fn a_profile_goes_through_its_points() {
        let profile = Profile::through(&[[0.0, 4.0], [0.125, 3.0], [0.25, 1.0], [0.5, 0.5]]);
        assert_eq!(profile.reach(), 0.5);
        for (m, expected) in [(0.0, 1.0), (0.0625, 0.875), (0.25, 0.25), (0.375, 0.1875)] {
            assert!((profile.at(m) - expected).abs() < 1e-9, "{m}");
        }
        // Constant past the last point.
        assert!((profile.at(1.9) - 0.125).abs() < 1e-9);
        assert_eq!(Profile::through(&[[0.0, 1.0], [0.51, 0.0]]).reach(), 1.0);
    }
}
