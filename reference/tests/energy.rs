//! Albedo at most 1 for every parameter set that is said to conserve energy, within the
//! quadrature's own error estimate; and above 1 for those that are said not to.

use microbrdf_reference::albedo::{directional_albedo_for, greatest_albedo};
use microbrdf_reference::measured::measure;
use microbrdf_reference::models::registry::Claim;
use microbrdf_reference::models::{
    ALL, LommelSeeliger, OrenNayar, OrenNayarFull, Scattering, Ward,
};
use microbrdf_reference::quadrature::Accuracy;
use microbrdf_reference::{Direction, directional_albedo_at};

fn check(part: usize) {
    for entry in ALL.iter().skip(part).step_by(2) {
        for example in (entry.examples)() {
            let m = measure(example.model.as_ref());
            let what = format!("{} ({}): {m:?}", entry.name, example.parameters);
            match example.claim {
                Claim::Conserves => {
                    assert!(m.greatest.value <= 1.0 + m.greatest.error + 1e-10, "{what}");
                    // And at the horizon itself.
                    let l = Direction::from_degrees(90.0, 20.0);
                    let a = directional_albedo_for(example.model.as_ref(), &l, Accuracy::COARSE);
                    assert!(a.value <= 1.0 + a.error + 1e-7, "{what}: {a:?} at 90°");
                }
                Claim::Exceeds => {
                    assert!(m.greatest.value > 1.0 + 1e-4 + m.greatest.error, "{what}");
                }
            }
        }
    }
}

// Two halves, for two cores.
#[test]
fn claims_of_the_even_entries() {
    check(0);
}

#[test]
fn claims_of_the_odd_entries() {
    check(1);
}

#[test]
fn figures_of_the_models_that_do_not_conserve_energy() {
    let ward = Ward::new(0.1).unwrap();
    for (degrees, albedo) in [(89.995, 1.175), (89.999, 2.624), (89.9995, 3.710)] {
        let a = directional_albedo_at(&ward, degrees);
        assert!((a.value - albedo).abs() < 5e-4, "{degrees}: {a:?}");
    }
    let short = greatest_albedo(&OrenNayar::new(1.0, 0.2).unwrap());
    assert!((short.1.value - 1.015).abs() < 5e-4, "{short:?}");
    let full = directional_albedo_at(&OrenNayarFull::new(1.0, 0.3).unwrap(), 89.9);
    assert!((full.value - 1.050).abs() < 5e-4, "{full:?}");
    let moon = LommelSeeliger::new(1.0, 0.0, Scattering::Isotropic).unwrap();
    let at = |c: f64| microbrdf_reference::directional_albedo(&moon, c).value;
    assert!(at(0.397) > 1.0 && at(0.399) < 1.0);
}
