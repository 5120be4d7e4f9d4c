//! A probe with a panic: it must not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    // Brings the handler.
    use microbrdf_probes as _;

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let entries = black_box([1, 2, 3]);
        black_box(entries[black_box(3)]);
        loop {}
    }
}
