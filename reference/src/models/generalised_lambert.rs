//! Generalised Lambert, f = C min((1 − m²/4)^(−d/2), ξ_max) (4.58, 4.59).

use crate::albedo::directional_albedo;
use crate::error::{above, within};
use crate::geometry::{below_horizon, retro_metric_squared};
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Chart, ChartKind};
use crate::sampling::Cosine;
use crate::{Brdf, Direction, ParameterError};

/// Smoothness d (0 … 1; 0 is Lambert, 1 the "full moon") with ξ constant above m = `clip`.
///
/// For L = V the reflected radiance goes as cos^(1−d)Θ until the clip. The albedo grows
/// with the angle and is greatest at the horizon, where it is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneralisedLambert {
    d: f64,
    clip: f64,
    greatest: f64,
    constant: f64,
}

impl GeneralisedLambert {
    /// With `clip` above 0 and below 2 (1.9 in Table 4.3).
    pub fn new(d: f64, clip: f64) -> Result<Self, ParameterError> {
        let d = within("d", d, 0.0, 1.0)?;
        let clip = above("clip", clip, 0.0, 2.0 - 1e-9)?;
        let mut model = Self {
            d,
            clip,
            greatest: (1.0 - 0.25 * clip * clip).powf(-0.5 * d),
            constant: 1.0,
        };
        model.constant = 1.0 / directional_albedo(&model, 0.0).value;
        Ok(model)
    }

    /// ξ_max = ξ(clip).
    pub fn greatest_profile(&self) -> f64 {
        self.greatest
    }

    /// The weight of the largest Lambertian part that can be taken out, π C.
    pub fn removable_diffuse(&self) -> f64 {
        std::f64::consts::PI * self.constant
    }
}

impl Brdf for GeneralisedLambert {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        if below_horizon(l, v) {
            return 0.0;
        }
        // 1 − m²/4 = |L_P − V_P|²/4 + (NL² + NV²)/2.
        let rest = 0.25 * retro_metric_squared(l, v) + 0.5 * (l.z * l.z + v.z * v.z);
        self.constant * rest.min(1.0).powf(-0.5 * self.d).min(self.greatest)
    }

    fn peak(&self) -> f64 {
        self.constant * self.greatest
    }

    fn chart(&self, _l: &Direction) -> Chart {
        // The profile is about R, and bends at the clip.
        Chart::new(ChartKind::Plane, 1.0).with_edges(&[self.clip])
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "generalised_lambert",
    source: "(4.58), (4.59)",
    formula: "C min((1 − m²/4)^(−d/2), ξ_max)",
    parameters: "d 0 … 1; clip above 0 and below 2",
    reciprocal: true,
    grazing: "albedo greatest, 1, at the horizon",
    examples: || {
        vec![
            example(
                "d = 1, clip 1.9",
                GeneralisedLambert::new(1.0, 1.9).expect("in range"),
                Conserves,
            ),
            example(
                "d = 0.3, clip 1.9",
                GeneralisedLambert::new(0.3, 1.9).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: Some(|v, visit| {
        let m = GeneralisedLambert::new(1.0, 1.9).expect("in range");
        visit(&m, &Cosine::new(&m, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;

    #[test]
    fn the_albedo_grows_to_one_at_the_horizon() {
        let m = GeneralisedLambert::new(1.0, 1.9).unwrap();
        let mut before = 0.0;
        for degrees in [0.0, 30.0, 60.0, 75.0, 85.0, 90.0] {
            let a = directional_albedo_at(&m, degrees).value;
            assert!(a > before && a <= 1.0 + 1e-10, "{degrees}: {a}");
            before = a;
        }
        assert!((before - 1.0).abs() < 1e-10);
    }

    #[test]
    fn the_full_moon_is_a_flat_disc() {
        let m = GeneralisedLambert::new(1.0, 1.9).unwrap();
        let radiance = |degrees: f64| {
            let l = Direction::from_degrees(degrees, 0.0);
            m.reflect(&l, &l)[0]
        };
        assert!((radiance(60.0) / radiance(0.0) - 1.0).abs() < 1e-12);
        // Beyond m = 2 sinΘ = 1.9 it falls as the cosine.
        assert!(radiance(85.0) < 0.5 * radiance(0.0));
        // Taking out the Lambertian of Table 4.3's a_diffuse would leave a negative rest.
        assert!(m.removable_diffuse() < directional_albedo_at(&m, 0.0).value);
    }

    #[test]
    fn the_profile_is_clipped_at_the_clip() {
        for (d, clip) in [(1.0, 1.9), (0.3, 1.9), (0.7, 1.2)] {
            let m = GeneralisedLambert::new(d, clip).unwrap();
            // L = V at m = 2 sinΘ.
            let at = |metric: f64| {
                let l = Direction::from_cosine((1.0 - 0.25 * metric * metric).sqrt(), 0.0);
                m.eval(&l, &l) / m.eval(&Direction::NORMAL, &Direction::NORMAL)
            };
            let greatest = (1.0 - 0.25 * clip * clip).powf(-0.5 * d);
            for metric in [clip, clip * 1.0002, 0.5 * (clip + 2.0), 2.0] {
                assert!((at(metric) / greatest - 1.0).abs() < 1e-12, "{d}, {metric}");
            }
            let inside = 0.9998 * clip;
            let expected = (1.0 - 0.25 * inside * inside).powf(-0.5 * d);
            assert!((at(inside) / expected - 1.0).abs() < 1e-12);
            assert!(expected < greatest);
        }
    }
}
