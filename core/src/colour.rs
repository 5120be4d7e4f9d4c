//! Three channels.

/// Red, green and blue of anything: a reflectance, a factor, a radiance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgb<T> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl<T: Copy> Rgb<T> {
    /// The same in each channel.
    #[inline]
    pub const fn grey(value: T) -> Self {
        Self {
            r: value,
            g: value,
            b: value,
        }
    }

    /// From an array in the order red, green, blue.
    #[inline]
    pub const fn from_array([r, g, b]: [T; 3]) -> Self {
        Self { r, g, b }
    }

    /// As an array in the order red, green, blue.
    #[inline]
    pub const fn to_array(self) -> [T; 3] {
        [self.r, self.g, self.b]
    }

    /// `function` of each channel.
    #[inline]
    pub fn map<U>(self, mut function: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb {
            r: function(self.r),
            g: function(self.g),
            b: function(self.b),
        }
    }

    /// `function` of each channel of both.
    #[inline]
    pub fn zip<U: Copy, V>(self, other: Rgb<U>, mut function: impl FnMut(T, U) -> V) -> Rgb<V> {
        Rgb {
            r: function(self.r, other.r),
            g: function(self.g, other.g),
            b: function(self.b, other.b),
        }
    }
}

/// The greatest of three channels.
pub(crate) const fn greatest([r, g, b]: [u64; 3]) -> u64 {
    let most = if r > g { r } else { g };
    if most > b { most } else { b }
}
