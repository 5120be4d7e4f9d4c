//! A fractional power of a cosine.

use super::integer::{LN_2, exp_neg, neg_ln_one_minus, round_to, times};

/// Cells over [1/2, 1].
const CELLS: usize = 64;
/// Octaves that a cosine with 30 fraction bits can fall into.
const OCTAVES: usize = 30;
const ENTRY_BITS: u32 = 31;
/// Bits of the position within a cell.
const FRACTION_BITS: u32 = 23;

/// c^q for a cosine c and an exponent q in [0, 1], 380 bytes.
///
/// c = 2^−k·μ with μ in [1/2, 1]: one table holds μ^q, one 2^(−k·q), so that
/// the error is at most 8e-6 of the value + 2⁻³⁰, tested in
/// `tests/tests/tables.rs`. For q near 1 the value itself falls to 2⁻³⁰.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CosinePowerTable {
    octaves: [u32; OCTAVES],
    mantissas: [u32; CELLS + 1],
}

impl CosinePowerTable {
    /// The table for exponent `q` in [0, 1], given with 32 fraction bits.
    pub(crate) const fn new(q: u64) -> Self {
        let mut octaves = [0; OCTAVES];
        let mut k = 0;
        while k < OCTAVES {
            octaves[k] = round_to(exp_neg(times(q, k as u128 * LN_2)), ENTRY_BITS);
            k += 1;
        }
        let mut mantissas = [0; CELLS + 1];
        let mut i = 0;
        while i <= CELLS {
            // 1 − μ in steps of 1/128.
            let below_one = ((CELLS - i) as u64) << 57;
            mantissas[i] = round_to(exp_neg(times(q, neg_ln_one_minus(below_one))), ENTRY_BITS);
            i += 1;
        }
        Self { octaves, mantissas }
    }

    /// c^q with 31 fraction bits for a cosine with 30; 0 for c ≤ 0, and 1
    /// from c = 1 on.
    #[inline]
    pub(crate) fn at(&self, cosine: i32) -> u32 {
        if cosine >= 1 << 30 {
            return 1 << ENTRY_BITS;
        }
        if cosine <= 0 {
            return 0;
        }
        let octave = cosine.leading_zeros() - 2;
        let mantissa = (cosine as u32) << octave;
        let cell = (mantissa >> FRACTION_BITS) as usize % CELLS;
        let fraction = u64::from(mantissa % (1 << FRACTION_BITS));
        let (left, right) = (self.mantissas[cell], self.mantissas[cell + 1]);
        let rise = (u64::from(right - left) * fraction) >> FRACTION_BITS;
        let Some(&scale) = self.octaves.get(octave as usize) else {
            return 0;
        };
        ((u64::from(scale) * (u64::from(left) + rise)) >> ENTRY_BITS) as u32
    }
}
