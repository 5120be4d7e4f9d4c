//! One number for many of the core's results in an arithmetic: the same on a
//! host and on every core, as `cargo xtask test` sees by running these
//! functions in emulators. Which results they are, `microbrdf-bits` says.
#![cfg_attr(target_os = "none", no_std)]

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf_bits::{checksums, exposed_checksums, highlight_checksums};

/// Pairs of directions for each model.
const COUNT: usize = 100;

/// Pairs of directions for each model with a light's gain in its table.
const EXPOSED_COUNT: usize = 12;

/// Lights on a sphere, for each of its lobes.
const LIGHTS: usize = 1;

/// Checksums, folded into 32 bits.
#[inline(always)]
fn folded(sums: impl FnOnce(&mut dyn FnMut(&'static str, u64))) -> u32 {
    let mut all = 0u64;
    sums(&mut |_, sum| all = all.rotate_left(7) ^ sum);
    (all ^ (all >> 32)) as u32
}

macro_rules! bits {
    ($($function:ident: $sums:expr;)+) => {$(
        /// The checksum of these models; the argument counts for nothing.
        #[allow(unsafe_code)]
        #[unsafe(export_name = concat!("bits_", stringify!($function)))]
        pub extern "C" fn $function(_: u32) -> u32 {
            folded($sums)
        }
    )+

        /// Their symbols, with the functions.
        #[cfg(not(target_os = "none"))]
        pub const CHECKSUMS: &[(&str, extern "C" fn(u32) -> u32)] = &[
            $((concat!("bits_", stringify!($function)), $function)),+
        ];
    };
}

// Tables are built on the core, on a stack of a few KiB.
bits! {
    f32: |sink| checksums::<F32>(COUNT, sink);
    micromath: |sink| checksums::<Micromath>(COUNT, sink);
    q31: |sink| checksums::<Q31<128>>(COUNT, sink);
    q15: |sink| checksums::<Q15<65>>(COUNT, sink);
    exposed: |sink| exposed_checksums(EXPOSED_COUNT, sink);
    highlight: |sink| highlight_checksums(LIGHTS, sink);
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // An emulator that finds no result says so.
    loop {}
}
