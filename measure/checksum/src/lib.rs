//! One number for many of the core's results in an arithmetic: the same on a
//! host and on every core, as `cargo xtask test` sees by running these
//! functions in emulators. Which results they are, `microbrdf-bits` says.
#![cfg_attr(target_os = "none", no_std)]

use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf_bits::{Sampled, checksums};

/// Pairs of directions for each model.
const COUNT: usize = 100;

/// The models' checksums, folded into 32 bits.
#[inline(always)]
fn folded<A: Sampled>() -> u32 {
    let mut all = 0u64;
    checksums::<A>(COUNT, &mut |_, sum| all = all.rotate_left(7) ^ sum);
    (all ^ (all >> 32)) as u32
}

macro_rules! bits {
    ($($function:ident: $arithmetic:ty;)+) => {$(
        /// The checksum of every model in this arithmetic; the argument counts for nothing.
        #[allow(unsafe_code)]
        #[unsafe(export_name = concat!("bits_", stringify!($function)))]
        pub extern "C" fn $function(_: u32) -> u32 {
            folded::<$arithmetic>()
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
    f32: F32;
    micromath: Micromath;
    q31: Q31<128>;
    q15: Q15<65>;
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // An emulator that finds no result says so.
    loop {}
}
