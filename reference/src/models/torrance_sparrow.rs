//! Torrance–Sparrow, f = D G F/(4 NL·NV) with V-cavities and Blinn's or the anisotropic
//! Ashikhmin–Shirley distribution (Chuang's slides, after pbrt).

use super::microfacet::{Attenuation, Distribution, Facet, Microfacet, microfacet_brdf};
use crate::ParameterError;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example};

/// Torrance–Sparrow. The albedo is at most 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorranceSparrow(Microfacet);

impl TorranceSparrow {
    /// With Blinn's distribution of exponent e, 0 … 1e8.
    pub fn blinn(exponent: f64, facet: Facet) -> Result<Self, ParameterError> {
        let d = Distribution::blinn(exponent)?;
        Ok(Self(Microfacet::new(d, Attenuation::VCavity, facet)?))
    }

    /// With Ashikhmin's and Shirley's distribution, exponents along x and y of 0 … 1e8.
    pub fn ashikhmin_shirley(x: f64, y: f64, facet: Facet) -> Result<Self, ParameterError> {
        let d = Distribution::ashikhmin_shirley(x, y)?;
        Ok(Self(Microfacet::new(d, Attenuation::VCavity, facet)?))
    }
}

microfacet_brdf!(TorranceSparrow);

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "torrance_sparrow",
    source: "slides, after pbrt",
    formula: "D G F/(4 NL·NV), Blinn's or Ashikhmin's and Shirley's D",
    parameters: "exponents 0 … 1e8; F",
    reciprocal: true,
    grazing: "as Cook–Torrance with V-cavities",
    examples: || {
        vec![
            example(
                "Blinn, e = 30",
                TorranceSparrow::blinn(30.0, Facet::White).expect("in range"),
                Conserves,
            ),
            example(
                "Ashikhmin–Shirley, 10 and 100",
                TorranceSparrow::ashikhmin_shirley(10.0, 100.0, Facet::White).expect("in range"),
                Conserves,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Brdf, Direction};

    #[test]
    fn equal_exponents_are_blinns_distribution() {
        let a = TorranceSparrow::blinn(30.0, Facet::White).unwrap();
        let b = TorranceSparrow::ashikhmin_shirley(30.0, 30.0, Facet::White).unwrap();
        let (l, v) = (
            Direction::from_degrees(40.0, 10.0),
            Direction::from_degrees(55.0, 170.0),
        );
        assert!((a.eval(&l, &v) / b.eval(&l, &v) - 1.0).abs() < 1e-13);
        assert!(b.is_isotropic());
    }
}
