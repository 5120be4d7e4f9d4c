//! `f32` with micromath's `powf`, which is an approximation.

use super::exponents;
use crate::call::Vector;
#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};

#[inline(always)]
fn evaluate<const N: u32>(l: Vector<'_>, v: Vector<'_>) -> u32 {
    // micromath's own type: with std linked, a method of f32 would be std's.
    super::metallic_phong(l, v, 1.0, |cosine| {
        micromath::F32(cosine).powf(micromath::F32(N as f32)).0
    })
}

exponents! { "powf_micromath", "f32", "powf of micromath";
    n20: 20; n500: 500; n5000: 5000;
}
