//! Prints what this host gives, a name and a number a line, for
//! `cargo xtask test` to compare between builds.

use microbrdf_checksum::CHECKSUMS;

fn main() {
    for (name, function) in CHECKSUMS {
        println!("{name} {}", function(0));
    }
}
