//! What one would write without this project's core: metallic Phong straight
//! from its formula, cosⁿα of R·V = LzVz − LxVx − LyVy, as a competent author
//! would, with the same ends as the core's kernels: clamped, 24 fraction bits.

mod fixed_loop;
mod powf_libm;
mod powf_micromath;
mod squaring;

#[cfg(not(target_os = "none"))]
use crate::call::Kernel;
use crate::call::Vector;

/// 1.0 with 24 fraction bits.
const LINEAR_ONE: f32 = (1 << 24) as f32;

/// Metallic Phong's share of its peak in single precision, for a way to raise
/// the lobe's cosine to its power.
#[inline(always)]
fn metallic_phong(l: Vector<'_>, v: Vector<'_>, k: f32, power: impl Fn(f32) -> f32) -> u32 {
    let [lx, ly, lz] = l.map(f32::from_bits);
    let [vx, vy, vz] = v.map(f32::from_bits);
    if lz <= 0.0 || vz < 0.0 {
        return 0;
    }
    let cosine = lz * vz - lx * vx - ly * vy;
    if cosine <= 0.0 {
        return 0;
    }
    let lobe = power(if cosine < 1.0 { cosine } else { 1.0 });
    let light = if lz >= vz {
        k * lobe
    } else {
        k * lobe * (lz / vz)
    };
    (if light < 1.0 { light } else { 1.0 } * LINEAR_ONE + 0.5) as u32
}

/// Functions over a few exponents, all K = 1, and what is known of them.
macro_rules! exponents {
    ($symbol:literal, $arithmetic:literal, $variant:literal; $($function:ident: $n:literal;)+) => {
        $(
            #[doc = concat!("n = ", $n)]
            #[allow(unsafe_code)]
            #[unsafe(export_name = concat!($symbol, "_", $n))]
            pub extern "C" fn $function(l: Vector<'_>, v: Vector<'_>) -> u32 {
                evaluate::<$n>(l, v)
            }
        )+

        /// What they are.
        #[cfg(not(target_os = "none"))]
        pub(crate) const KERNELS: &[Kernel] = &[$(Kernel {
            name: concat!($symbol, "_", $n),
            arithmetic: $arithmetic,
            variant: $variant,
            model: "metallic-phong",
            fields: concat!("exponent = ", $n),
            width: $n as f64,
            exposure: "1",
            k: 1.0,
            call: Call::Grey($function),
        }),+];
    };
}
use exponents;

/// All of them.
#[cfg(not(target_os = "none"))]
pub(crate) const KERNELS: &[&[Kernel]] = &[
    powf_libm::KERNELS,
    powf_micromath::KERNELS,
    squaring::KERNELS,
    fixed_loop::KERNELS,
];
