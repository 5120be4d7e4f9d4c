//! Lacquer over any base, (1.60) and (1.61): a mirror part F and, below it,
//! (1 − F) e^(−s(1/NL + 1/NV)) f_base, with F at the angle between L and H.

use crate::brdf::luminance;
use crate::error::channels_within;
use crate::fresnel::Index;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::models::Lambert;
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example, index};
use crate::quadrature::Chart;
use crate::{Brdf, Direction, ParameterError};

/// A layer of absorbance s (each channel, at least 0) and, if given, a reflecting surface.
///
/// The texts leave the angle of the Fresnel term open; it is the one between L and H
/// here. A thin reflecting layer over a bright base does not conserve energy at grazing
/// angles: the surface reflects everything and the base is still lit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lacquer<B> {
    base: B,
    absorbance: [f64; 3],
    surface: Option<Index>,
}

impl<B: Brdf> Lacquer<B> {
    /// Absorbance s of each channel, finite and at least 0 (a negative one would amplify);
    /// no `surface` gives (1.60) on the base.
    pub fn new(
        base: B,
        absorbance: [f64; 3],
        surface: Option<Index>,
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            base,
            absorbance: channels_within("absorbance", absorbance, 0.0, 1e6)?,
            surface,
        })
    }

    fn passed(&self, channel: usize, path: f64) -> f64 {
        let s = self.absorbance[channel];
        if s == 0.0 { 1.0 } else { (-s * path).exp() }
    }

    fn reflected(&self, cos: f64) -> f64 {
        self.surface.map_or(0.0, |i| i.reflectance(cos))
    }
}

impl<B: Brdf> Brdf for Lacquer<B> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.is_coloured() {
            luminance(f)
        } else {
            f[0]
        }
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let through = 1.0 - self.reflected(Half::of(l, v).map_or(0.0, |h| h.lh));
        let path = 1.0 / l.z + 1.0 / v.z;
        let base = self.base.eval_rgb(l, v);
        [0, 1, 2].map(|i| through * self.passed(i, path) * base[i])
    }

    fn is_coloured(&self) -> bool {
        let s = self.absorbance;
        s[0] != s[1] || s[0] != s[2] || self.base.is_coloured()
    }

    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        if l.z < 0.0 {
            return [0.0; 3];
        }
        let f = self.reflected(l.z);
        let base = self.base.delta_weight(l);
        [0, 1, 2].map(|i| f + (1.0 - f) * self.passed(i, 2.0 / l.z) * base[i])
    }

    fn chart(&self, l: &Direction) -> Chart {
        self.base.chart(l)
    }

    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.base.creases(l, v, out);
    }

    fn is_isotropic(&self) -> bool {
        self.base.is_isotropic()
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "lacquer",
    source: "(1.60), (1.61)",
    formula: "F mirror + (1 − F(angle(L, H))) e^(−s(1/NL + 1/NV)) f_base",
    parameters: "absorbance s at least 0; index of the surface, or none; any base",
    reciprocal: true,
    grazing: "absorption takes the base to 0; thin absorbance under a reflecting surface exceeds 1",
    examples: || {
        let base = Lambert::grey(1.0).expect("in range");
        vec![
            example(
                "s = 0.3 over white, no surface",
                Lacquer::new(base, [0.3; 3], None).expect("in range"),
                Conserves,
            ),
            example(
                "s = 0.3 over white, glass",
                Lacquer::new(base, [0.3; 3], Some(index(1.5, 0.0))).expect("in range"),
                Conserves,
            ),
            example(
                "s = 0.01 over white, glass",
                Lacquer::new(base, [0.01; 3], Some(index(1.5, 0.0))).expect("in range"),
                Exceeds,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Lambert;
    use std::f64::consts::FRAC_1_PI;

    #[test]
    fn absorption_is_along_both_paths() {
        let base = Lambert::grey(1.0).unwrap();
        let m = Lacquer::new(base, [0.3; 3], None).unwrap();
        let n = Direction::NORMAL;
        assert!((m.eval(&n, &n) - (-0.6f64).exp() * FRAC_1_PI).abs() < 1e-16);
        let low = Direction::from_degrees(60.0, 0.0);
        assert!((m.eval(&n, &low) - (-0.9f64).exp() * FRAC_1_PI).abs() < 1e-15);
        assert_eq!(m.eval(&n, &Direction::from_cosine(0.0, 0.0)), 0.0);
        assert!(Lacquer::new(base, [-0.1; 3], None).is_err());
    }

    #[test]
    fn the_surface_reflects_and_the_rest_passes() {
        let glass = Index::new(1.5, 0.0).unwrap();
        let m = Lacquer::new(Lambert::grey(0.5).unwrap(), [0.0; 3], Some(glass)).unwrap();
        let n = Direction::NORMAL;
        assert!((m.delta_weight(&n)[1] - 0.04).abs() < 1e-15);
        assert!((m.eval(&n, &n) - 0.96 * 0.5 * FRAC_1_PI).abs() < 1e-15);
    }
}
