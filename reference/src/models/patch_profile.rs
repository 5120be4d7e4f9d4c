//! Patch models from any profile, f = C ξ(m) (4.39), in any metric.

use super::Metric;
use crate::albedo::greatest_albedo;
use crate::geometry::below_horizon;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind, Estimate, adaptive};
use crate::sampling::{Cosine, Mixture, MixtureMethod, ProfileRadii, Sampler};
use crate::{Brdf, Direction, ParameterError};
use std::f64::consts::{FRAC_PI_2, PI};

/// A profile ξ(m) ≥ 0 on 0 … 2, normalised so that the greatest albedo is 1.
#[derive(Debug, Clone, Copy)]
pub struct PatchProfile<F> {
    profile: F,
    metric: Metric,
    decreasing: bool,
    scale: f64,
    constant: f64,
}

impl<F: Fn(f64) -> f64> PatchProfile<F> {
    /// `profile` is looked at in 4097 points of 0 … 2: there it must be finite and not
    /// negative, and not 0 everywhere.
    ///
    /// For a profile that nowhere increases the albedo is greatest at the normal, and C is
    /// found there; otherwise by a search over all angles.
    pub fn new(profile: F, metric: Metric) -> Result<Self, ParameterError> {
        const POINTS: u32 = 4096;
        let values: Vec<f64> = (0..=POINTS)
            .map(|i| profile(2.0 * f64::from(i) / f64::from(POINTS)))
            .collect();
        if let Some(bad) = values.iter().find(|v| !v.is_finite() || **v < 0.0) {
            return Err(ParameterError::new(
                "profile",
                bad,
                "finite and at least 0 on 0 to 2",
            ));
        }
        let greatest = values.iter().copied().fold(0.0, f64::max);
        if greatest == 0.0 {
            return Err(ParameterError::new(
                "profile",
                0.0,
                "above 0 somewhere on 0 to 2",
            ));
        }
        let decreasing = values.windows(2).all(|w| w[1] <= w[0]);
        // Where it has fallen to a half: the width for the quadrature.
        let width = values
            .iter()
            .position(|v| *v < 0.5 * values[0])
            .unwrap_or(values.len() - 1);
        let mut model = Self {
            profile,
            metric,
            decreasing,
            scale: 2.0 * width.max(1) as f64 / f64::from(POINTS),
            constant: 1.0,
        };
        model.constant = if decreasing {
            1.0 / model.centred_integral()
        } else {
            1.0 / greatest_albedo(&model).1.value
        };
        Ok(model)
    }

    /// ∫ ξ over the base circle with the centre at L = N.
    fn centred_integral(&self) -> f64 {
        let ring = |stretch: f64| {
            adaptive(
                &mut |r| Estimate {
                    value: (self.profile)(r * stretch) * r,
                    error: 0.0,
                },
                &[0.0, self.scale.min(0.5), 1.0],
                1e-14,
                200,
            )
        };
        if self.metric.is_isotropic() {
            return 2.0 * PI * ring(1.0).value;
        }
        let quarter = adaptive(
            &mut |phi: f64| ring(self.metric.length(phi.cos(), phi.sin())),
            &[0.0, 0.5 * FRAC_PI_2, FRAC_PI_2],
            1e-13,
            100,
        );
        4.0 * quarter.value
    }

    /// ξ(m) at m of 0 … 2, without C.
    pub fn profile(&self, m: f64) -> f64 {
        (self.profile)(m)
    }

    /// The metric that m is measured in.
    pub fn metric(&self) -> Metric {
        self.metric
    }

    /// C_max (4.42, 4.43).
    pub fn constant(&self) -> f64 {
        self.constant
    }

    /// Whether the profile nowhere increases: only then is there a density p(R) ≥ 0.
    pub fn is_decreasing(&self) -> bool {
        self.decreasing
    }

    /// The weight of the ideal diffuse part, π C ξ(2).
    pub fn diffuse_weight(&self) -> f64 {
        PI * self.constant * (self.profile)(2.0)
    }

    /// p(R) = −C ξ'(R) π min(1, R²) (4.41), the derivative by central differences.
    pub fn density(&self, r: f64) -> f64 {
        let h = 1e-5;
        let (low, high) = ((r - h).max(0.0), (r + h).min(2.0));
        let slope = ((self.profile)(high) - (self.profile)(low)) / (high - low);
        -self.constant * slope * PI * (r * r).min(1.0)
    }
}

