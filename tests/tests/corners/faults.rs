//! What a result must be, whatever it is given.

use std::collections::BTreeMap;

use microbrdf::brdf::Brdf;
use microbrdf::geometry::Geometry;
use microbrdf_scene::AnyModel;
use microbrdf_tests::arithmetic::{Tested, bits};

/// The first fault of each model, all shown at the end.
#[derive(Default)]
pub(crate) struct Faults(BTreeMap<String, String>);

impl Faults {
    pub(crate) fn add(&mut self, name: &str, fault: impl FnOnce() -> String) {
        self.0.entry(name.to_owned()).or_insert_with(fault);
    }
}

impl Drop for Faults {
    fn drop(&mut self) {
        let lines: Vec<_> = self
            .0
            .iter()
            .map(|(name, fault)| format!("{name}: {fault}"))
            .collect();
        assert!(
            std::thread::panicking() || lines.is_empty(),
            "{}",
            lines.join("\n")
        );
    }
}

/// Finite, not negative, the share at most 1 and the radiance at most the
/// peak.
pub(crate) fn in_range<A: Tested>(
    faults: &mut Faults,
    name: &str,
    model: &AnyModel<A>,
    geometry: &impl Geometry<A>,
) {
    let share = model.share(geometry).to_array();
    let reflected = model.reflect(geometry).to_array();
    let f = model.brdf(geometry).to_array();
    for channel in 0..3 {
        let values = [
            A::unit_value(share[channel]),
            A::radiance_value(reflected[channel]),
            A::value_value(f[channel]),
        ];
        let fine = values
            .iter()
            .all(|value| value.is_finite() && value.is_sign_positive())
            && values[0] <= 1.0
            && A::at_most(reflected[channel], model.peak());
        if !fine {
            faults.add(name, || {
                format!(
                    "share, radiance and BRDF are {values:?} at cosines {:?}",
                    geometry.cosines()
                )
            });
        }
    }
}

pub(crate) fn is_zero<A: Tested>(
    faults: &mut Faults,
    name: &str,
    model: &AnyModel<A>,
    geometry: &impl Geometry<A>,
) {
    let all = [
        bits(model.share(geometry).to_array()),
        bits(model.reflect(geometry).to_array()),
        bits(model.brdf(geometry).to_array()),
    ];
    if all.concat().iter().any(|byte| *byte != 0) {
        faults.add(name, || {
            format!(
                "share {:?}, BRDF {:?} at cosines {:?}",
                model.share(geometry).to_array().map(A::unit_value),
                model.brdf(geometry).to_array().map(A::value_value),
                geometry.cosines()
            )
        });
    }
}
