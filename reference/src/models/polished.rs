//! Polishing: any model and an ideal mirror in its missing albedo,
//! f + (1 − a(L)) F(Θ) f_mirror (4.56, 4.57).

use crate::albedo::directional_albedo_for;
use crate::brdf::Channel;
use crate::fresnel::Index;
use crate::models::Patch;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};
use crate::quadrature::{Accuracy, Chart};
use crate::sampling::{Choice, PatchDisc, PatchMethod, Sampler, Specular};
use crate::{Brdf, Direction};

/// A model with a Dirac part of weight (1 − a(L)) F, each channel by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polished<B> {
    base: B,
    mirror: Option<Index>,
}

impl<B: Brdf> Polished<B> {
    /// `mirror` is the index of the polished surface; none means F = 1.
    pub fn new(base: B, mirror: Option<Index>) -> Self {
        Self { base, mirror }
    }
}

impl<B: Brdf> Brdf for Polished<B> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        self.base.eval(l, v)
    }

    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.base.eval_rgb(l, v)
    }

    fn is_coloured(&self) -> bool {
        self.base.is_coloured()
    }

    fn peak(&self) -> f64 {
        self.base.peak()
    }

    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        self.base.rho(l, v)
    }

    /// Found by quadrature at every call: milliseconds.
    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        if l.z < 0.0 {
            return [0.0; 3];
        }
        let f = self.mirror.map_or(1.0, |i| i.reflectance(l.z));
        let missing = |channel: usize| {
            let a = directional_albedo_for(&Channel(&self.base, channel), l, Accuracy::FINE);
            ((1.0 - a.value) * f).max(0.0)
        };
        if self.is_coloured() {
            [0, 1, 2].map(missing)
        } else {
            [missing(0); 3]
        }
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
    name: "polished",
    source: "(4.56), (4.57)",
    formula: "f_base + (1 − a(L)) F(Θ) Δ(V − R)/cosΘ",
    parameters: "any base; index of the polish, or ideal",
    reciprocal: true,
    grazing: "a mirror in the base's missing albedo",
    examples: || {
        vec![example(
            "basic patch R = 1, ideal mirror",
            Polished::new(Patch::new(1.0).expect("in range"), None),
            Conserves,
        )]
    },
    sampler: Some(|v, visit| {
        let base = Patch::new(1.0).expect("in range");
        let m = Polished::new(base, None);
        let a = base.exact_albedo(v.z);
        let parts: Vec<(f64, Box<dyn Sampler>)> = vec![
            (a, Box::new(PatchDisc::new(1.0, v, PatchMethod::Rejection))),
            (1.0 - a, Box::new(Specular::new(&m, v))),
        ];
        visit(&m, &Choice::new(&m, v, parts));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo_at;
    use crate::models::{Lambert, Patch};

    #[test]
    fn the_missing_albedo_is_filled() {
        let m = Polished::new(Patch::new(1.0).unwrap(), None);
        for degrees in [0.0, 45.0, 90.0] {
            let a = directional_albedo_at(&m, degrees);
            assert!((a.value - 1.0).abs() < 1e-9, "{degrees}: {a:?}");
        }
    }

    #[test]
    fn each_channel_has_its_own() {
        let glass = Index::new(1.5, 0.0).unwrap();
        let m = Polished::new(Lambert::new([0.9, 0.5, 0.0]).unwrap(), Some(glass));
        let w = m.delta_weight(&Direction::NORMAL);
        for (w, a) in w.into_iter().zip([0.9, 0.5, 0.0]) {
            assert!((w - 0.04 * (1.0 - a)).abs() < 1e-10);
        }
    }
}
