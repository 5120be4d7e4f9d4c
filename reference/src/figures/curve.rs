//! Points of a curve, close together where it bends.

/// Each stretch between two breaks starts with this many cells, and no cell is halved
/// more often than that.
const CELLS: usize = 12;
const HALVINGS: usize = 11;

/// Points of y = f(x) through all `breaks`, which ascend or descend.
///
/// A cell is halved until its middle lies within `tolerance` (in y) of the straight
/// line, so a narrow peak is found only if a break lies on it. Where f jumps, the
/// cell left over has 1/24576 of the width between the breaks.
pub fn curve(breaks: &[f64], tolerance: f64, f: &mut dyn FnMut(f64) -> f64) -> Vec<(f64, f64)> {
    let Some(&first) = breaks.first() else {
        return Vec::new();
    };
    let mut points = vec![(first, f(first))];
    for pair in breaks.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        for i in 1..=CELLS {
            let x = if i == CELLS {
                to
            } else {
                from + (to - from) * i as f64 / CELLS as f64
            };
            let end = (x, f(x));
            refine(end, tolerance, HALVINGS, f, &mut points);
        }
    }
    points
}

/// Appends what lies between the last point and `end`, and `end`.
fn refine(
    end: (f64, f64),
    tolerance: f64,
    depth: usize,
    f: &mut dyn FnMut(f64) -> f64,
    points: &mut Vec<(f64, f64)>,
) {
    let start = points[points.len() - 1];
    let x = 0.5 * (start.0 + end.0);
    let middle = (x, f(x));
    if depth > 0 && (middle.1 - 0.5 * (start.1 + end.1)).abs() > tolerance {
        refine(middle, tolerance, depth - 1, f, points);
        refine(end, tolerance, depth - 1, f, points);
    } else {
        points.push(middle);
        points.push(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_narrow_peak_on_a_break_is_followed() {
        let points = curve(&[-90.0, 30.0, 90.0], 1e-3, &mut |x: f64| {
            (-((x - 30.0) / 0.01).powi(2)).exp()
        });
        assert!(points.windows(2).all(|p| p[0].0 < p[1].0));
        let at = points.iter().filter(|p| (p.0 - 30.0).abs() < 0.02).count();
        assert!(at > 20, "{at}");
        assert!(points.contains(&(30.0, 1.0)));
        assert!(points.len() < 300, "{}", points.len());
    }

    #[test]
    fn every_break_is_a_point_and_a_jump_ends() {
        let points = curve(&[0.0, 1.0, 2.0], 1e-6, &mut |x| f64::from(x > 1.3));
        for x in [0.0, 1.0, 2.0] {
            assert!(points.iter().any(|p| p.0 == x), "{x}");
        }
        assert!(points.len() < 100, "{}", points.len());
    }

    #[test]
    fn it_may_run_backwards_and_be_empty() {
        let points = curve(&[1.0, 0.0], 1e-3, &mut |x| x * x);
        assert!(points.windows(2).all(|p| p[0].0 > p[1].0));
        assert!(curve(&[], 1e-3, &mut |x| x).is_empty());
    }
}
