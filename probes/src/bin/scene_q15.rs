//! A whole pixel in `q15`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use microbrdf::arithmetic::{Gain15, Q15};
    use microbrdf::fixed::types::I2F14;

    microbrdf_probes::every_pixel!(Q15<65>, I2F14, Gain15);
}
