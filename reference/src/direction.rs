//! Directions in the shading frame, where the normal N is +z.

/// A direction in the shading frame: `L` points to the light, `V` to the viewer.
///
/// The three components are taken as they are and never normalised again, so
/// that a value rounded to `f32` or to a fixed grid can be evaluated exactly.
/// The models are meant for lengths within 2⁻¹⁴ of 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction {
    /// Component along the tangent.
    pub x: f64,
    /// Component along the bitangent.
    pub y: f64,
    /// Component along the normal: the cosine of the angle to N.
    pub z: f64,
}

impl Direction {
    /// The surface normal.
    pub const NORMAL: Self = Self::new(0.0, 0.0, 1.0);

    /// A direction from its components, unchanged.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The direction at `theta` radians from the normal and `phi` radians of
    /// azimuth from +x.
    ///
    /// At `theta` = π/2 as a double the cosine is 6e-17, not 0: use
    /// [`Direction::from_cosine`] or [`Direction::from_degrees`] for the exact horizon.
    pub fn from_angles(theta: f64, phi: f64) -> Self {
        let s = theta.sin();
        Self::new(s * phi.cos(), s * phi.sin(), theta.cos())
    }

    /// As [`Direction::from_angles`], in degrees; 90 gives a cosine of exactly 0.
    pub fn from_degrees(theta: f64, phi: f64) -> Self {
        if theta == 90.0 {
            return Self::from_cosine(0.0, phi.to_radians());
        }
        Self::from_angles(theta.to_radians(), phi.to_radians())
    }

    /// The direction with the given cosine (−1 … 1) to the normal, held exactly
    /// however small it is, and `phi` radians of azimuth.
    pub fn from_cosine(cos_theta: f64, phi: f64) -> Self {
        let s = ((1.0 - cos_theta) * (1.0 + cos_theta)).max(0.0).sqrt();
        Self::new(s * phi.cos(), s * phi.sin(), cos_theta)
    }

    /// Mirrored at the normal (3.8): R for L, and the other way round.
    pub fn mirrored(self) -> Self {
        Self::new(-self.x, -self.y, self.z)
    }

    /// The dot product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The length, 1 up to rounding.
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// Scaled to length 1; the normal if the length is 0 or not finite.
    pub fn normalised(self) -> Self {
        let length = self.length();
        if length > 0.0 && length.is_finite() {
            Self::new(self.x / length, self.y / length, self.z / length)
        } else {
            Self::NORMAL
        }
    }

    /// The cross product.
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }
}

impl From<[f64; 3]> for Direction {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl From<Direction> for [f64; 3] {
    fn from(d: Direction) -> Self {
        [d.x, d.y, d.z]
    }
}
