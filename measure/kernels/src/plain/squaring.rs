//! `f32`, whole exponents by squaring and multiplying.

use super::exponents;
use crate::call::Vector;
#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};

#[inline(always)]
fn evaluate<const N: u32>(l: Vector<'_>, v: Vector<'_>) -> u32 {
    super::metallic_phong(l, v, 1.0, |cosine| {
        let (mut base, mut n, mut power) = (cosine, N, 1.0);
        while n > 1 {
            if n % 2 == 1 {
                power *= base;
            }
            base *= base;
            n /= 2;
        }
        power * base
    })
}

exponents! { "squaring", "f32", "squaring";
    n20: 20; n500: 500; n5000: 5000;
}
