//! The command `microbrdf`.

fn main() {}
