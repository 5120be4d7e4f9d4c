//! From a place on the card to two directions.

use super::band::Across;

/// Which way V leaves R.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// In the plane of incidence, the lower of both directions towards the
    /// horizon: V where the number across is positive, L where it is negative.
    Incidence,
    /// At right angles to it: a lobe's V along the great circle, a patch's
    /// about the normal.
    Sideways,
}

impl Plane {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Incidence, Self::Sideways];
}

/// L and V at a number across and a larger cosine in (0, 1], or nothing where
/// no two directions lie so far apart there.
#[must_use]
pub fn pair(across: Across, number: f64, cosine: f64, plane: Plane) -> Option<[[f64; 3]; 2]> {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let higher = [sine, 0.0, cosine];
    let distance = number.abs();
    let side = number.signum();
    let other = match (across, plane) {
        (Across::Tau(n), _) => {
            let x = distance / n;
            if x > 2.0 {
                return None;
            }
            let turned = (x * (2.0 - x)).sqrt();
            match plane {
                Plane::Incidence => [
                    -(sine * (1.0 - x) + cosine * turned),
                    0.0,
                    cosine * (1.0 - x) - sine * turned,
                ],
                Plane::Sideways => [-sine * (1.0 - x), side * turned, cosine * (1.0 - x)],
            }
        }
        (Across::Sharpness(_) | Across::Radius(_), Plane::Incidence) => {
            let m = distance * scale(across);
            // 1 − (sinΘ + m)², without cancellation at grazing.
            let square = cosine * cosine - m * (2.0 * sine + m);
            if square < 0.0 {
                return None;
            }
            [-(sine + m), 0.0, square.sqrt()]
        }
        (Across::Sharpness(_) | Across::Radius(_), Plane::Sideways) => {
            let m = distance * scale(across);
            // Half of the chord of the azimuth between R and V.
            let half = if m == 0.0 { 0.0 } else { 0.5 * m / sine };
            if half > 1.0 {
                return None;
            }
            let turned = 2.0 * half * ((1.0 - half) * (1.0 + half)).sqrt();
            let kept = 1.0 - 2.0 * half * half;
            [-sine * kept, side * sine * turned, cosine]
        }
    };
    Some(if plane == Plane::Incidence && number < 0.0 {
        [other, higher]
    } else {
        [higher, other]
    })
}

/// m for each unit across.
fn scale(across: Across) -> f64 {
    match across {
        Across::Sharpness(s) => 1.0 / s,
        Across::Radius(radius) => radius,
        Across::Tau(_) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::BANDS;
    use microbrdf_reference::Direction;
    use microbrdf_reference::geometry::{metric_squared, versine};

    #[test]
    fn pairs_are_where_the_card_says() {
        let mut seen = 0;
        for band in BANDS {
            for plane in Plane::ALL {
                for number in [-2.0, -0.7, 0.0, 0.3, 1.9] {
                    for cosine in [1.0, 0.6, 1e-3, 1e-8] {
                        let Some(found) = pair(band.across, number, cosine, plane) else {
                            continue;
                        };
                        let [l, v] = found.map(Direction::from);
                        let what = format!("{band:?}, {number}, {cosine}, {plane:?}");
                        assert!((l.length() - 1.0).abs() < 1e-15, "{what}");
                        assert!((v.length() - 1.0).abs() < 1e-15, "{what}");
                        assert_eq!(l.z.max(v.z), cosine, "{what}");
                        let found = match band.across {
                            Across::Tau(n) => n * versine(&l, &v),
                            Across::Sharpness(s) => s * metric_squared(&l, &v).sqrt(),
                            Across::Radius(radius) => metric_squared(&l, &v).sqrt() / radius,
                        };
                        // What f64 itself leaves of 1e-4 beside 1.
                        assert!((found - number.abs()).abs() < 2e-7, "{what}: {found}");
                        let lower = if number < 0.0 { l.z } else { v.z };
                        assert!(plane == Plane::Sideways || lower <= cosine, "{what}");
                        seen += 1;
                    }
                }
            }
        }
        assert!(seen > 300, "{seen}");
    }
}
