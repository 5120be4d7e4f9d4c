//! Where a light is.

use super::wide::{UNIT, UNIT_BITS, quotient, root};

/// Half of the angle between L and V = +z, 30 fraction bits.
pub(super) struct Angle {
    pub(super) sine: i64,
    pub(super) cosine: i64,
    /// Of L in the picture, of length 1.
    pub(super) azimuth: [i64; 2],
}

impl Angle {
    pub(super) const fn new([x, y, z]: [i64; 3]) -> Self {
        // Below 2⁶⁴: a component is at most 2³¹.
        let square = (x * x) as u64 + (y * y) as u64 + (z * z) as u64;
        let length = square.isqrt() as i64;
        if length == 0 {
            return Self {
                sine: UNIT,
                cosine: 0,
                azimuth: [UNIT, 0],
            };
        }
        let [x, y, z] = [
            quotient(x << UNIT_BITS, length),
            quotient(y << UNIT_BITS, length),
            quotient(z << UNIT_BITS, length),
        ];
        let across = root(x * x + y * y);
        // The greater of the two first; the other by sin 2θ.
        let (sine, cosine) = if z >= 0 {
            let cosine = root((UNIT + z) << (UNIT_BITS - 1));
            (quotient(across << UNIT_BITS, 2 * cosine), cosine)
        } else {
            let sine = root((UNIT - z) << (UNIT_BITS - 1));
            (sine, quotient(across << UNIT_BITS, 2 * sine))
        };
        // At the pole any azimuth will do.
        let azimuth = if across < 16 {
            [UNIT, 0]
        } else {
            [
                quotient(x << UNIT_BITS, across),
                quotient(y << UNIT_BITS, across),
            ]
        };
        Self {
            sine,
            cosine,
            azimuth,
        }
    }
}
