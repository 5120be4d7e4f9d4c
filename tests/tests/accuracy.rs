//! Arithmetic error of every model in every arithmetic, against the table of
//! tolerances.

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf_scene::HostArithmetic;
use microbrdf_tests::domain::Set;
use microbrdf_tests::error::Subject;
use microbrdf_tests::grazing;
use microbrdf_tests::registry;
use microbrdf_tests::tolerance::{Exposure, SLACK, TABLE, find};

/// Pairs in each set, for each entry of the registry.
const SAMPLES: usize = 2000;

/// The greatest errors that the samples of a row of the table showed.
#[derive(Clone, Copy, Debug, Default)]
struct Found {
    lsb_max: f64,
    off_by_one: f64,
    used: bool,
}

fn measure<A: HostArithmetic>(found: &mut [Found], faults: &mut Vec<String>) {
    for entry in registry::all() {
        let subject = Subject::<A>::new(&entry.material());
        let peak = subject.exact.peak();
        for exposure in [Exposure::One, Exposure::Peak] {
            let k = if exposure == Exposure::One {
                1.0
            } else {
                peak.max(1e-3)
            };
            let Some(row) = find(A::NAME, entry.model, exposure, peak) else {
                faults.push(format!(
                    "{} {}: no tolerance at {exposure:?}",
                    A::NAME,
                    entry.toml
                ));
                continue;
            };
            found[row].used = true;
            for set in Set::ALL {
                let pairs = entry.pairs(set, 9.0 + k.max(1.0).ln(), SAMPLES);
                let error = subject.code_error(&pairs, k);
                found[row].lsb_max = found[row].lsb_max.max(error.lsb_max);
                // A share of a handful of codes means nothing.
                if error.counted > 1000 {
                    found[row].off_by_one = found[row].off_by_one.max(error.off_by_one);
                }
                let bound = TABLE[row];
                if error.lsb_max > bound.lsb_max
                    || (error.counted > 1000 && error.off_by_one > bound.off_by_one)
                    || (bound.lsb_max < 1.5 && error.code_max > 1)
                {
                    faults.push(format!(
                        "{} {} {exposure:?} {set:?}: {error:?}",
                        A::NAME,
                        entry.toml
                    ));
                }
            }
        }
    }
}

#[test]
fn every_model_stays_within_its_tolerance_and_every_tolerance_is_tight() {
    let mut found = vec![Found::default(); TABLE.len()];
    let mut faults = Vec::new();
    measure::<F32>(&mut found, &mut faults);
    measure::<Micromath>(&mut found, &mut faults);
    measure::<Q31>(&mut found, &mut faults);
    measure::<Q15>(&mut found, &mut faults);
    for (row, found) in TABLE.iter().zip(&found) {
        println!("{row:?}: {found:?}");
        if !found.used {
            faults.push(format!("{row:?} is used by nothing"));
        } else if row.lsb_max > found.lsb_max + SLACK {
            faults.push(format!("{row:?} is loose: {:.4} was found", found.lsb_max));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Whatever the larger cosine is, in the shading frame and in world space, at K = 1
/// and at K = c, for broad lobes and for narrow ones.
#[test]
fn q15_is_at_most_one_code_off() {
    let found = grazing::found();
    let broad = found.by_cosine.as_flattened().iter();
    let all = broad.chain(found.by_peak.as_flattened());
    for (lsb, codes) in all {
        assert!(*codes <= 1 && (0.5..1.5).contains(lsb), "{found:?}");
    }
}
