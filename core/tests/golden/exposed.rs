//! Lobes and patches with a light's gain in their tables.

use microbrdf_bits::exposed_checksums;

use crate::Sums;

/// Pairs of directions for each of 48 models of a kind.
const COUNT: usize = 192;

/// Adds a sum for each kind.
pub fn add(sums: &mut Sums) {
    exposed_checksums(COUNT, &mut |name, sum| sums.push(name, sum));
}
