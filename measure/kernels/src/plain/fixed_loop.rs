//! A `fixed` number of 16 fraction bits, multiplied n times.

use fixed::types::I16F16;

use super::exponents;
use crate::call::Vector;
#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};

#[inline(always)]
fn evaluate<const N: u32>(l: Vector<'_>, v: Vector<'_>) -> u32 {
    let [lx, ly, lz] = l.map(|bits| I16F16::from_bits(bits as i32));
    let [vx, vy, vz] = v.map(|bits| I16F16::from_bits(bits as i32));
    if lz <= I16F16::ZERO || vz < I16F16::ZERO {
        return 0;
    }
    let cosine = lz * vz - lx * vx - ly * vy;
    if cosine <= I16F16::ZERO {
        return 0;
    }
    let mut lobe = I16F16::ONE;
    for _ in 0..N {
        lobe *= cosine;
    }
    let light = if lz >= vz { lobe } else { lobe * (lz / vz) };
    (light.min(I16F16::ONE).to_bits() as u32) << 8
}

exponents! { "fixed_loop", "i16f16", "loop over a fixed number";
    n20: 20; n500: 500;
}
