//! A tile of a sphere that is seen from afar, row after row, straight to the
//! display's codes.

use fixed::types::{I2F30, U32F32};
use microbrdf::arithmetic::Q31;
use microbrdf::geometry::Direction;
use microbrdf::shade::{LINEAR_ONE, LitSphere, LobeColours};
use microbrdf::{Rgb, constant};

#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};
use crate::models::lobe_peak;
use crate::sphere::{LIGHT, TINT};
use crate::ways::q15::number;

/// Distance of two pixels, 30 fraction bits of the radius: so near that all of
/// a tile are in a lobe whose middle one is, but at its end.
pub const STEP: i32 = 1 << 17;
/// Pixels of a tile's row.
pub const WIDE: usize = 64;
/// Rows of a tile.
pub const HIGH: usize = 16;

/// A tile: codes of RGB565, row after row.
pub type Tile = [[u16; WIDE]; HIGH];

/// K of each channel.
const fn gain(k: f64) -> Rgb<U32F32> {
    Rgb {
        r: number(k * TINT[0] as f64 / LINEAR_ONE as f64),
        g: number(k * TINT[1] as f64 / LINEAR_ONE as f64),
        b: number(k * TINT[2] as f64 / LINEAR_ONE as f64),
    }
}

/// A light 140° from the viewer, 14 fraction bits.
const BEHIND: [i16; 3] = [-6319, 8425, -12_551];

/// A light's direction, from 14 fraction bits.
const fn direction(light: [i16; 3]) -> Direction<Q31> {
    Direction {
        x: I2F30::from_bits((light[0] as i32) << 16),
        y: I2F30::from_bits((light[1] as i32) << 16),
        z: I2F30::from_bits((light[2] as i32) << 16),
    }
}

/// What a light that moves costs a picture: its tables made anew, and one
/// pixel, the sphere's middle. L in two halves of a word, 14 fraction bits.
#[allow(unsafe_code)]
#[unsafe(export_name = "q15_lit_sphere")]
pub extern "C" fn moved(light: u32) -> u32 {
    static COLOURS: LobeColours = constant!(LobeColours::new(number(20.0), gain(lobe_peak(20.0))));
    let half = |bits: u32| I2F30::from_bits(i32::from(bits as u16 as i16) << 16);
    let l = Direction::new(half(light), half(light >> 16), I2F30::ONE / 2);
    let lit = LitSphere::<256>::new(&COLOURS, l);
    let mut pixel = [0];
    lit.rows(&COLOURS, [I2F30::ZERO; 2], [I2F30::ZERO; 2])
        .shade(&mut pixel);
    u32::from(pixel[0])
}

macro_rules! colours {
    (0.0, $k:expr) => {
        LobeColours::flat(gain($k))
    };
    ($n:tt, $k:expr) => {
        constant!(LobeColours::new(number($n), gain($k)))
    };
}

macro_rules! rows {
    ($($module:ident $symbol:literal $n:tt $k:expr, $exposure:literal $fields:literal
        $colours:literal $steps:literal $light:ident)+) => {
        $(mod $module {
            use super::*;

            static COLOURS: LobeColours<$colours, { $n == 0.0 }> = colours!($n, $k);
            static LIT: LitSphere<$steps> = LitSphere::new(&COLOURS, direction($light));

            #[doc = $symbol]
            #[allow(unsafe_code)]
            #[unsafe(export_name = $symbol)]
            pub extern "C" fn row(middle: u32, pixels: &mut Tile) {
                let half = |bits: u32| i32::from(bits as u16 as i16) << 16;
                let x = half(middle) - STEP * (WIDE / 2) as i32;
                let y = half(middle >> 16) + STEP * (HIGH / 2) as i32;
                let mut rows = LIT.rows(
                    &COLOURS,
                    [x, y].map(I2F30::from_bits),
                    [STEP, -STEP].map(I2F30::from_bits),
                );
                for row in pixels {
                    rows.shade(row);
                }
            }
        })+

        /// What they are.
        #[cfg(not(target_os = "none"))]
        pub(crate) const KERNELS: &[Kernel] = &[Kernel {
            name: "q15_lit_sphere",
            arithmetic: "q15",
            variant: "core, 256 steps",
            model: "sphere light",
            fields: "",
            width: 20.0,
            exposure: "1",
            k: 1.0,
            call: Call::Number(moved),
        }, $(Kernel {
            name: $symbol,
            arithmetic: "q15",
            variant: concat!("core, rows, ", $colours, " colours, ", $steps, " steps"),
            model: "sphere",
            fields: $fields,
            width: $n,
            exposure: $exposure,
            k: $k,
            call: Call::Rows($module::row, $light),
        }),+];
    };
}

rows! {
    row_0_k1 "q15_sphere_row_0" 0.0 1.0, "1" "exponent = 0" 1024 2048 LIGHT
    row_1_k1 "q15_sphere_row_1" 1.0 1.0, "1" "exponent = 1" 1024 2048 LIGHT
    row_20_k1 "q15_sphere_row_20" 20.0 1.0, "1" "exponent = 20" 512 512 LIGHT
    row_20_behind "q15_sphere_row_20_behind" 20.0 1.0, "1"
        "exponent = 20, light 140° from the viewer" 512 512 BEHIND
    row_20_kc "q15_sphere_row_20_kc" 20.0 lobe_peak(20.0), "c" "exponent = 20" 512 512 LIGHT
    row_500_k1 "q15_sphere_row_500" 500.0 1.0, "1" "exponent = 500" 512 512 LIGHT
    row_500_kc "q15_sphere_row_500_kc" 500.0 lobe_peak(500.0), "c" "exponent = 500" 512 512 LIGHT
    row_5000_k1 "q15_sphere_row_5000" 5000.0 1.0, "1" "exponent = 5000" 512 512 LIGHT
}
