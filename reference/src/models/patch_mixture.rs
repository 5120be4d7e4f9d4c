//! Mixtures of basic patches by any density p(R),
//! f = ∫ₘ² p(R)/(π min(1, R²)) dR + p_Diffuse/π (4.20, 4.40 as corrected).

use super::Patch;
use crate::error::within;
use crate::geometry::{below_horizon, metric_squared};
use crate::models::Metric;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind, Estimate, adaptive};
use crate::sampling::{DensityRadii, Mixture, MixtureMethod};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_1_PI, PI};

/// A density on 0 < R < 2, with separate weights for the mirror (R = 0) and for Lambert (R = 2).
#[derive(Debug, Clone, Copy)]
pub struct PatchMixture<F> {
    density: F,
    mirror: f64,
    diffuse: f64,
    scale: f64,
}

impl<F: Fn(f64) -> f64> PatchMixture<F> {
    /// `density` must be finite and not negative on 0 … 2; with the weights p_Mirror and
    /// p_Diffuse (each 0 … 1) it must integrate to at most 1 (4.21).
    pub fn new(density: F, mirror: f64, diffuse: f64) -> Result<Self, ParameterError> {
        let mirror = within("mirror", mirror, 0.0, 1.0)?;
        let diffuse = within("diffuse", diffuse, 0.0, 1.0)?;
        for i in 1..2000 {
            within("density", density(f64::from(i) * 1e-3), 0.0, 1e12)?;
        }
        let mut model = Self {
            density,
            mirror,
            diffuse,
            scale: 0.2,
        };
        let mass = |high: f64| model.integrate(0.0, high, &|_| 1.0);
        let total = mass(2.0) + mirror + diffuse;
        if total > 1.0 + 1e-9 {
            return Err(ParameterError::new(
                "density",
                total,
                "of a total of at most 1 with both weights",
            ));
        }
        let half = 0.5 * (total - mirror - diffuse);
        let mut width = 2.0;
        while width > 1e-3 && mass(0.5 * width) > half {
            width *= 0.5;
        }
        model.scale = width;
        Ok(model)
    }

    fn integrate(&self, low: f64, high: f64, weight: &dyn Fn(f64) -> f64) -> f64 {
        if low >= high {
            return 0.0;
        }
        let mut breaks = vec![low];
        breaks.extend(
            [0.25 * self.scale, self.scale, 1.0]
                .iter()
                .filter(|b| **b > low && **b < high),
        );
        breaks.push(high);
        breaks.sort_by(f64::total_cmp);
        adaptive(
            &mut |r| Estimate {
                value: (self.density)(r) * weight(r),
                error: 0.0,
            },
            &breaks,
            1e-12,
            200,
        )
        .value
    }

    /// p(R) at R of 0 … 2.
    pub fn density(&self, r: f64) -> f64 {
        (self.density)(r)
    }

    /// p_Mirror.
    pub fn mirror_weight(&self) -> f64 {
        self.mirror
    }

    /// p_Diffuse.
    pub fn diffuse_weight(&self) -> f64 {
        self.diffuse
    }

    /// The albedo by (4.22), ∫ p(R) a_R dR with the lens area, and both weights.
    pub fn mixed_albedo(&self, cos_theta: f64) -> f64 {
        let patches = self.integrate(0.0, 2.0, &|r| {
            Patch::new(r).map_or(1.0, |p| p.exact_albedo(cos_theta))
        });
        patches + self.mirror + self.diffuse
    }
}

impl<F: Fn(f64) -> f64> Brdf for PatchMixture<F> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        let m = metric_squared(l, v).sqrt();
        let patches = self.integrate(m, 2.0, &|r| 1.0 / (PI * (r * r).min(1.0)));
        patches + self.diffuse * FRAC_1_PI
    }

    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        if l.z < 0.0 {
            [0.0; 3]
        } else {
            [self.mirror; 3]
        }
    }

    fn chart(&self, _l: &Direction) -> Chart {
        Chart::new(ChartKind::Plane, self.scale).with_edges(&[1.0])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_mixture",
    source: "(4.20) to (4.24), (4.40)",
    formula: "∫ₘ² p(R)/(π min(1, R²)) dR + p_Diffuse/π, and a mirror of weight p_Mirror",
    parameters: "any density p(R) ≥ 0; weights; a total of at most 1",
    reciprocal: true,
    grazing: "the mixture of the patches'",
    examples: || {
        vec![example(
            "p = 0.375 R(2 − R), p_Mirror = 0.2, p_Diffuse = 0.3",
            PatchMixture::new(|r: f64| 0.375 * r * (2.0 - r), 0.2, 0.3).expect("in range"),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let broad = PatchMixture::new(|r: f64| 0.375 * r * (2.0 - r), 0.2, 0.3).expect("in range");
        // Absorbs a fifth; ∫ 64.8 R e^(−9R) dR is 0.8 but for 3e-7.
        let sharp =
            PatchMixture::new(|r: f64| 64.8 * r * (-9.0 * r).exp(), 0.0, 0.0).expect("in range");
        for method in [MixtureMethod::Redraw, MixtureMethod::Roulette] {
            let radii = DensityRadii::new(&broad);
            visit(
                &broad,
                &Mixture::new(&broad, Metric::EUCLIDEAN, radii, v, method),
            );
            let radii = DensityRadii::new(&sharp);
            visit(
                &sharp,
                &Mixture::new(&sharp, Metric::EUCLIDEAN, radii, v, method),
            );
        }
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo;
    use crate::models::PatchExponential;

    #[test]
    fn the_exponential_models_own_density_gives_it_back() {
        for s in [0.25, 2.0, 12.0] {
            let exact = PatchExponential::new(s).unwrap();
            let m = PatchMixture::new(|r| exact.density(r), 0.0, exact.diffuse_weight()).unwrap();
            for degrees in [0.0, 30.0, 80.0] {
                let l = Direction::from_degrees(degrees, 0.0);
                let v = Direction::from_degrees(40.0, 160.0);
                let (a, b) = (m.eval(&l, &v), exact.eval(&l, &v));
                assert!((a / b - 1.0).abs() < 1e-9, "s = {s}, {degrees}: {a} {b}");
            }
        }
    }

    #[test]
    fn the_worked_example() {
        // s = 2, m = 0.4: 0.481573 (the print's formula gives 2.05).
        let exact = PatchExponential::new(2.0).unwrap();
        let m = PatchMixture::new(|r| exact.density(r), 0.0, exact.diffuse_weight()).unwrap();
        let (l, v) = (Direction::NORMAL, Direction::new(0.4, 0.0, 0.84f64.sqrt()));
        assert!(
            (m.eval(&l, &v) - 0.481_573).abs() < 1e-6,
            "{}",
            m.eval(&l, &v)
        );
    }

    #[test]
    fn both_albedos_agree_and_the_mirror_counts() {
        let m = PatchMixture::new(|r: f64| 0.3 * r * (2.0 - r), 0.2, 0.3).unwrap();
        for c in [0.0, 0.3, 1.0] {
            let (a, b) = (directional_albedo(&m, c), m.mixed_albedo(c));
            assert!((a.value - b).abs() < 1e-8, "{c}: {a:?} {b}");
        }
        assert!(PatchMixture::new(|_| 0.5, 0.2, 0.0).is_err());
        assert!(PatchMixture::new(|r| 0.1 - r, 0.0, 0.0).is_err());
    }
}
