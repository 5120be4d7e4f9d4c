//! Places in 32-bit fixed point.

use fixed::types::{I2F30, I8F24, I24F40, U1F31};

use super::{Placing, Sphere};
use crate::arithmetic::Q31;
use crate::geometry::Direction;

/// Fraction bits of a direction's component.
const DIRECTION: u32 = 30;
/// Fraction bits of a length.
const LENGTH: u32 = 24;
/// Greatest depth, 2¹⁶ scene units: past it no lamp is told from another.
const GREATEST_DEPTH: i64 = (1 << 40) - 1;

impl<const CELLS: usize> Placing for Q31<CELLS> {
    /// 24 fraction bits.
    type Place = [i64; 3];
    /// 32 fraction bits.
    type Dimming = u32;

    #[inline]
    fn place(d: &Direction<Self>, depth: i64) -> [i64; 3] {
        let coordinate = |d: I2F30| along(i64::from(d.to_bits()), depth);
        [coordinate(d.x), coordinate(d.y), coordinate(d.z)]
    }

    #[inline]
    fn odd_stripe(eye: I24F40, across: &[I24F40; 3], d: &Direction<Self>, depth: i64) -> bool {
        let part = |across: I24F40, d: I2F30| {
            // 30 fraction bits, so that the product has 60.
            (across.to_bits() >> 10).wrapping_mul(i64::from(d.to_bits())) >> DIRECTION
        };
        let slope = part(across[0], d.x)
            .wrapping_add(part(across[1], d.y))
            .wrapping_add(part(across[2], d.z));
        let position = (eye.to_bits() >> 16).wrapping_add(along(slope, depth));
        (position >> 24) & 1 != 0
    }

    #[inline]
    fn towards(place: &[i64; 3], lamp: &[I8F24; 3], near: I8F24) -> (Direction<Self>, u32) {
        let to = [0, 1, 2].map(|i| i64::from(lamp[i].to_bits()).wrapping_sub(place[i]));
        let bits = to.iter().fold(1, |bits, c| bits | c.unsigned_abs());
        // The greatest component gets 31 bits, whatever the distance.
        let top = 63 - bits.leading_zeros();
        let scaled = to.map(|c| {
            if top < 30 {
                c << (30 - top)
            } else {
                c >> (top - 30)
            }
        });
        let square = scaled.iter().fold(0, |sum: u64, c| {
            let magnitude = c.unsigned_abs();
            sum.wrapping_add(magnitude.wrapping_mul(magnitude))
        });
        let inverse = (1u64 << 62) / square.isqrt().max(1);
        let [x, y, z] =
            scaled.map(|c| I2F30::from_bits((c.wrapping_mul(inverse as i64) >> 32) as i32));
        // near / distance, 32 fraction bits.
        let reach = u64::from(near.to_bits().unsigned_abs()).wrapping_mul(inverse) >> top;
        let reach = reach.min(u64::from(u32::MAX));
        (Direction::new(x, y, z), ((reach * reach) >> 32) as u32)
    }

    #[inline]
    fn hides(
        sphere: &Sphere<Self>,
        place: &[i64; 3],
        l: &Direction<Self>,
        lamp: Option<&[I8F24; 3]>,
    ) -> bool {
        let radius = i64::from(sphere.radius.to_bits());
        // From the centre to the place, and on to the lamp.
        let from = [0, 1, 2].map(|i| {
            let eye = i64::from(sphere.eye[i].to_bits()).wrapping_mul(radius) >> LENGTH;
            eye.wrapping_add(place[i])
        });
        let to =
            lamp.map(|lamp| [0, 1, 2].map(|i| i64::from(lamp[i].to_bits()).wrapping_sub(place[i])));
        // Beyond 256 units fraction bits give way: 2⁻³² of the distance is left.
        let bits = from
            .iter()
            .chain(to.iter().flatten())
            .fold(0, |bits, c| bits | c.unsigned_abs());
        let shift = (32 - ((bits >> 32) as u32).leading_zeros()) % 64;
        let from = from.map(|c| c >> shift);
        let radius = radius >> shift;
        let l = [l.x, l.y, l.z].map(|c| i64::from(c.to_bits()));
        // Products have 62 bits; what they add up to is below 2⁶³.
        let along = |v: [i64; 3]| {
            let sum = v[0]
                .wrapping_mul(l[0])
                .wrapping_add(v[1].wrapping_mul(l[1]))
                .wrapping_add(v[2].wrapping_mul(l[2]));
            sum >> DIRECTION
        };
        let ahead = along(from).wrapping_neg();
        if ahead <= 0 {
            return false;
        }
        // A lamp before the nearest point is hidden only within the sphere.
        let beyond = match to {
            Some(to) => ahead.wrapping_sub(along(to.map(|c| c >> shift))).max(0),
            None => 0,
        };
        let aside = |i: usize, j: usize| {
            let difference = from[i]
                .wrapping_mul(l[j])
                .wrapping_sub(from[j].wrapping_mul(l[i]));
            difference >> DIRECTION
        };
        let mut square = 0u64;
        for leg in [beyond, aside(1, 2), aside(2, 0), aside(0, 1)] {
            let leg = leg.unsigned_abs();
            if leg > radius.unsigned_abs() {
                return false;
            }
            // Four squares of 31 bits.
            square = square.wrapping_add(leg.wrapping_mul(leg));
        }
        square < (radius.wrapping_mul(radius)) as u64
    }

    #[inline]
    fn narrow(dimming: u32, share: U1F31) -> u32 {
        let product = u64::from(dimming) * u64::from(share.to_bits());
        (product >> 31).min(u64::from(u32::MAX)) as u32
    }

    #[inline]
    fn dim(share: U1F31, dimming: u32) -> U1F31 {
        let product = u64::from(share.to_bits()) * u64::from(dimming);
        U1F31::from_bits((product >> 32) as u32)
    }
}

/// slope · depth for a slope with 30 fraction bits, of a magnitude below 64;
/// the result has the 24 of the depth.
#[inline]
fn along(slope: i64, depth: i64) -> i64 {
    let depth = depth.min(GREATEST_DEPTH);
    // In two halves, each of which has fewer than 63 bits.
    let high = slope.wrapping_mul(depth >> 16) >> (DIRECTION - 16);
    let low = slope.wrapping_mul(depth & 0xFFFF) >> DIRECTION;
    high.wrapping_add(low)
}
