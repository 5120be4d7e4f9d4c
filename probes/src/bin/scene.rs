//! A whole pixel in `q31`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use microbrdf::arithmetic::{Gain31, Q31};
    use microbrdf::fixed::types::I2F30;

    microbrdf_probes::every_pixel!(Q31<64>, I2F30, Gain31);
}
