//! Reproducible random numbers.

use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A seeded generator (PCG) of doubles, which counts how many it gave.
#[derive(Debug, Clone)]
pub struct Random {
    generator: Pcg64Mcg,
    count: u64,
}

impl Random {
    /// The same seed gives the same numbers.
    pub fn new(seed: u64) -> Self {
        Self {
            generator: Pcg64Mcg::seed_from_u64(seed),
            count: 0,
        }
    }

    /// Uniform on 0 ≤ u < 1, in steps of 2⁻⁵³.
    pub fn uniform(&mut self) -> f64 {
        self.count += 1;
        (self.generator.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// How many numbers it has given.
    pub fn count(&self) -> u64 {
        self.count
    }
}
