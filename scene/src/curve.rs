//! Curves over a cosine, from f64.

use microbrdf::table::{COSINE_KNOTS, CosineCurve};

/// Fraction bits of an entry.
const ONE: f64 = 32768.0;

/// Tabulates three channels over a cosine in [0, 1].
///
/// Inner knots lie half of the chord's error off the curve, so that the error
/// is centred on 0; the ends are exact to rounding.
#[must_use]
pub fn cosine_curve(function: &dyn Fn(f64) -> [f64; 3]) -> CosineCurve {
    let cosine = |knot: usize| f64::from(CosineCurve::knot(knot)) / 256.0;
    let values: Vec<_> = (0..COSINE_KNOTS)
        .map(|knot| function(cosine(knot)))
        .collect();
    // How far the chord of the cell after a knot lies above its middle.
    let sags: Vec<[f64; 3]> = (0..COSINE_KNOTS - 1)
        .map(|knot| {
            let middle = function(0.5 * (cosine(knot) + cosine(knot + 1)));
            let (left, right) = (values[knot], values[knot + 1]);
            [0, 1, 2].map(|channel| 0.5 * (left[channel] + right[channel]) - middle[channel])
        })
        .collect();
    let mut entries = [[0; 3]; COSINE_KNOTS];
    for (knot, entry) in entries.iter_mut().enumerate() {
        let inner = knot > 0 && knot < COSINE_KNOTS - 1;
        *entry = [0, 1, 2].map(|channel| {
            // At the kink of total reflection half of a chord's error would
            // lift a knot above 1, where the curve itself is not.
            let near = &values[knot.saturating_sub(1)..(knot + 2).min(COSINE_KNOTS)];
            let most = near.iter().map(|v| v[channel]).fold(1.0, f64::max);
            let shift = if inner {
                0.25 * (sags[knot - 1][channel] + sags[knot][channel])
            } else {
                0.0
            };
            ((values[knot][channel] - shift).min(most) * ONE)
                .round()
                .clamp(0.0, f64::from(u16::MAX)) as u16
        });
    }
    CosineCurve::from_entries(entries)
}
