//! Files at random, for as long as `MICROBRDF_FUZZ_SECONDS` says (a second if
//! it says nothing), from the seed `MICROBRDF_FUZZ_SEED`. What fails is printed
//! with the seed that comes to it at once.

use std::panic::{RefUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::fuzz::setting;

/// Least number of files in a run.
const FEWEST: u64 = 20;
/// How long a file may take.
const LONGEST: Duration = Duration::from_secs(1);
/// How often it is tried: a machine that does something else is slow once.
const TRIES: usize = 5;

/// A kind of file.
#[derive(Clone, Copy, Debug)]
pub struct Files {
    /// What those are that are read, in the plural.
    pub what: &'static str,
    /// Bytes that it takes at most.
    pub bytes: usize,
    /// The file that bytes stand for.
    pub text: fn(&[u8]) -> String,
    /// Whether one that is read is timed, too, and not only one that is refused.
    pub all_are_timed: bool,
}

impl Files {
    /// The file of a seed.
    #[must_use]
    pub fn file(&self, seed: u64) -> String {
        let mut bytes = vec![0; self.bytes];
        Pcg64Mcg::seed_from_u64(seed).fill_bytes(&mut bytes);
        (self.text)(&bytes)
    }

    /// Checks files: whether one was read, or what is wrong.
    ///
    /// # Panics
    /// If a check fails or panics, a file takes too long, or none was read.
    pub fn run(&self, name: &str, check: impl Fn(&str) -> Result<bool, String> + RefUnwindSafe) {
        let time = Duration::from_secs(setting("MICROBRDF_FUZZ_SECONDS", 1));
        let first = setting("MICROBRDF_FUZZ_SEED", 1);
        let begun = Instant::now();
        let (mut cases, mut read) = (0, 0);
        while begun.elapsed() < time || cases < FEWEST {
            let seed = first.wrapping_add(cases);
            let text = self.file(seed);
            let started = Instant::now();
            let outcome = catch_unwind(|| check(&text));
            let mut took = started.elapsed();
            let was_read = match outcome.unwrap_or_else(|_| Err("it panicked".to_owned())) {
                Ok(was_read) => was_read,
                Err(fault) => {
                    panic!("{name}: {fault}; again with MICROBRDF_FUZZ_SEED={seed}\n{text}")
                }
            };
            if self.all_are_timed || !was_read {
                let mut tries = 1;
                while took >= LONGEST && tries < TRIES {
                    let started = Instant::now();
                    let _ = check(&text);
                    took = started.elapsed();
                    tries += 1;
                }
                assert!(took < LONGEST, "{took:?} with MICROBRDF_FUZZ_SEED={seed}");
            }
            read += u64::from(was_read);
            cases += 1;
        }
        assert!(read > 0, "none of {cases} files makes {}", self.what);
        println!("{name}: {cases} files, {read} of them {}", self.what);
    }
}