impl<F: Fn(f64) -> f64> Brdf for PatchProfile<F> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        self.constant * (self.profile)(self.metric.distance(l, v).min(2.0))
    }

    fn peak(&self) -> f64 {
        self.constant
    }

    fn chart(&self, _l: &Direction) -> Chart {
        let kind = if self.metric.is_retro() {
            ChartKind::RetroPlane
        } else {
            ChartKind::Plane
        };
        Chart::new(kind, self.scale)
    }

    fn is_isotropic(&self) -> bool {
        self.metric.is_isotropic()
    }
}

/// Both samplers of a profile that nowhere increases.
fn mixtures(
    profile: impl Fn(f64) -> f64,
    metric: Metric,
    v: Direction,
    visit: &mut dyn FnMut(&dyn Brdf, &dyn Sampler),
) {
    let m = PatchProfile::new(profile, metric).expect("a profile");
    for method in [MixtureMethod::Redraw, MixtureMethod::Roulette] {
        let radii = ProfileRadii::of(&m).expect("it nowhere increases");
        visit(&m, &Mixture::new(&m, metric, radii, v, method));
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "patch_profile",
    source: "(4.39) to (4.43)",
    formula: "C ξ(m)",
    parameters: "any ξ ≥ 0 on 0 … 2; Euclidean, elliptic or p-norm metric, about R or L",
    reciprocal: true,
    grazing: "f bounded",
    examples: || {
        vec![
            example(
                "ξ = 1/(1 + 30m²)",
                PatchProfile::new(|m: f64| 1.0 / (1.0 + 30.0 * m * m), Metric::EUCLIDEAN)
                    .expect("a profile"),
                Conserves,
            ),
            example(
                "ξ = 1 + m (increasing)",
                PatchProfile::new(|m: f64| 1.0 + m, Metric::EUCLIDEAN).expect("a profile"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let heavy = |m: f64| 1.0 / (1.0 + 30.0 * m * m);
        let step = |m: f64| if m < 0.4 { 1.0 } else { 0.1 };
        let sharp = |m: f64| (-6.0 * m).exp();
        let elliptic = Metric::elliptic(0.5).expect("in range");
        let power = Metric::power(0.7, 4.0).expect("in range").retro();
        mixtures(heavy, Metric::EUCLIDEAN, v, visit);
        mixtures(step, Metric::EUCLIDEAN, v, visit);
        mixtures(sharp, elliptic, v, visit);
        mixtures(sharp, power, v, visit);
        // No mixture: p(R) is negative.
        let rising = PatchProfile::new(|m: f64| 1.0 + m, Metric::EUCLIDEAN).expect("a profile");
        visit(&rising, &Cosine::new(&rising, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo;
    use crate::models::patch_exponential;

    #[test]
    fn an_exponential_profile_is_the_exponential_model() {
        for s in [0.5, 4.0, 40.0] {
            let m = PatchProfile::new(|x: f64| (-s * x).exp(), Metric::EUCLIDEAN).unwrap();
            let exact = patch_exponential::greatest_constant(s);
            assert!((m.constant() / exact - 1.0).abs() < 1e-11, "s = {s}");
            assert!((m.diffuse_weight() - PI * exact * (-2.0 * s).exp()).abs() < 1e-11);
        }
    }

    #[test]
    fn other_metrics_are_normalised_too() {
        for metric in [
            Metric::elliptic(0.5).unwrap(),
            Metric::power(0.7, 4.0).unwrap(),
            Metric::EUCLIDEAN.retro(),
        ] {
            let m = PatchProfile::new(|x: f64| (-6.0 * x).exp(), metric).unwrap();
            let a = directional_albedo(&m, 1.0);
            assert!((a.value - 1.0).abs() < 1e-8, "{metric:?}: {a:?}");
        }
    }

    #[test]
    fn increasing_profiles_are_normalised_at_their_greatest_albedo() {
        let m = PatchProfile::new(|x: f64| 1.0 + x, Metric::EUCLIDEAN).unwrap();
        assert!(!m.is_decreasing() && m.density(0.5) < 0.0);
        assert!((directional_albedo(&m, 0.0).value - 1.0).abs() < 1e-8);
        assert!(directional_albedo(&m, 1.0).value < 1.0);
    }

    #[test]
    fn bad_profiles_are_refused() {
        assert!(PatchProfile::new(|_| 0.0, Metric::EUCLIDEAN).is_err());
        assert!(PatchProfile::new(|x: f64| 1.0 - x, Metric::EUCLIDEAN).is_err());
        assert!(PatchProfile::new(|x: f64| 1.0 / x, Metric::EUCLIDEAN).is_err());
    }
}
