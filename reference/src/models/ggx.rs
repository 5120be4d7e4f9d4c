//! GGX: Trowbridge–Reitz facets with Smith's term (Walter and others, *Microfacet models
//! for refraction through rough surfaces*, 2007). Not in the thesis; today's yardstick.

use super::microfacet::{Attenuation, Distribution, Facet, Microfacet, microfacet_brdf};
use crate::ParameterError;
use crate::models::entry::Claim::Conserves;
use crate::models::entry::{ModelEntry, example, gold};

/// GGX with roughness α (1e-4 … 1; the distribution's q) and separable Smith masking.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ggx(Microfacet);

impl Ggx {
    /// The facets' reflectance is taken at the angle between L and H.
    pub fn new(alpha: f64, facet: Facet) -> Result<Self, ParameterError> {
        let d = Distribution::trowbridge(alpha)?;
        Ok(Self(Microfacet::new(d, Attenuation::Smith, facet)?))
    }
}

microfacet_brdf!(Ggx);

/// Its place in the list of models.
pub const ENTRY: ModelEntry = ModelEntry {
    name: "ggx",
    source: "Walter et al. 2007; not in the thesis",
    formula: "D G1(L) G1(V) F/(4 NL·NV), D = α²/(π((α² − 1)cos²δ + 1)²)",
    parameters: "α 1e-4 … 1; F",
    reciprocal: true,
    grazing: "loses what is scattered more than once",
    examples: || {
        vec![
            example(
                "α = 0.3",
                Ggx::new(0.3, Facet::White).expect("in range"),
                Conserves,
            ),
            example(
                "α = 0.05, gold",
                Ggx::new(0.05, Facet::Coloured(gold())).expect("in range"),
                Conserves,
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
    fn a_single_scattering_loses_energy_and_never_gains_it() {
        let m = Ggx::new(0.5, Facet::White).unwrap();
        for degrees in [0.0, 30.0, 60.0, 85.0, 89.9] {
            let a = directional_albedo_at(&m, degrees);
            assert!(a.value < 1.0 && a.value > 0.6, "{degrees}: {a:?}");
        }
        let n = Direction::NORMAL;
        let peak = 1.0 / (4.0 * std::f64::consts::PI * 0.25);
        assert!((m.eval(&n, &n) / peak - 1.0).abs() < 1e-14);
    }
}
