//! Albedo at most 1 for every parameter set that is said to conserve energy, within the
//! quadrature's own error estimate; and above 1 for those that are said not to.

use microbrdf_reference::albedo::{directional_albedo_for, greatest_albedo};
use microbrdf_reference::documentation::models_markdown_of;
use microbrdf_reference::measured::{Measured, measure};
use microbrdf_reference::models::entry::Claim;
use microbrdf_reference::models::{
    ALL, LommelSeeliger, OrenNayar, OrenNayarFull, Scattering, Ward,
};
use microbrdf_reference::quadrature::Accuracy;
use microbrdf_reference::{Direction, directional_albedo_at};
use std::sync::OnceLock;

/// Every parameter set of every model, measured once, on two cores.
fn all() -> &'static [Vec<Measured>] {
    static ALL_MEASURED: OnceLock<Vec<Vec<Measured>>> = OnceLock::new();
    ALL_MEASURED.get_or_init(|| {
        let of = |i: usize| -> Vec<Measured> {
            (ALL[i].examples)()
                .iter()
                .map(|e| measure(e.model.as_ref()))
                .collect()
        };
        std::thread::scope(|scope| {
            let odd = scope.spawn(|| (1..ALL.len()).step_by(2).map(of).collect::<Vec<_>>());
            let mut even = (0..ALL.len())
                .step_by(2)
                .map(of)
                .collect::<Vec<_>>()
                .into_iter();
            let mut odd = odd.join().expect("measured").into_iter();
            (0..ALL.len())
                .map(|i| if i % 2 == 0 { even.next() } else { odd.next() }.expect("one each"))
                .collect()
        })
    })
}

#[test]
fn claims_hold() {
    for (entry, measured) in ALL.iter().zip(all()) {
        for (example, m) in (entry.examples)().iter().zip(measured) {
            let what = format!("{} ({}): {m:?}", entry.name, example.parameters);
            // Measured tables are not smooth: their error is as large as it is.
            let table = entry.name.starts_with("measured");
            let relative = m.greatest.error / m.greatest.value;
            assert!(table || relative < 1e-6, "{what}");
            match example.claim {
                Claim::Conserves => {
                    // And at the horizon itself.
                    let (accuracy, bound) = if table {
                        (Accuracy::COARSE, f64::INFINITY)
                    } else {
                        (Accuracy::FINE, 1e-10)
                    };
                    let l = Direction::from_degrees(90.0, 20.0);
                    let horizon = directional_albedo_for(example.model.as_ref(), &l, accuracy);
                    for a in [m.greatest, horizon] {
                        assert!(a.error < bound, "{what}: {a:?}");
                        assert!(a.value <= 1.0 + a.error, "{what}: {a:?}");
                    }
                }
                Claim::Exceeds => {
                    assert!(m.greatest.value > 1.0 + 1e-4 + m.greatest.error, "{what}");
                }
            }
        }
    }
}

#[test]
fn the_documentation_is_what_is_measured() {
    let text = models_markdown_of(all());
    for entry in ALL {
        assert!(
            text.contains(&format!("| `{}` |", entry.name)),
            "{} is missing",
            entry.name
        );
    }
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/models.md");
    let Ok(kept) = std::fs::read_to_string(file) else {
        panic!("docs/models.md is missing: see its first line for how it is made");
    };
    for (i, (new, old)) in text.lines().zip(kept.lines()).enumerate() {
        assert_eq!(new, old, "docs/models.md, line {}: make it anew", i + 1);
    }
    assert_eq!(text.lines().count(), kept.lines().count());
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
