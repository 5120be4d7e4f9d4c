//! OBJ files at random, for as long as `MICROBRDF_FUZZ_SECONDS` says (a second
//! if it says nothing), from the seed `MICROBRDF_FUZZ_SEED`. What fails is
//! printed with the seed that comes to it at once.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use microbrdf_scene::{HostArithmetic, Obj};
use microbrdf_tests::fuzz::setting;
use microbrdf_tests::fuzz_obj::{BYTES, check, text};
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

/// A folder that goes with the test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let name = format!("microbrdf-obj-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn any_file<A: HostArithmetic>() {
    let time = Duration::from_secs(setting("MICROBRDF_FUZZ_SECONDS", 1));
    let first = setting("MICROBRDF_FUZZ_SEED", 1);
    let folder = Folder::new(A::NAME);
    let begun = Instant::now();
    let (mut cases, mut read) = (0, 0);
    while begun.elapsed() < time || cases < 20 {
        let seed = first.wrapping_add(cases);
        let text = file(seed);
        let started = Instant::now();
        let outcome = std::panic::catch_unwind(|| check::<A>(&text, &folder.0))
            .unwrap_or_else(|_| Err("it panicked".to_owned()));
        match outcome {
            Ok(shaded) => read += u64::from(shaded),
            Err(fault) => panic!(
                "{}: {fault}; again with MICROBRDF_FUZZ_SEED={seed}\n{text}",
                A::NAME
            ),
        }
        let took = started.elapsed();
        assert!(
            took < Duration::from_secs(1),
            "{took:?} with MICROBRDF_FUZZ_SEED={seed}"
        );
        cases += 1;
    }
    assert!(read > 0, "none of {cases} files is a mesh");
    println!("{}: {cases} files, {read} of them meshes", A::NAME);
}

/// The files reach what they are there for: meshes, and refusals of many kinds.
#[test]
fn files_are_of_many_kinds() {
    let mut refusals = std::collections::BTreeSet::new();
    let mut meshes = 0;
    for seed in 0..2000 {
        match Obj::read("it.obj", &file(seed)) {
            Ok(_) => meshes += 1,
            Err(error) => {
                // Without what is quoted: which mistake it is.
                let kind = error.message.rsplit('`').next().unwrap_or_default();
                refusals.insert(kind.to_owned());
            }
        }
    }
    assert!((200..1800).contains(&meshes), "{meshes} meshes");
    assert!(
        refusals.len() > 12,
        "{} kinds: {refusals:?}",
        refusals.len()
    );
    // Bytes that end early are a case, too.
    assert_eq!(text(&[]), "");
}
