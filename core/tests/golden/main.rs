//! The core's results to the last bit, kept beside this test: any change of
//! what is computed shows here, in a second, without the reference.
//!
//! That they are right, other tests say; this one says that they are the
//! same, and cargo-mutants lives on it (`docs/mutation.md`). After a change on purpose,
//! `UPDATE_EXPECT=1 cargo test -p microbrdf --all-features --test golden`
//! writes the sums anew.

mod encoding;
mod exposed;
mod given;
mod highlight;
mod models;
mod places;
mod sampling;
mod scene;
mod view;
mod wild;

use expect_test::{ExpectFile, expect_file};
use microbrdf::arithmetic::{F32, Q15, Q31};

use crate::given::{Given, Viewed};

/// Names and sums, a line each.
struct Sums(String);

impl Sums {
    fn push(&mut self, name: &str, sum: u64) {
        self.0 += &format!("{sum:016x}  {name}\n");
    }
}

/// What every arithmetic has.
fn shading<A: Viewed>(sums: &mut Sums) {
    models::add::<A>(sums);
    wild::add::<A>(sums);
    scene::add::<A>(sums);
    view::add::<A>(sums);
    places::add::<A>(sums);
}

fn compare<A: Given>(kept: &ExpectFile, add: fn(&mut Sums)) {
    let mut sums = Sums(String::new());
    add(&mut sums);
    kept.assert_eq(&sums.0);
}

#[test]
fn f32() {
    compare::<F32>(&expect_file!["sums/f32.txt"], |sums| {
        shading::<F32>(sums);
        sampling::add::<F32>(sums);
    });
}

#[test]
fn q31() {
    compare::<Q31>(&expect_file!["sums/q31.txt"], |sums| {
        shading::<Q31>(sums);
        sampling::add::<Q31>(sums);
    });
}

#[test]
fn q31_with_small_tables() {
    compare::<Q31<64>>(&expect_file!["sums/q31-64.txt"], |sums| {
        shading::<Q31<64>>(sums);
    });
}

#[test]
fn q15() {
    compare::<Q15>(&expect_file!["sums/q15.txt"], shading::<Q15>);
}

#[cfg(feature = "micromath")]
#[test]
fn micromath() {
    use microbrdf::arithmetic::Micromath;
    compare::<Micromath>(&expect_file!["sums/micromath.txt"], shading::<Micromath>);
}

#[test]
fn exposed() {
    let mut sums = Sums(String::new());
    exposed::add(&mut sums);
    expect_file!["sums/exposed.txt"].assert_eq(&sums.0);
}

#[test]
fn encodings() {
    let mut sums = Sums(String::new());
    encoding::add(&mut sums);
    expect_file!["sums/encodings.txt"].assert_eq(&sums.0);
}

#[test]
fn highlight() {
    let mut sums = Sums(String::new());
    highlight::add(&mut sums);
    expect_file!["sums/highlight.txt"].assert_eq(&sums.0);
}
