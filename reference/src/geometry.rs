//! Quantities of a pair of directions, formed without cancellation.
//!
//! In the shading frame the difference of R and V is a vector of sums,
//! (−(Lx+Vx), −(Ly+Vy), Lz−Vz), so the versine and the patch metric lose nothing
//! near the mirror direction, and see a length error only as a relative factor.

use crate::Direction;

/// The versine x = 1 − R·V = |R − V|²/2 for unit vectors, 0 … 2.
pub fn versine(l: &Direction, v: &Direction) -> f64 {
    let (x, y, z) = (l.x + v.x, l.y + v.y, l.z - v.z);
    0.5 * (x * x + y * y + z * z)
}

/// The versine about L itself, 1 − L·V = |L − V|²/2, for retro-reflective lobes.
pub fn retro_versine(l: &Direction, v: &Direction) -> f64 {
    let (x, y, z) = (l.x - v.x, l.y - v.y, l.z - v.z);
    0.5 * (x * x + y * y + z * z)
}

/// The patch metric squared, m² = |(L + V)_P|² (4.1), 0 … 4.
pub fn metric_squared(l: &Direction, v: &Direction) -> f64 {
    let (x, y) = (l.x + v.x, l.y + v.y);
    x * x + y * y
}

/// The retro-reflective patch metric squared, |(L − V)_P|².
pub fn retro_metric_squared(l: &Direction, v: &Direction) -> f64 {
    let (x, y) = (l.x - v.x, l.y - v.y);
    x * x + y * y
}

/// cosΘmin = max(N·L, N·V) (3.3, 3.4).
pub fn cos_theta_min(l: &Direction, v: &Direction) -> f64 {
    l.z.max(v.z)
}

/// Whether either direction lies below the horizon: there every BRDF is 0.
/// A cosine of exactly 0 is not below.
pub fn below_horizon(l: &Direction, v: &Direction) -> bool {
    l.z < 0.0 || v.z < 0.0
}

/// cosαⁿ from the versine: exp(n ln(1 − x)), and 0 for x ≥ 1, also for n = 0.
pub fn power_lobe(exponent: f64, versine: f64) -> f64 {
    if versine >= 1.0 {
        0.0
    } else {
        (exponent * (-versine).ln_1p()).exp()
    }
}

/// cosΘL / cosᵖΘmin, in [0, 1]: the bounded part of a p-model's reflected radiance (3.12).
///
/// 0 when either cosine is negative or both are 0. With p = 1 and one cosine
/// exactly 0 it is exactly 0 (light at the horizon) or 1 (viewer at the horizon).
pub fn bounded_ratio(l: &Direction, v: &Direction, p: f64) -> f64 {
    let greatest = cos_theta_min(l, v);
    if below_horizon(l, v) || greatest == 0.0 {
        return 0.0;
    }
    let ratio = l.z / greatest;
    if p == 1.0 {
        ratio
    } else {
        ratio * greatest.powf(1.0 - p)
    }
}

/// `value / cosᵖΘmin`, saturating at `f64::MAX` where both cosines are 0 and
/// `value` is positive; 0 below the horizon.
pub fn over_cos_theta_min(value: f64, l: &Direction, v: &Direction, p: f64) -> f64 {
    if below_horizon(l, v) || value == 0.0 {
        return 0.0;
    }
    let greatest = cos_theta_min(l, v);
    let divisor = if p == 1.0 { greatest } else { greatest.powf(p) };
    (value / divisor).min(f64::MAX)
}
