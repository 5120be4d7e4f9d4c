//! From pixel to pixel of a row, in sums.

/// Pixels over which z² goes on in 32 bits; its last bits would count beyond.
pub(super) const CHUNK: i32 = 128;

/// d and b, or their differences.
#[derive(Clone, Copy, Debug)]
pub(super) struct Offsets {
    pub(super) d: i32,
    pub(super) b: i32,
}

/// What is known of a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// 28 fraction bits of the cutoff's, modulo 2³²: within the lobe it is what
    /// it says.
    pub(super) offsets: Offsets,
    /// z² above where steps begin, in steps with 50 fraction bits, modulo 2⁶⁴.
    pub(super) square: i64,
}

/// From a pixel to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) offsets: Offsets,
    /// Of z², and by how much it changes.
    pub(super) square: i64,
    pub(super) bend: i64,
}

impl Place {
    /// So many pixels on, fewer than 2¹⁶; the step is the one from there.
    pub(super) fn beyond(self, step: Step, pixels: u32) -> (Self, Step) {
        if cfg!(not(long_multiply)) && pixels == 0 {
            // Worth a look: the products are the most of a row's beginning.
            return (self, step);
        }
        // Of the changes 0, 1, … pixels − 1; half of their product would lose the
        // uppermost bit.
        let last = pixels.wrapping_sub(1);
        let (some, others) = if pixels % 2 == 0 {
            (pixels / 2, last)
        } else {
            (pixels, last / 2)
        };
        let changes = times(times(step.bend, some), others);
        let way = times(step.square, pixels).wrapping_add(changes);
        let place = Self {
            offsets: self.offsets.plus_times(step.offsets, pixels as i32),
            square: self.square.wrapping_add(way),
        };
        let square = step.square.wrapping_add(times(step.bend, pixels));
        (place, Step { square, ..step })
    }

    /// A pixel forwards.
    pub(super) fn forwards(&mut self, step: &mut Step) {
        self.offsets = self.offsets.plus(step.offsets);
        self.square = self.square.wrapping_add(step.square);
        step.square = step.square.wrapping_add(step.bend);
    }

    pub(super) fn backwards(&mut self, step: &mut Step) {
        step.square = step.square.wrapping_sub(step.bend);
        self.square = self.square.wrapping_sub(step.square);
        self.offsets = self.offsets.plus_times(step.offsets, -1);
    }
}

/// A pixel of a row, and the way to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Walk {
    pub(super) offsets: Offsets,
    /// z² in steps, 18 fraction bits, modulo 2³².
    pub(super) square: i32,
    /// From this pixel to the next.
    pub(super) step: Offsets,
    pub(super) change: i32,
    /// By how much `change` changes.
    pub(super) bend: i32,
}

impl Walk {
    /// From a place on.
    pub(super) fn new(place: Place, step: Step) -> Self {
        Self {
            offsets: place.offsets,
            square: upper(place.square),
            step: step.offsets,
            change: upper(step.square),
            bend: upper(step.bend),
        }
    }

    /// z² so many pixels on, at most [`CHUNK`].
    pub(super) fn square_after(self, pixels: i32) -> i32 {
        let changes = self.bend.wrapping_mul(pixels * (pixels - 1) / 2);
        let way = self.change.wrapping_mul(pixels).wrapping_add(changes);
        self.square.wrapping_add(way)
    }

    pub(super) fn forwards(&mut self) {
        // In the order in which they are wanted next: it decides what is kept in
        // registers.
        self.offsets.d = self.offsets.d.wrapping_add(self.step.d);
        self.square = self.square.wrapping_add(self.change);
        self.offsets.b = self.offsets.b.wrapping_add(self.step.b);
        self.change = self.change.wrapping_add(self.bend);
    }

    /// Forwards in z² alone.
    pub(super) fn climb(&mut self) {
        self.square = self.square.wrapping_add(self.change);
        self.change = self.change.wrapping_add(self.bend);
    }
}

pub(super) const fn upper(double: i64) -> i32 {
    (double >> 32) as i32
}

/// A product with a factor below 2¹⁶, without the last bits of what is multiplied.
const fn times(double: i64, factor: u32) -> i64 {
    // In two products of a word, where one of two words would be a call.
    let whole = upper(double).wrapping_mul(factor as i32);
    let part = (double as u32 >> 16).wrapping_mul(factor);
    ((whole as i64) << 32).wrapping_add((part as i64) << 16)
}

impl Offsets {
    pub(super) fn plus(self, other: Self) -> Self {
        self.plus_times(other, 1)
    }

    pub(super) fn plus_times(self, other: Self, times: i32) -> Self {
        Self {
            d: self.d.wrapping_add(other.d.wrapping_mul(times)),
            b: self.b.wrapping_add(other.b.wrapping_mul(times)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CHUNK, Offsets, Place, Step, Walk};

    #[test]
    fn z_squared_is_the_same_by_one_step_as_by_many() {
        let none = Offsets { d: 0, b: 0 };
        for [square, change, bend] in [[5, 7, -3], [-1_000, 123, -1], [1 << 29, -1 << 20, 9]] {
            let [square, change, bend] = [square, change, bend].map(|words: i64| words << 32);
            let step = Step {
                offsets: none,
                square: change,
                bend,
            };
            let start = Walk::new(
                Place {
                    offsets: none,
                    square,
                },
                step,
            );
            let mut walk = start;
            for pixels in 0..=CHUNK {
                assert_eq!(start.square_after(pixels), walk.square);
                walk.climb();
            }
        }
    }
}
