//! `f32` with libm's `powf`.

use super::exponents;
use crate::call::Vector;
#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};

#[inline(always)]
fn evaluate<const N: u32>(l: Vector<'_>, v: Vector<'_>) -> u32 {
    super::metallic_phong(l, v, 1.0, |cosine| libm::powf(cosine, N as f32))
}

exponents! { "powf_libm", "f32", "powf of libm";
    n20: 20; n500: 500; n5000: 5000;
}
