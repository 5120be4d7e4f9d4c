//! The nearest stored normal.

use microbrdf::shade::Octahedral;

use crate::vector::{cross, dot, length};

/// The stored form whose direction is nearest to the unit vector `normal`.
#[must_use]
pub fn encode<N: Octahedral>(normal: [f64; 3]) -> N {
    let sum: f64 = normal.iter().map(|c| c.abs()).sum();
    let [x, y, z] = normal.map(|c| c / sum * f64::from(N::GREATEST));
    let fold = z.min(0.0);
    let out = |c: f64| c - fold.copysign(-c);
    let below = [out(x), out(y)].map(|c| c.floor() as i32);
    let candidates = (-1..=2).flat_map(|i| (-1..=2).map(move |j| [i, j]));
    candidates
        .map(|steps| {
            let coordinates =
                [0, 1].map(|axis| (below[axis] + steps[axis]).clamp(-N::GREATEST, N::GREATEST));
            N::from_coordinates(coordinates)
        })
        .min_by(|a, b| angle(*a, normal).total_cmp(&angle(*b, normal)))
        .expect("sixteen candidates")
}

/// Angle between what is stored and a unit vector.
fn angle<N: Octahedral>(stored: N, normal: [f64; 3]) -> f64 {
    let vector = stored.vector().map(f64::from);
    length(cross(vector, normal)).atan2(dot(vector, normal))
}

/// What a stored normal may be off by, in radians: the bound that
/// `tests/tests/mesh.rs` holds the encodings to.
#[must_use]
pub fn greatest_error<N: Octahedral>() -> f64 {
    // On a face, 1/√3 from the middle at its own, stored points make triangles
    // with sides of √2 steps, whose corners are √(2/3) from their middles.
    std::f64::consts::SQRT_2 / f64::from(N::GREATEST)
}
