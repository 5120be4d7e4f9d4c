//! How much of the stack has been used since the start.
//!
//! cortex-m-rt fills the stack with a fixed word before `main` runs (feature
//! `paint-stack`); whatever has been used no longer holds it.
#![allow(unsafe_code)]

use core::ptr::{addr_of, read_volatile};

use cortex_m_rt::STACK_PAINT_VALUE;

unsafe extern "C" {
    /// Lowest word that the stack may grow down to.
    static _stack_end: u32;
    /// Where the stack begins.
    static _stack_start: u32;
}

/// Bytes of RAM that the stack has for itself.
pub fn size() -> usize {
    addr_of!(_stack_start) as usize - addr_of!(_stack_end) as usize
}

/// Greatest number of bytes that the stack has held.
pub fn used() -> usize {
    let words = size() / size_of::<u32>();
    let bottom = addr_of!(_stack_end);
    let untouched = (0..words)
        // SAFETY: the words from `_stack_end` up to `_stack_start` are RAM that
        // the linker gave to the stack alone, and are only read.
        .take_while(|&word| unsafe { read_volatile(bottom.add(word)) } == STACK_PAINT_VALUE)
        .count();
    (words - untouched) * size_of::<u32>()
}
