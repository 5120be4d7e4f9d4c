//! A whole pixel: where it is on a sphere that is seen from afar, to the
//! display's own code.

use fixed::types::I2F14;
use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{ExposedPhong, MetallicPhong};
use microbrdf::geometry::{Direction, World};
use microbrdf::shade::{LINEAR_ONE, Palette565};
use microbrdf::{Rgb, constant};

#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};
use crate::ways::q15::number;

/// The light's direction, 14 fraction bits.
pub const LIGHT: [i16; 3] = [-6000, 8000, 12_978];
/// The light's colour on the metal, linear with 24 fraction bits.
pub const TINT: [u32; 3] = [LINEAR_ONE, LINEAR_ONE / 4 * 3, LINEAR_ONE / 3];

pub(crate) static PALETTE: Palette565 = Palette565::new(TINT);

type A = Q15;

/// A point of the picture plane in two halves of a word, 14 fraction bits of
/// the radius each, x in the lower; black beside the sphere.
#[inline(always)]
fn pixel(model: &ExposedPhong, point: u32) -> u32 {
    let direction = |[x, y, z]: [i16; 3]| {
        Direction::new(
            I2F14::from_bits(x),
            I2F14::from_bits(y),
            I2F14::from_bits(z),
        )
    };
    let half = |bits: u32| I2F14::from_bits(bits as u16 as i16);
    let Some(normal) = Direction::<A>::upon_sphere(half(point), half(point >> 16)) else {
        return 0;
    };
    let frame = World::new(normal, direction(LIGHT), direction([0, 0, 1 << 14]));
    u32::from(PALETTE.at_short(model.shade(&frame).r))
}

/// The third component of a sphere's normal alone, 14 fraction bits.
#[allow(unsafe_code)]
#[unsafe(export_name = "q15_sphere_normal")]
pub extern "C" fn normal(point: u32) -> u32 {
    let half = |bits: u32| I2F14::from_bits(bits as u16 as i16);
    Direction::<A>::upon_sphere(half(point), half(point >> 16))
        .map_or(0, |normal| normal.z.to_bits() as u32)
}

macro_rules! spheres {
    ($($function:ident $symbol:literal $model:ident $n:literal $fields:literal)+) => {
        $(
            static $model: ExposedPhong = constant!(ExposedPhong::new(
                constant!(MetallicPhong::<A>::new(number($n))),
                Rgb::grey(number(1.0)),
            ));

            #[doc = $symbol]
            #[allow(unsafe_code)]
            #[unsafe(export_name = $symbol)]
            pub extern "C" fn $function(point: u32) -> u32 {
                pixel(&$model, point)
            }
        )+

        /// What they are.
        #[cfg(not(target_os = "none"))]
        pub(crate) const KERNELS: &[Kernel] = &[$(Kernel {
            name: $symbol,
            arithmetic: "q15",
            variant: "core, gain in the table, 129 knots, palette",
            model: "sphere",
            fields: $fields,
            width: $n,
            exposure: "1",
            k: 1.0,
            call: Call::Number($function),
        }),+, Kernel {
            name: "q15_sphere_normal",
            arithmetic: "q15",
            variant: "core",
            model: "sphere normal",
            fields: "",
            width: 20.0,
            exposure: "1",
            k: 1.0,
            call: Call::Number(normal),
        }];
    };
}

spheres! {
    sphere_20 "q15_sphere_20" N_20 20.0 "exponent = 20"
    sphere_500 "q15_sphere_500" N_500 500.0 "exponent = 500"
    sphere_5000 "q15_sphere_5000" N_5000 5000.0 "exponent = 5000"
}
