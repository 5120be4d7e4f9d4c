//! `q15`'s error in the broadest lobes, whose end no table of even cells follows.

use std::fmt::Write as _;

use microbrdf::arithmetic::Q15;
use microbrdf_scene::{HostArithmetic, Material};

use crate::domain::Set;
use crate::error::Subject;

/// Exponents between those of the registry.
const EXPONENTS: [f64; 10] = [1.0, 1.05, 1.1, 1.175, 1.25, 1.325, 1.4, 1.45, 1.5, 2.0];
/// Pairs in each set.
const SAMPLES: usize = 20_000;

/// The greatest error in LSB of metallic Phong at K = 1.
fn greatest<A: HostArithmetic>(n: f64) -> f64 {
    let material = Material::from_argument(&format!("model = \"metallic-phong\", exponent = {n}"))
        .expect("an exponent in range");
    let subject = Subject::<A>::new(&material);
    Set::ALL
        .into_iter()
        .map(|set| subject.code_error(&set.pairs(n, 9.0, SAMPLES), 1.0).lsb_max)
        .fold(0.0, f64::max)
}

/// The section of `docs/accuracy.md`.
pub fn section() -> String {
    let mut text = String::from(
        "\n## `q15` between n = 1 and 2\n\n\
         There (1 − x)ⁿ meets 0 at α = 90° with a bend that has no bound, and the last cell of a table of \
         even cells shows it, in the dark: the bounds above are of the registry's exponents, 1, 1.5 and 2 \
         among them, and do not hold between. Greatest arithmetic error of metallic Phong at K = 1, in LSB, \
         with the knots that `q15` has and with twice their cells; computed anew by \
         `tests/tests/documents.rs`, which fails when a figure is out of date.\n\n\
         | n | 129 knots | 257 knots |\n| ---: | ---: | ---: |\n",
    );
    for n in EXPONENTS {
        let (few, many) = (greatest::<Q15<129>>(n), greatest::<Q15<257>>(n));
        let _ = writeln!(text, "| {n} | {few:.2} | {many:.2} |");
    }
    text
}
