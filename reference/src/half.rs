//! The half vector H = (L + V)/|L + V| without cancellation.

use crate::Direction;

/// Quantities of the half vector of two unit directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Half {
    /// tan²δ, δ between H and N: |h_P|²/h_z².
    pub tan2: f64,
    /// cosδ = N·H.
    pub cos: f64,
    /// L·H = V·H = |L + V|/2.
    pub lh: f64,
    /// Components of h along x and y, not normalised.
    pub h: [f64; 2],
    /// Component of h along N, NL + NV.
    pub z: f64,
}

impl Half {
    /// The half vector, or nothing where L = −V (both at the horizon).
    pub fn of(l: &Direction, v: &Direction) -> Option<Self> {
        let (x, y, z) = (l.x + v.x, l.y + v.y, l.z + v.z);
        let plane2 = x * x + y * y;
        let length = (plane2 + z * z).sqrt();
        if length == 0.0 {
            return None;
        }
        Some(Self {
            tan2: plane2 / (z * z),
            cos: z / length,
            lh: 0.5 * length,
            h: [x, y],
            z,
        })
    }

    /// cosⁿδ = exp(−(n/2) ln(1 + tan²δ)); 1 for n = 0.
    pub fn cos_power(&self, exponent: f64) -> f64 {
        if exponent == 0.0 {
            1.0
        } else {
            (-0.5 * exponent * self.tan2.ln_1p()).exp()
        }
    }

    /// The squared cosine and sine of the azimuth of H (along x where H = N).
    pub fn azimuth2(&self) -> (f64, f64) {
        let [x, y] = self.h;
        let plane2 = x * x + y * y;
        if plane2 == 0.0 {
            (1.0, 0.0)
        } else {
            (x * x / plane2, y * y / plane2)
        }
    }
}
