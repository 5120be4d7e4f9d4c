//! Arithmetic of three coordinates.

/// a − b.
#[must_use]
pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a · b.
#[must_use]
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// |a|.
#[must_use]
pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// a × b.
#[must_use]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a times a factor.
#[must_use]
pub fn scaled(a: [f64; 3], factor: f64) -> [f64; 3] {
    a.map(|c| c * factor)
}

/// a divided by its length, which must not be 0.
#[must_use]
pub fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = length(a);
    a.map(|c| c / length)
}
