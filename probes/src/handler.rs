//! The handler that can't be linked.

use core::panic::PanicInfo;

#[allow(unsafe_code)]
unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: never runs; where it is reachable, the program does not link.
    #[allow(unsafe_code)]
    unsafe {
        a_panic_is_reachable()
    }
}
