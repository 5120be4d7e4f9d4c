//! Scene files at random, for as long as `MICROBRDF_FUZZ_SECONDS` says (a
//! second if it says nothing), from the seed `MICROBRDF_FUZZ_SEED`. What fails
//! is printed with the seed that comes to it at once.

use std::time::{Duration, Instant};

use microbrdf_scene::HostArithmetic;
use microbrdf_tests::fuzz::setting;
use microbrdf_tests::fuzz_scene::{BYTES, check, text};
use microbrdf_tests::in_every_arithmetic;
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

in_every_arithmetic!(any_file);

/// The file of a seed.
fn file(seed: u64) -> String {
    let mut bytes = vec![0; BYTES];
    Pcg64Mcg::seed_from_u64(seed).fill_bytes(&mut bytes);
    text(&bytes)
}

fn any_file<A: HostArithmetic>() {
    let time = Duration::from_secs(setting("MICROBRDF_FUZZ_SECONDS", 1));
    let first = setting("MICROBRDF_FUZZ_SEED", 1);
    let begun = Instant::now();
    let (mut cases, mut read) = (0, 0);
    while begun.elapsed() < time || cases < 20 {
        let seed = first.wrapping_add(cases);
        let text = file(seed);
        let started = Instant::now();
        let outcome = std::panic::catch_unwind(|| check::<A>(&text))
            .unwrap_or_else(|_| Err("it panicked".to_owned()));
        let took = started.elapsed();
        let mut refused = false;
        match outcome {
            Ok(true) => read += 1,
            Ok(false) => refused = true,
            Err(fault) => panic!(
                "{}: {fault}; again with MICROBRDF_FUZZ_SEED={seed}\n{text}",
                A::NAME
            ),
        }
        // An albedo under a sky is an integral, and takes its time.
        assert!(
            !refused || took < Duration::from_secs(1),
            "{took:?} with MICROBRDF_FUZZ_SEED={seed}"
        );
        cases += 1;
    }
    assert!(read > 0, "none of {cases} files is a scene");
    println!("{}: {cases} files, {read} of them scenes", A::NAME);
}

/// The files reach what they are there for: scenes, and refusals of many kinds.
#[test]
fn files_are_of_many_kinds() {
    let mut refusals = std::collections::BTreeSet::new();
    let mut scenes = 0;
    for seed in 0..2000 {
        match microbrdf_scene::Description::from_toml("it.toml", "it", &file(seed)) {
            Ok(_) => scenes += 1,
            Err(error) => {
                // Without names and values: which mistake it is.
                let kind = error.message.rsplit(": ").next().unwrap_or_default();
                refusals.insert(kind.to_owned());
            }
        }
    }
    assert!((200..1800).contains(&scenes), "{scenes} scenes");
    assert!(
        refusals.len() > 60,
        "{} kinds: {refusals:?}",
        refusals.len()
    );
    // Bytes that end early are a case, too.
    assert!(text(&[]).contains("exposure"));
}
