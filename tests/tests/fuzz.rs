//! Materials and directions at random, for as long as
//! `MICROBRDF_FUZZ_SECONDS` says (a second if it says nothing), from the seed
//! `MICROBRDF_FUZZ_SEED`. What fails is printed with the seed that comes to it
//! at once.

use std::time::{Duration, Instant};

use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::fuzz::{BYTES, Case, check, setting};
use microbrdf_tests::in_every_arithmetic;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

in_every_arithmetic!(any_material_and_directions);

/// The case of a seed.
fn case(seed: u64) -> Case {
    let mut bytes = vec![0; BYTES];
    Pcg64Mcg::seed_from_u64(seed).fill_bytes(&mut bytes);
    Case::new(&bytes)
}

fn any_material_and_directions<A: Tested>() {
    let time = Duration::from_secs(setting("MICROBRDF_FUZZ_SECONDS", 1));
    let first = setting("MICROBRDF_FUZZ_SEED", 1);
    let begun = Instant::now();
    let mut cases = 0;
    while begun.elapsed() < time || cases < 20 {
        let seed = first.wrapping_add(cases);
        let case = case(seed);
        let outcome = std::panic::catch_unwind(|| check::<A>(&case))
            .unwrap_or_else(|_| Err("it panicked".to_owned()));
        if let Err(fault) = outcome {
            panic!(
                "{}, {}: {fault}; again with MICROBRDF_FUZZ_SEED={seed}",
                A::NAME,
                case.toml
            );
        }
        cases += 1;
    }
    println!("{}: {cases} materials, {} pairs", A::NAME, 64 * cases);
}

/// The cases reach what they are there for.
#[test]
fn cases_are_many_kinds() {
    let mut counts = std::collections::BTreeMap::<String, u32>::new();
    let (mut units, mut all) = (0, 0);
    for seed in 0..1100 {
        let case = case(seed);
        let model = case.toml.split('"').nth(1).expect("a model").to_owned();
        *counts.entry(model).or_default() += 1;
        for place in case.places {
            let square: f64 = place.vectors[1].iter().map(|c| c * c).sum();
            units += u32::from((square - 1.0).abs() < 1e-9);
            all += 1;
        }
    }
    assert_eq!(counts.len(), 11, "{counts:?}");
    assert!(counts.values().all(|count| *count > 60), "{counts:?}");
    let share = f64::from(units) / f64::from(all);
    assert!((0.7..0.9).contains(&share), "{share}");
    // Bytes that end early are a case, too.
    assert!(Case::new(&[]).toml.contains("lambert"));
}
