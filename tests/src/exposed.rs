//! Light of 16 bits, as tables that hold a light's gain give it, against the
//! reference.

use microbrdf::Rgb;
use microbrdf::arithmetic::Q15;
use microbrdf::fixed::types::U32F32;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf::shade::srgb8;
use microbrdf_reference::{self as reference, encode_srgb};
use microbrdf_scene::{HostArithmetic, Material};

use crate::arithmetic::rounded;
use crate::domain::{Pair, Set};
use crate::error::Subject;
use crate::frame::{Rotations, in_frame};

/// Pairs in each set.
pub const COUNT: usize = 1000;

/// A parameter in fixed point.
pub fn number(value: f64) -> U32F32 {
    U32F32::from_num(value)
}

/// The middle of a step, as 24 bits.
pub fn middle(light: Rgb<u16>) -> [u32; 3] {
    light.to_array().map(|light| u32::from(light) << 8 | 0x80)
}

/// How far light of 16 bits is off, in codes, for the share of each channel.
pub fn off(light: Rgb<u16>, k: f64, rho: [f64; 3]) -> f64 {
    let mut worst = 0.0f64;
    for (shown, rho) in middle(light).into_iter().zip(rho) {
        let code = 255.0 * encode_srgb((k * rho).clamp(0.0, 1.0));
        worst = worst.max((f64::from(srgb8(shown)) - code).abs());
    }
    worst
}

/// Pairs of every set, at which a lobe of exponent `n` shows light at K.
pub fn pairs(n: f64, k: f64) -> impl Iterator<Item = Pair> {
    let reach = 9.0 + k.max(1.0).ln();
    (Set::ALL.into_iter()).flat_map(move |set| set.pairs(n, reach, COUNT))
}

/// The greatest error in codes of `light`, over every set of pairs.
pub fn worst(
    material: &Material,
    n: f64,
    k: f64,
    light: impl Fn(&ShadingFrame<Q15>) -> Rgb<u16>,
) -> f64 {
    let exact = material.rounded::<Q15>().reference();
    let mut worst = 0.0f64;
    for pair in pairs(n, k) {
        let geometry = Subject::<Q15>::geometry(pair);
        let [l, v] = Subject::<Q15>::rounded(&geometry);
        worst = worst.max(off(light(&geometry), k, exact.rho(&l, &v)));
    }
    worst
}

/// The same in world space, of N, L and V. Pairs of which one is rounded to the
/// horizon or below are left out.
pub fn worst_in_world(
    material: &Material,
    n: f64,
    k: f64,
    light: impl Fn([Direction<Q15>; 3]) -> Rgb<u16>,
) -> f64 {
    let exact = material.rounded::<Q15>().reference();
    let mut rotations = Rotations::new(0x0E5D);
    let mut worst = 0.0f64;
    for pair in pairs(n, k) {
        let directions = rotations.turn(pair).map(rounded::<Q15>);
        let value = |d: Direction<Q15>| [d.x, d.y, d.z].map(Q15::<129>::component_value);
        let [n, l, v] = directions.map(value);
        let [l, v] = in_frame(n, l, v);
        if l[2] > 0.0 && v[2] > 0.0 {
            let [l, v] = [l, v].map(|[x, y, z]| reference::Direction::new(x, y, z));
            worst = worst.max(off(light(directions), k, exact.rho(&l, &v)));
        }
    }
    worst
}

/// Asserts that an error is what it was.
///
/// # Panics
/// If it is less or more.
pub fn within(found: f64, bounds: std::ops::RangeInclusive<f64>) {
    assert!(bounds.contains(&found), "{found} is not within {bounds:?}");
}
