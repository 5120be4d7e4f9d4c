//! Pairs of directions, made in integers.

/// L and V in the shading frame, each component with 30 fraction bits.
pub type Pair = [[i32; 3]; 2];

/// What a pair is there to reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairKind {
    /// Anywhere above the horizon.
    Random,
    /// V about R, from 1 to 2⁻²⁷ away.
    Lobe,
    /// V about L.
    Retro,
    /// V exactly at R, or a step beside it.
    Mirror,
    /// One cosine or both from 2⁻⁷ down to a step.
    Grazing,
    /// One below the horizon, or at it.
    Outside,
}

impl PairKind {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Random,
        Self::Lobe,
        Self::Retro,
        Self::Mirror,
        Self::Grazing,
        Self::Outside,
    ];
}

/// A seeded, endless sequence of pairs, in which the kinds take turns.
#[derive(Clone, Debug)]
pub struct Samples {
    state: u64,
    count: usize,
}

impl Samples {
    /// The sequence of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            state: seed,
            count: 0,
        }
    }

    /// SplitMix64.
    fn word(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// From −2³⁰ to 2³⁰.
    fn coordinate(&mut self) -> i64 {
        (self.word() >> 33) as i64 - (1 << 30)
    }

    fn below(&mut self, limit: u64) -> u32 {
        (self.word() % limit) as u32
    }

    /// A unit vector with z of this sign or 0.
    fn direction(&mut self, sign: i64) -> [i32; 3] {
        loop {
            let vector = [self.coordinate(), self.coordinate(), self.coordinate()];
            if let Some(unit) = normalised([vector[0], vector[1], sign * vector[2].abs()]) {
                return unit;
            }
        }
    }

    /// A unit vector about another, at a distance of about 2^−`bits`.
    fn about(&mut self, centre: [i32; 3], bits: u32) -> [i32; 3] {
        let moved = centre.map(|c| i64::from(c) + (self.coordinate() >> bits));
        normalised([moved[0], moved[1], moved[2].abs()]).unwrap_or(centre)
    }

    /// The next pair.
    pub fn pair(&mut self) -> Pair {
        let kind = PairKind::ALL[self.count % PairKind::ALL.len()];
        self.count += 1;
        let l = self.direction(1);
        let r = [-l[0], -l[1], l[2]];
        match kind {
            PairKind::Random => [l, self.direction(1)],
            PairKind::Lobe => {
                let bits = self.below(28);
                [l, self.about(r, bits)]
            }
            PairKind::Retro => {
                let bits = self.below(28);
                [l, self.about(l, bits)]
            }
            PairKind::Mirror => {
                let mut v = r;
                if self.below(2) == 1 {
                    v[self.below(2) as usize] += 1;
                }
                [l, v]
            }
            PairKind::Grazing => {
                let low = self.grazing(l);
                let other = if self.below(2) == 1 {
                    let opposite = [-low[0], -low[1], low[2]];
                    let near = self.about(opposite, 6);
                    self.grazing(near)
                } else {
                    let bits = self.below(8);
                    self.about([-low[0], -low[1], low[2]], bits)
                };
                if self.below(2) == 1 {
                    [low, other]
                } else {
                    [other, low]
                }
            }
            PairKind::Outside => {
                let mut under = self.direction(-1);
                if self.below(4) == 0 {
                    under[2] = 0;
                }
                if self.below(2) == 1 {
                    [l, under]
                } else {
                    [under, l]
                }
            }
        }
    }

    /// The same azimuth with a small cosine, lengthened to 1.
    fn grazing(&mut self, v: [i32; 3]) -> [i32; 3] {
        let shift = 7 + self.below(24);
        let z = i64::from(v[2]) >> shift;
        normalised([i64::from(v[0]), i64::from(v[1]), z]).unwrap_or(v)
    }
}

/// A vector of length 1, each component rounded down; `None` for a short one.
fn normalised(vector: [i64; 3]) -> Option<[i32; 3]> {
    let square: u64 = vector.iter().map(|c| (c * c) as u64).sum();
    let length = square.isqrt() as i64;
    if length < 1 << 20 {
        return None;
    }
    Some(vector.map(|c| ((c << 30) / length) as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_keep_to_the_length_that_the_core_asks_for() {
        let mut samples = Samples::new(1);
        for _ in 0..60_000 {
            for direction in samples.pair() {
                let square: f64 = direction.iter().map(|c| f64::from(*c).powi(2)).sum();
                let length = square.sqrt() / f64::from(1 << 30);
                assert!(length < 1.0 + 1e-4, "{direction:?} is {length} long");
                // One below the horizon may have lost its height.
                assert!(direction[2] == 0 || length > 1.0 - 1e-4, "{direction:?}");
            }
        }
    }
}
