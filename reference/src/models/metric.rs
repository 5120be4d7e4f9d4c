//! Distances between projections on the base plane (4.1, 4.29 to 4.32, 4.38).

use crate::error::{above, within};
use crate::{Direction, ParameterError};
use std::f64::consts::PI;

/// The shape of the unit ball.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Norm {
    Euclidean,
    Elliptic { ratio: f64 },
    Power { ratio: f64, p: f64 },
}

/// A metric m(L, V) of V's projection against R's, or L's for retro-reflective models.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metric {
    norm: Norm,
    retro: bool,
}

impl Metric {
    /// The Euclidean distance (4.1).
    pub const EUCLIDEAN: Self = Self {
        norm: Norm::Euclidean,
        retro: false,
    };

    /// The elliptic norm (4.32), the component along x shortened by B/A, above 0 and at most 1.
    pub fn elliptic(ratio: f64) -> Result<Self, ParameterError> {
        let ratio = above("ratio", ratio, 0.0, 1.0)?;
        Ok(Self {
            norm: Norm::Elliptic { ratio },
            retro: false,
        })
    }

    /// The p-th power norm (4.38) of absolute values, p of 1 … 100.
    pub fn power(ratio: f64, p: f64) -> Result<Self, ParameterError> {
        let ratio = above("ratio", ratio, 0.0, 1.0)?;
        Ok(Self {
            norm: Norm::Power {
                ratio,
                p: within("p", p, 1.0, 100.0)?,
            },
            retro: false,
        })
    }

    /// The same about L instead of R (4.29).
    pub fn retro(self) -> Self {
        Self {
            retro: true,
            ..self
        }
    }

    /// Whether it is about L.
    pub fn is_retro(&self) -> bool {
        self.retro
    }

    /// Whether it is the same in all azimuths.
    pub fn is_isotropic(&self) -> bool {
        match self.norm {
            Norm::Euclidean => true,
            Norm::Elliptic { ratio } => ratio == 1.0,
            Norm::Power { ratio, p } => ratio == 1.0 && p == 2.0,
        }
    }

    /// The area of the unit ball (4.36; for the p-norm by the gamma function).
    pub fn unit_area(&self) -> f64 {
        let (a, b) = self.unit_axes();
        match self.norm {
            Norm::Euclidean | Norm::Elliptic { .. } => PI * a * b,
            Norm::Power { p, .. } => {
                let gamma = libm::tgamma(1.0 + 1.0 / p);
                4.0 * a * b * gamma * gamma / libm::tgamma(1.0 + 2.0 / p)
            }
        }
    }

    /// How far the unit ball reaches along x and along y.
    pub fn unit_axes(&self) -> (f64, f64) {
        match self.norm {
            Norm::Euclidean => (1.0, 1.0),
            Norm::Elliptic { ratio } | Norm::Power { ratio, .. } => (1.0 / ratio, 1.0),
        }
    }

    /// Whether the balls are circles or ellipses.
    pub fn is_round(&self) -> bool {
        !matches!(self.norm, Norm::Power { .. })
    }

    /// The norm of a vector in the base plane.
    pub fn length(&self, x: f64, y: f64) -> f64 {
        match self.norm {
            Norm::Euclidean => x.hypot(y),
            Norm::Elliptic { ratio } => (ratio * x).hypot(y),
            Norm::Power { ratio, p } => {
                let (a, b) = ((ratio * x).abs(), y.abs());
                let great = a.max(b);
                if great == 0.0 {
                    return 0.0;
                }
                great * ((a / great).powf(p) + (b / great).powf(p)).powf(1.0 / p)
            }
        }
    }

    /// The distance m.
    pub fn distance(&self, l: &Direction, v: &Direction) -> f64 {
        if self.retro {
            self.length(l.x - v.x, l.y - v.y)
        } else {
            self.length(l.x + v.x, l.y + v.y)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_join_the_other_norms() {
        let e = Metric::elliptic(0.5).unwrap();
        let p = Metric::power(0.5, 2.0).unwrap();
        for (x, y) in [(0.3, 0.4), (-1.0, 0.2), (0.0, -0.7)] {
            assert!((e.length(x, y) - p.length(x, y)).abs() < 1e-15);
        }
        assert!((Metric::power(1.0, 1.0).unwrap().length(-0.3, 0.4) - 0.7).abs() < 1e-15);
        assert!(Metric::power(1.0, 0.5).is_err());
    }

    #[test]
    fn the_mirror_pair_is_at_no_distance() {
        let l = Direction::from_degrees(50.0, 20.0);
        assert_eq!(Metric::EUCLIDEAN.distance(&l, &l.mirrored()), 0.0);
        assert_eq!(Metric::EUCLIDEAN.retro().distance(&l, &l), 0.0);
        let m = Metric::EUCLIDEAN.distance(&l, &l);
        assert!((m - 2.0 * 50f64.to_radians().sin()).abs() < 1e-15);
    }
}
