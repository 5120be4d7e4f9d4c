//! Highlights on spheres.

use microbrdf_bits::highlight_checksums;

use crate::Sums;

/// Pairs of lights for each lobe.
const COUNT: usize = 120;

/// Adds a sum for each lobe.
pub fn add(sums: &mut Sums) {
    highlight_checksums(COUNT, &mut |name, sum| sums.push(name, sum));
}
