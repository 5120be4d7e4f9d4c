//! Cook–Torrance, f = D G F/(4 NL·NV) (1.35, 2.9): Beckmann, Gaussian, Trowbridge or Blinn
//! facets, V-cavity, He–Torrance's or Smith's attenuation.

use super::microfacet::{Attenuation, Distribution, Facet, Microfacet, microfacet_brdf};
use crate::ParameterError;
use crate::models::entry::Claim::{Conserves, Exceeds};
use crate::models::entry::{ModelEntry, example};

/// Cook–Torrance. With the V-cavity term and F = 1 the albedo is at most 1 for every width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CookTorrance(Microfacet);

impl CookTorrance {
    /// Any distribution, an attenuation that fits it, and the facets' reflectance.
    pub fn new(
        distribution: Distribution,
        attenuation: Attenuation,
        facet: Facet,
    ) -> Result<Self, ParameterError> {
        Ok(Self(Microfacet::new(distribution, attenuation, facet)?))
    }

    /// Beckmann with RMS slope m (1e-4 … 10), V-cavities, F = 1: (2.9) with (2.10).
    pub fn beckmann(m: f64) -> Result<Self, ParameterError> {
        Self::new(
            Distribution::beckmann(m)?,
            Attenuation::VCavity,
            Facet::White,
        )
    }
}

microfacet_brdf!(CookTorrance);

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "cook_torrance",
    source: "(1.35) to (1.38), (2.9), (2.10)",
    formula: "D G F/(4 NL·NV)",
    parameters: "Beckmann m, Gaussian s, Trowbridge q or Blinn t; V-cavity, He–Torrance's or Smith's G; F",
    reciprocal: true,
    grazing: "with V-cavities the albedo tends to 1 and f stays at most D/(2 LH max(NL, NV)); without G it is unbounded",
    examples: || {
        let gaussian = Distribution::gaussian(5.0).expect("in range");
        let trowbridge = Distribution::trowbridge(0.3).expect("in range");
        let blinn = Distribution::blinn(30.0).expect("in range");
        let beckmann = Distribution::beckmann(0.3).expect("in range");
        let new = |d, a| CookTorrance::new(d, a, Facet::White).expect("they fit");
        vec![
            example(
                "Beckmann m = 0.3, V-cavity",
                new(beckmann, Attenuation::VCavity),
                Conserves,
            ),
            example(
                "Beckmann m = 0.1, V-cavity",
                CookTorrance::beckmann(0.1).expect("in range"),
                Conserves,
            ),
            example(
                "Gaussian s = 5, V-cavity",
                new(gaussian, Attenuation::VCavity),
                Conserves,
            ),
            example(
                "Trowbridge q = 0.3, V-cavity",
                new(trowbridge, Attenuation::VCavity),
                Conserves,
            ),
            example(
                "Blinn t = 30, V-cavity",
                new(blinn, Attenuation::VCavity),
                Conserves,
            ),
            example(
                "Beckmann m = 0.3, Smith",
                new(beckmann, Attenuation::Smith),
                Conserves,
            ),
            example(
                "Beckmann m = 0.3, He–Torrance",
                new(beckmann, Attenuation::HeTorrance),
                Conserves,
            ),
            example(
                "Beckmann m = 0.3, G = 1",
                new(beckmann, Attenuation::None),
                Exceeds,
            ),
        ]
    },
    sampler: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Brdf, Direction, directional_albedo_at};

    #[test]
    fn the_albedo_stays_below_one_with_v_cavities_and_diverges_without() {
        let with = CookTorrance::beckmann(0.1).unwrap();
        let d = Distribution::beckmann(0.1).unwrap();
        let without = CookTorrance::new(d, Attenuation::None, Facet::White).unwrap();
        for (degrees, bounded, unbounded) in [
            (89.9, 0.998_339_665_5, 16.67),
            (89.99, 0.999_833_947_3, 162.1),
            (89.999, 0.999_983_394_7, 1617.0),
        ] {
            let a = directional_albedo_at(&with, degrees);
            assert!((a.value - bounded).abs() < 1e-9, "{degrees}: {a:?}");
            let a = directional_albedo_at(&without, degrees);
            assert!((a.value / unbounded - 1.0).abs() < 1e-3, "{degrees}: {a:?}");
        }
    }

    #[test]
    fn the_value_is_the_printed_one() {
        let m = CookTorrance::beckmann(0.3).unwrap();
        let n = Direction::NORMAL;
        let peak = 1.0 / (4.0 * std::f64::consts::PI * 0.09);
        assert!((m.eval(&n, &n) / peak - 1.0).abs() < 1e-14);
    }

    #[test]
    fn attenuations_that_do_not_fit_are_refused() {
        let blinn = Distribution::blinn(20.0).unwrap();
        let e = CookTorrance::new(blinn, Attenuation::Smith, Facet::White).unwrap_err();
        assert_eq!(e.parameter, "attenuation");
    }
}
