//! Metallic versions of generalised Phong, f = C cosⁿα/cosΘ_H with a bisecting vector H of
//! R and V (5.15 to 5.17).

use crate::albedo::greatest_albedo;
use crate::error::within;
use crate::geometry::{below_horizon, power_lobe, versine};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::{Brdf, Direction, ParameterError};

/// How cosΘ_H follows from cosΘL, cosΘV and α.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bisector {
    /// The power mean ((cosᵖΘL + cosᵖΘV)/2)^(1/p), p above 0.
    PowerMean(f64),
    /// The maximum, the power mean of p = ∞: metallic Phong (5.16).
    Maximum,
    /// The bisector on the sphere, (cosΘL + cosΘV)/|R + V|: smooth at V = R (5.17).
    Spherical,
}

/// The model with exponent n (0 … 1e5), normalised numerically.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BisectorPhong {
    exponent: f64,
    bisector: Bisector,
    constant: f64,
}

impl BisectorPhong {
    /// Geometric (p = 0) and harmonic (p = −1) means, and all p ≤ 0, are refused: their
    /// albedo grows without bound towards the horizon, so no constant conserves energy.
    pub fn new(exponent: f64, bisector: Bisector) -> Result<Self, ParameterError> {
        if let Bisector::PowerMean(p) = bisector
            && !(p > 0.0 && p <= 100.0)
        {
            return Err(ParameterError::new(
                "p",
                p,
                "above 0 and at most 100: with p at or below 0 (geometric, harmonic) the \
                 albedo is unbounded at grazing angles and the model can't be normalised",
            ));
        }
        let mut model = Self::unchecked(exponent, bisector)?;
        model.constant /= greatest_albedo(&model).1.value;
        Ok(model)
    }

    /// With Phong's constant, whatever the mean: to show what can't be normalised.
    pub fn unchecked(exponent: f64, bisector: Bisector) -> Result<Self, ParameterError> {
        Ok(Self {
            exponent: within("exponent", exponent, 0.0, 1e5)?,
            bisector,
            constant: super::phong::published_constant(exponent),
        })
    }

    fn cos_bisector(&self, l: &Direction, v: &Direction, x: f64) -> f64 {
        match self.bisector {
            Bisector::Maximum => l.z.max(v.z),
            Bisector::Spherical => (l.z + v.z) / (4.0 - 2.0 * x).max(f64::MIN_POSITIVE).sqrt(),
            Bisector::PowerMean(0.0) => (l.z * v.z).sqrt(),
            Bisector::PowerMean(p) => {
                let (low, high) = (l.z.min(v.z), l.z.max(v.z));
                if high == 0.0 || (low == 0.0 && p < 0.0) {
                    return 0.0;
                }
                high * (0.5 * ((low / high).powf(p) + 1.0)).powf(1.0 / p)
            }
        }
    }
}

impl Brdf for BisectorPhong {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let x = versine(l, v);
        let lobe = self.constant * power_lobe(self.exponent, x);
        if lobe == 0.0 {
            return 0.0;
        }
        (lobe / self.cos_bisector(l, v, x)).min(f64::MAX)
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::power(ChartKind::Mirror, self.exponent)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        if self.bisector == Bisector::Maximum {
            out.push(l.z - v.z);
        }
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "bisector_phong",
    source: "(5.15) to (5.17)",
    formula: "C cosⁿα / cosΘ_H with a bisector H of R and V",
    parameters: "n 0 … 1e5; power mean p above 0, maximum, or spherical",
    reciprocal: true,
    grazing: "radiance bounded; power means with p at or below 0 are refused: unbounded albedo",
    examples: || {
        vec![
            example(
                "n = 20, spherical",
                BisectorPhong::new(20.0, Bisector::Spherical).expect("in range"),
                Conserves,
            ),
            example(
                "n = 20, arithmetic mean",
                BisectorPhong::new(20.0, Bisector::PowerMean(1.0)).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;
    use crate::models::{Energy, MetallicPhong};

    #[test]
    fn the_maximum_is_metallic_phong() {
        let a = BisectorPhong::new(20.0, Bisector::Maximum).unwrap();
        let b = MetallicPhong::new(20.0, Energy::Published).unwrap();
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(60.0, 170.0),
        );
        assert!((a.eval(&l, &v) / b.eval(&l, &v) - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_mean_of_p_minus_one_diverges() {
        // (5.18) as corrected: 1.02, 1.14, 3.06, 25.8.
        let m = BisectorPhong::unchecked(20.0, Bisector::PowerMean(-1.0)).unwrap();
        for (degrees, albedo, tolerance) in [
            (60.0, 1.02, 5e-3),
            (85.0, 1.14, 5e-3),
            (89.0, 3.06, 5e-3),
            (89.9, 25.8, 0.05),
        ] {
            let a = directional_albedo_at(&m, degrees).value;
            assert!((a - albedo).abs() < tolerance, "{degrees}: {a}");
        }
        assert_eq!(
            BisectorPhong::new(20.0, Bisector::PowerMean(-1.0))
                .unwrap_err()
                .parameter,
            "p"
        );
        assert!(BisectorPhong::new(20.0, Bisector::PowerMean(0.0)).is_err());
    }

    #[test]
    fn the_spherical_bisector_is_between() {
        let m = BisectorPhong::unchecked(9.0, Bisector::Spherical).unwrap();
        let (l, v) = (
            Direction::from_degrees(70.0, 0.0),
            Direction::from_degrees(30.0, 180.0),
        );
        let cos = m.cos_bisector(&l, &v, versine(&l, &v));
        assert!((cos - 50f64.to_radians().cos()).abs() < 1e-12, "{cos}");
    }
}
