//! The ideal mirror with Fresnel reflectance (1.29, 1.30): nothing but a Dirac part.

use crate::fresnel::Index;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, gold};
use crate::sampling::Specular;
use crate::{Brdf, Direction};

/// A smooth surface: radiance from R is reflected with the weight F(Θ), nothing else is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mirror {
    indices: Option<[Index; 3]>,
}

impl Mirror {
    /// The ideal mirror, F = 1.
    pub fn ideal() -> Self {
        Self { indices: None }
    }

    /// A mirror of the given complex index for each channel.
    pub fn new(indices: [Index; 3]) -> Self {
        Self {
            indices: Some(indices),
        }
    }

    /// The mirror direction and the weight of the radiance that comes from it.
    pub fn sample(&self, v: &Direction) -> (Direction, [f64; 3]) {
        (v.mirrored(), self.delta_weight(v))
    }
}

impl Brdf for Mirror {
    fn eval(&self, _l: &Direction, _v: &Direction) -> f64 {
        0.0
    }

    fn is_coloured(&self) -> bool {
        self.indices.is_some_and(|i| i[0] != i[1] || i[0] != i[2])
    }

    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        if l.z < 0.0 {
            return [0.0; 3];
        }
        match self.indices {
            None => [1.0; 3],
            Some(i) => i.map(|i| i.reflectance(l.z)),
        }
    }
}

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "mirror",
    source: "(1.29), (1.30)",
    formula: "F(Θ) Δ(V − R)/cosΘ",
    parameters: "one index for each channel, or ideal",
    reciprocal: true,
    grazing: "albedo F(Θ), 1 at 90°: a Dirac part only",
    examples: || {
        vec![
            example("gold's indices", Mirror::new(gold()), Conserves),
            example("ideal", Mirror::ideal(), Conserves),
        ]
    },
    sampler: Some(|v, visit| {
        let m = Mirror::new(gold());
        visit(&m, &Specular::new(&m, v));
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directional_albedo;

    #[test]
    fn the_albedo_is_the_fresnel_reflectance() {
        let glass = Mirror::new([Index::new(1.5, 0.0).unwrap(); 3]);
        for c in [0.0, 0.1, 0.7, 1.0] {
            let a = directional_albedo(&glass, c);
            assert!((a.value - crate::fresnel::dielectric(1.5, c)).abs() < 1e-12);
        }
        assert_eq!(directional_albedo(&Mirror::ideal(), 0.3).value, 1.0);
    }
}
