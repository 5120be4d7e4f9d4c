//! Generalised Lambert, f = C min((1 − m²/4)^(−d/2), ξ_max) (4.58, 4.59).

use crate::albedo::directional_albedo;
use crate::brdf::luminance;
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
    albedo: [f64; 3],
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
            albedo: [1.0; 3],
        };
        model.constant = 1.0 / directional_albedo(&model, 0.0).value;
        Ok(model)
    }

    /// The same with a greatest albedo of each channel, 0 … 1, in place of 1.
    pub fn with_albedo(self, albedo: [f64; 3]) -> Result<Self, ParameterError> {
        let albedo = crate::error::channels_within("albedo", albedo, 0.0, 1.0)?;
        Ok(Self { albedo, ..self })
    }

    /// Whether it is that of a smoothness and a clip.
    pub fn is_of(&self, d: f64, clip: f64) -> bool {
        self.d == d && self.clip == clip
    }

    /// ξ at a squared distance m², and beyond the clip ξ_max.
    pub fn profile(&self, metric_squared: f64) -> f64 {
        (1.0 - 0.25 * metric_squared)
            .max(0.0)
            .powf(-0.5 * self.d)
            .min(self.greatest)
    }

    /// ξ_max = ξ(clip).
    pub fn greatest_profile(&self) -> f64 {
        self.greatest
    }

    /// The weight of the largest Lambertian part that can be taken out, π C for an albedo of 1.
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
        let f = self.constant * rest.min(1.0).powf(-0.5 * self.d).min(self.greatest);
        if self.is_coloured() {
            luminance(self.albedo.map(|a| a * f))
        } else {
            self.albedo[0] * f
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let white = Self {
            albedo: [1.0; 3],
            ..*self
        };
        let f = white.eval(l, v);
        self.albedo.map(|a| a * f)
    }

    fn is_coloured(&self) -> bool {
        let [r, g, b] = self.albedo;
        r != g || r != b
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
    fn an_albedo_is_a_share_of_each_channel() {
        let white = GeneralisedLambert::new(0.6, 1.9).unwrap();
        let clay = white.with_albedo([0.7, 0.4, 0.1]).unwrap();
        assert!(white.with_albedo([0.7, 1.1, 0.1]).is_err());
        let l = Direction::from_degrees(60.0, 0.0);
        let v = Direction::from_degrees(75.0, 15.0);
        let f = clay.eval_rgb(&l, &v);
        for (i, albedo) in [0.7, 0.4, 0.1].into_iter().enumerate() {
            assert!((f[i] / (albedo * white.eval(&l, &v)) - 1.0).abs() < 1e-14);
        }
        assert!((clay.eval(&l, &v) - luminance(f)).abs() < 1e-15);
        let m2 = retro_metric_squared(&l, &v);
        let about_r = crate::geometry::metric_squared(&l, &v);
        assert!(m2 < about_r, "turned back: {m2} {about_r}");
        let expected = white.profile(about_r) / white.profile(0.0);
        let n = Direction::NORMAL;
        assert!((white.eval(&l, &v) / white.eval(&n, &n) / expected - 1.0).abs() < 1e-12);
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
