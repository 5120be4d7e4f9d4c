//! Single steps: dot products, and the encoding of one channel.

use microbrdf::arithmetic::{Arithmetic, Q15};
use microbrdf::geometry::{Geometry, ShortWorld, World};
use microbrdf::shade::{Linear, grey16, grey16_nearest, srgb8, srgb8_direct, srgb8_quick};

#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};
use crate::call::{Light, Short};
use crate::sphere::PALETTE;

/// Linear light with 24 fraction bits to an 8-bit sRGB code.
#[allow(unsafe_code)]
#[unsafe(export_name = "srgb8")]
pub extern "C" fn srgb(linear: u32) -> u32 {
    u32::from(srgb8(linear))
}

/// The same in one look-up.
#[allow(unsafe_code)]
#[unsafe(export_name = "srgb8_quick")]
pub extern "C" fn srgb_quick(linear: u32) -> u32 {
    u32::from(srgb8_quick(linear))
}

/// Light of 16 bits in one look-up without a decision.
#[allow(unsafe_code)]
#[unsafe(export_name = "srgb8_direct")]
pub extern "C" fn srgb_direct(light: u16) -> u32 {
    u32::from(srgb8_direct(light))
}

/// The same for the three channels of a pixel; red in the lowest byte.
#[allow(unsafe_code)]
#[unsafe(export_name = "srgb8_direct_pixel")]
pub extern "C" fn srgb_direct_pixel(r: u16, g: u16, b: u16) -> u32 {
    let [r, g, b] = [r, g, b].map(|light| u32::from(srgb8_direct(light)));
    r | g << 8 | b << 16
}

/// What a function costs that gives back what it is given.
#[allow(unsafe_code)]
#[unsafe(export_name = "nothing")]
pub extern "C" fn nothing(number: u32) -> u32 {
    number
}

/// A grey pixel to RGB565.
#[allow(unsafe_code)]
#[unsafe(export_name = "rgb565")]
pub extern "C" fn packed(linear: u32) -> u32 {
    u32::from(Linear::from_raw(linear, linear, linear).rgb565())
}

/// The same dithered, at a place that the light's lowest bits stand for.
#[allow(unsafe_code)]
#[unsafe(export_name = "rgb565_dithered")]
pub extern "C" fn packed_dithered(linear: u32) -> u32 {
    let (x, y) = place(linear);
    u32::from(Linear::from_raw(linear, linear, linear).rgb565_dithered(x, y))
}

/// A luminance to one of 16 greys.
#[allow(unsafe_code)]
#[unsafe(export_name = "grey16_nearest")]
pub extern "C" fn grey(linear: u32) -> u32 {
    u32::from(grey16_nearest(linear))
}

/// The same dithered.
#[allow(unsafe_code)]
#[unsafe(export_name = "grey16")]
pub extern "C" fn grey_dithered(linear: u32) -> u32 {
    let (x, y) = place(linear);
    u32::from(grey16(linear, x, y))
}

/// Light of 16 bits to a code of RGB565, of one tint.
#[allow(unsafe_code)]
#[unsafe(export_name = "palette")]
pub extern "C" fn palette(light: u16) -> u32 {
    u32::from(PALETTE.at_short(light))
}

/// 1 − R·V of N, L and V, without anything that is made of it.
#[allow(unsafe_code)]
#[unsafe(export_name = "q15_world_versine")]
pub extern "C" fn versine(n: Short, l: Short, v: Short) -> u64 {
    let [n, l, v] = [n, l, v].map(crate::ways::q15::direction);
    u64::from(World::<Q15>::new(n, l, v).versine())
}

/// The same by sums of products.
#[allow(unsafe_code)]
#[unsafe(export_name = "q15_short_world_versine")]
pub extern "C" fn short_versine(n: Short, l: Short, v: Short) -> u64 {
    let [n, l, v] = [n, l, v].map(crate::ways::q15::direction);
    u64::from(ShortWorld::<129>::new(n, l, v).versine())
}

fn place(linear: u32) -> (usize, usize) {
    ((linear & 3) as usize, ((linear >> 2) & 3) as usize)
}

/// N·L, N·V and L·V.
macro_rules! dots {
    ($way:ident, $arithmetic:ty) => {
        pub mod $way {
            use super::*;
            use crate::ways::$way::{Vector, bits, direction};

            type A = $arithmetic;

            /// N·L, N·V and L·V, as their bits.
            #[allow(unsafe_code)]
            #[unsafe(export_name = concat!(stringify!($way), "_dots"))]
            pub extern "C" fn dots(n: Vector<'_>, l: Vector<'_>, v: Vector<'_>, out: &mut Light) {
                let (n, l, v) = (direction(n), direction(l), direction(v));
                *out = [A::dot(&n, &l), A::dot(&n, &v), A::dot(&l, &v)].map(bits);
            }
        }
    };
}

dots!(f32, microbrdf::arithmetic::F32);
dots!(q31, microbrdf::arithmetic::Q31);
dots!(q15, microbrdf::arithmetic::Q15);

/// What they are.
#[cfg(not(target_os = "none"))]
pub(crate) const KERNELS: &[Kernel] = &[
    step(
        "srgb8",
        "integer",
        "core, exact",
        "srgb8",
        Call::Number(srgb),
    ),
    step(
        "srgb8_quick",
        "integer",
        "core, one look-up",
        "srgb8",
        Call::Number(srgb_quick),
    ),
    step(
        "srgb8_direct",
        "integer",
        "core, of 16 bits, one look-up",
        "srgb8",
        Call::Half(srgb_direct),
    ),
    step(
        "srgb8_direct_pixel",
        "integer",
        "core, of 16 bits, a pixel's three at once",
        "srgb8",
        Call::Halves(srgb_direct_pixel),
    ),
    step(
        "nothing",
        "integer",
        "a call and its frame alone",
        "nothing",
        Call::Number(nothing),
    ),
    step("rgb565", "integer", "core", "rgb565", Call::Number(packed)),
    step(
        "rgb565_dithered",
        "integer",
        "core, dithered",
        "rgb565",
        Call::Number(packed_dithered),
    ),
    step(
        "grey16_nearest",
        "integer",
        "core",
        "grey16",
        Call::Number(grey),
    ),
    step(
        "grey16",
        "integer",
        "core, dithered",
        "grey16",
        Call::Number(grey_dithered),
    ),
    step("palette", "integer", "core", "palette", Call::Half(palette)),
    step(
        "q15_world_versine",
        "q15",
        "core",
        "versine",
        Call::ShortWorldPacked(versine),
    ),
    step(
        "q15_short_world_versine",
        "q15",
        "core, by sums of products",
        "versine",
        Call::ShortWorldPacked(short_versine),
    ),
    step("f32_dots", "f32", "core", DOTS, Call::World(f32::dots)),
    step("q31_dots", "q31", "core", DOTS, Call::World(q31::dots)),
    step("q15_dots", "q15", "core", DOTS, Call::ShortWorld(q15::dots)),
];

#[cfg(not(target_os = "none"))]
const DOTS: &str = "three dot products";

#[cfg(not(target_os = "none"))]
const fn step(
    name: &'static str,
    arithmetic: &'static str,
    variant: &'static str,
    model: &'static str,
    call: Call,
) -> Kernel {
    Kernel {
        name,
        arithmetic,
        variant,
        model,
        fields: "",
        width: 1.0,
        exposure: "1",
        k: 1.0,
        call,
    }
}
