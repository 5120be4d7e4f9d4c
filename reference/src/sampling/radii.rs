//! Radii of patch mixtures, drawn from p(R) (4.27, 4.28) or from a profile ξ(m) (4.41).

use super::inverse::Inverse;
use crate::models::{Metric, PatchExponential, PatchMixture, PatchProfile};
use crate::quadrature::find_root;
use std::f64::consts::PI;

/// Draws radii of patches.
pub trait Radii {
    /// A radius above 0 and at most 2; 0 is the mirror. 2 is Lambert in every metric.
    fn draw(&self, random: &mut dyn FnMut() -> f64) -> f64;

    /// The integral of p(R), with the weights of mirror and Lambert: 1 for mixtures that
    /// absorb nothing at the normal.
    fn mass(&self) -> f64;
}

impl Radii for PatchExponential {
    fn draw(&self, random: &mut dyn FnMut() -> f64) -> f64 {
        // The inverse returns 2, Lambert, for the mass of the diffuse part; a radius that
        // rounds to 0 is not the mirror.
        self.inverse(random()).max(f64::MIN_POSITIVE)
    }

    fn mass(&self) -> f64 {
        1.0
    }
}

/// Radii of a [`PatchMixture`], by the inverse of its density's integral.
pub struct DensityRadii<'a> {
    inverse: Inverse<'a>,
    mirror: f64,
    diffuse: f64,
}

impl<'a> DensityRadii<'a> {
    /// Integrates the density once.
    pub fn new<F: Fn(f64) -> f64>(model: &'a PatchMixture<F>) -> Self {
        Self {
            inverse: Inverse::new(Box::new(|r| model.density(r)), &[0.0, 1.0, 2.0]),
            mirror: model.mirror_weight(),
            diffuse: model.diffuse_weight(),
        }
    }
}

impl Radii for DensityRadii<'_> {
    fn draw(&self, random: &mut dyn FnMut() -> f64) -> f64 {
        let u = random() * self.mass();
        if u < self.mirror {
            0.0
        } else if u < self.mirror + self.diffuse {
            2.0
        } else {
            let rest = u - self.mirror - self.diffuse;
            self.inverse.at(rest).max(f64::MIN_POSITIVE)
        }
    }

    fn mass(&self) -> f64 {
        self.inverse.total() + self.mirror + self.diffuse
    }
}

/// Radii of a profile ξ that nowhere increases, in any metric.
///
/// A point is drawn under the profile, over the ball that is as large as the base circle;
/// the radius is where the profile falls below that point's height. This is p(R) without a
/// derivative, so that a profile may have steps.
pub struct ProfileRadii<'a> {
    profile: Box<dyn Fn(f64) -> f64 + 'a>,
    under: Inverse<'a>,
    constant: f64,
}

impl<'a> ProfileRadii<'a> {
    /// The radii of a [`PatchProfile`]; nothing if its profile increases somewhere: then
    /// p(R) is negative there, and there is no mixture to draw from.
    pub fn of<F: Fn(f64) -> f64>(model: &'a PatchProfile<F>) -> Option<Self> {
        model
            .is_decreasing()
            .then(|| Self::new(model.metric(), |m| model.profile(m), model.constant()))
    }

    /// For f = C ξ(m) with a ξ that nowhere increases on 0 … 2 and is above 0 at 0.
    pub fn new(metric: Metric, profile: impl Fn(f64) -> f64 + Clone + 'a, constant: f64) -> Self {
        let area = metric.unit_area();
        let reach = (PI / area).sqrt().min(2.0);
        let xi = profile.clone();
        Self {
            under: Inverse::new(Box::new(move |r| 2.0 * area * r * xi(r)), &[0.0, reach]),
            profile: Box::new(profile),
            constant,
        }
    }
}

impl Radii for ProfileRadii<'_> {
    fn draw(&self, random: &mut dyn FnMut() -> f64) -> f64 {
        let r = self.under.at(random() * self.under.total());
        let height = random() * (self.profile)(r);
        if height <= (self.profile)(2.0) {
            return 2.0;
        }
        find_root(&mut |x| (self.profile)(x) - height, r, 2.0).max(f64::MIN_POSITIVE)
    }

    fn mass(&self) -> f64 {
        self.constant * self.under.total()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::Random;

    /// The greatest distance of the drawn radii's distribution from the exponential one's.
    fn distance(radii: &dyn Radii, exact: &PatchExponential) -> f64 {
        let mut random = Random::new(11);
        let n = 20_000;
        let mut drawn: Vec<f64> = (0..n)
            .map(|_| radii.draw(&mut || random.uniform()))
            .filter(|r| *r < 2.0)
            .collect();
        drawn.sort_by(f64::total_cmp);
        (drawn.iter().enumerate())
            .map(|(i, r)| (exact.cumulative(*r) - (i as f64 + 0.5) / f64::from(n)).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_exponential_models_radii_come_from_density_and_profile_alike() {
        // Kolmogorov's and Smirnov's bound at 1e-4 for 20000: 2.22/√n.
        let bound = 2.22 / 20_000f64.sqrt();
        for s in [0.5, 4.0, 30.0] {
            let exact = PatchExponential::new(s).unwrap();
            let mixture =
                PatchMixture::new(|r| exact.density(r), 0.0, exact.diffuse_weight()).unwrap();
            let profile = PatchProfile::new(|m: f64| (-s * m).exp(), Metric::EUCLIDEAN).unwrap();
            let from_density = DensityRadii::new(&mixture);
            let from_profile = ProfileRadii::of(&profile).unwrap();
            for radii in [&exact as &dyn Radii, &from_density, &from_profile] {
                assert!((radii.mass() - 1.0).abs() < 1e-9, "s = {s}");
                let d = distance(radii, &exact);
                assert!(d < bound, "s = {s}: {d}");
            }
            let other = PatchExponential::new(1.1 * s).unwrap();
            assert!(distance(&from_profile, &other) > bound, "s = {s}");
        }
    }

    #[test]
    fn increasing_profiles_have_no_radii() {
        let m = PatchProfile::new(|m: f64| 1.0 + m, Metric::EUCLIDEAN).unwrap();
        assert!(ProfileRadii::of(&m).is_none());
    }
}
