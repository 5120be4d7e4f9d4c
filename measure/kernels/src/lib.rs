//! What `cargo xtask measure` measures: kernels, each an exported function
//! that a linker can take alone and an emulator can call.
//!
//! A kernel is one evaluation as a user's shading loop would ask for it: the
//! directions to light and viewer go in as the arithmetic holds them, the
//! material and the gain are constants in flash, and the exposed linear light
//! out = clamp(K·ρ, 0, 1) comes out with 24 fraction bits, which every
//! encoding of a display starts from. Ways that one would take without this
//! project's core stand beside them ([`plain`]), with the same ends.
//!
//! On a host the same functions are called through [`kernels`], so that what
//! an emulated core gives can be compared bit by bit.
#![cfg_attr(target_os = "none", no_std)]

mod call;
mod exposed;
mod glaze;
mod gold;
mod models;
mod moon;
pub mod plain;
pub mod profile;
pub mod sphere;
pub mod sphere_row;
mod steps;
pub mod ways;

#[cfg(not(target_os = "none"))]
pub use call::{Call, Input, Kernel, Run};
#[cfg(not(target_os = "none"))]
pub use registry::kernels;

#[cfg(not(target_os = "none"))]
mod registry {
    use crate::call::Kernel;
    use crate::{exposed, models, plain, sphere, sphere_row, steps};

    /// Every kernel.
    pub fn kernels() -> impl Iterator<Item = &'static Kernel> {
        [
            models::KERNELS,
            plain::KERNELS,
            &[
                exposed::KERNELS,
                steps::KERNELS,
                sphere::KERNELS,
                sphere_row::KERNELS,
            ],
        ]
        .into_iter()
        .flatten()
        .copied()
        .flatten()
    }
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
