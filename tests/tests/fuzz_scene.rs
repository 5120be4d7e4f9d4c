//! Scene files at random.

use microbrdf_scene::HostArithmetic;
use microbrdf_tests::fuzz_files::Files;
use microbrdf_tests::fuzz_scene::{BYTES, check, text};
use microbrdf_tests::in_every_arithmetic;

in_every_arithmetic!(any_file);

const FILES: Files = Files {
    what: "scenes",
    bytes: BYTES,
    text,
    // An albedo under a sky is an integral, and takes its time.
    all_are_timed: false,
};

fn any_file<A: HostArithmetic>() {
    FILES.run(A::NAME, check::<A>);
}

/// The files reach what they are there for: scenes, and refusals of many kinds.
#[test]
fn files_are_of_many_kinds() {
    let mut refusals = std::collections::BTreeSet::new();
    let mut scenes = 0;
    for seed in 0..2000 {
        match microbrdf_scene::Description::from_toml("it.toml", "it", &FILES.file(seed)) {
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
