//! The profile of the kernels' patch mixture: ξ falls from 1 to 3/8 at
//! m = 1/4, and from there to 0 at m = 1.

use core::f64::consts::FRAC_1_PI;

use microbrdf::constant;
use microbrdf::table::{PROFILE_KNOTS, ProfileCurve};

/// C = 96/17π sr⁻¹: 1 over the integral of 2π·m·ξ(m) from 0 to 1.
pub const PEAK: f64 = 96.0 / 17.0 * FRAC_1_PI;

/// Its table: 31 fraction bits, 128 cells to m = 1.
pub const PROFILE: ProfileCurve = constant!(ProfileCurve::new(knots(), 1));

const fn knots() -> [u32; PROFILE_KNOTS] {
    let mut knots = [0; PROFILE_KNOTS];
    let mut i = 0;
    while i < PROFILE_KNOTS as u32 {
        let parts = if i < 32 { 256 - 5 * i } else { 128 - i };
        knots[i as usize] = parts << 23;
        i += 1;
    }
    knots
}
