//! Lobes with a light's gain in their tables: light of 16 bits, in registers.

use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{
    DirectPhong, ExposedMetal, ExposedPatch, ExposedPhong, MetallicPhong, Patch,
};
use microbrdf::fixed::types::U32F32;
use microbrdf::geometry::{ShadingFrame, ShortWorld, World};
use microbrdf::{Rgb, constant};

#[cfg(not(target_arch = "arm"))]
use crate::call::Short;
#[cfg(target_arch = "arm")]
use crate::call::Three;
#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};
use crate::gold::GOLD;
use crate::models::lobe_peak;
use crate::ways::q15::{Vector, direction, number, radius};

const LOBE_20: MetallicPhong<Q15> = constant!(MetallicPhong::<Q15>::new(number(20.0)));
/// What tables without interpolation are made of.
const FINE_1: MetallicPhong<Q15<513>> = constant!(MetallicPhong::<Q15<513>>::new(number(1.0)));
const FINE_20: MetallicPhong<Q15<513>> = constant!(MetallicPhong::<Q15<513>>::new(number(20.0)));
const FINE_500: MetallicPhong<Q15<513>> = constant!(MetallicPhong::<Q15<513>>::new(number(500.0)));
const FINE_5000: MetallicPhong<Q15<513>> =
    constant!(MetallicPhong::<Q15<513>>::new(number(5000.0)));
const LOBE_500: MetallicPhong<Q15> = constant!(MetallicPhong::<Q15>::new(number(500.0)));
const DISC: Patch<Q15> = constant!(Patch::<Q15>::new(radius(0.3)));
/// 1/(πR²) of that.
const DISC_PEAK: f64 = core::f64::consts::FRAC_1_PI / 0.09;

const fn grey(k: f64) -> Rgb<U32F32> {
    Rgb::grey(number(k))
}

fn packed(light: Option<Rgb<u16>>) -> u64 {
    let Some(light) = light else { return 0 };
    u64::from(light.r) | u64::from(light.g) << 16 | u64::from(light.b) << 32
}

macro_rules! exposed {
    ($($way:ident $module:ident $symbol:literal: $type:ty = $model:expr,
       $name:literal $fields:literal about $width:literal, $exposure:literal $k:expr;)+) => {
        $(mod $module {
            use super::*;

            static MODEL: $type = constant!($model);

            shade! { $way $symbol }
        })+

        /// What they are.
        #[cfg(not(target_os = "none"))]
        pub(crate) const KERNELS: &[Kernel] = &[$(Kernel {
            name: $symbol,
            arithmetic: "q15",
            variant: variant!($way),
            model: $name,
            fields: $fields,
            width: $width,
            exposure: $exposure,
            k: $k,
            call: call!($way $module),
        }),+];
    };
}

macro_rules! shade {
    (frame $symbol:literal) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn shade(l: Vector<'_>, v: Vector<'_>) -> u64 {
            packed(MODEL.light(&ShadingFrame::new(direction(l), direction(v))))
        }
    };
    (grey $symbol:literal) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn shade(l: Vector<'_>, v: Vector<'_>) -> u32 {
            u32::from(
                MODEL
                    .shade(&ShadingFrame::new(direction(l), direction(v)))
                    .r,
            )
        }
    };
    (direct $symbol:literal) => {
        #[doc = $symbol]
        #[cfg(target_arch = "arm")]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn shade(Three { n, l, v }: Three) -> u64 {
            let [n, l, v] = [n, l, v].map(direction);
            packed(MODEL.light(&ShortWorld::<129>::new(n, l, v)))
        }

        /// As it is called on cores that get a struct behind a pointer.
        #[cfg(not(target_arch = "arm"))]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn shade(a: u32, b: u32, c: u32, d: u32, e: u32) -> u64 {
            let [n, l, v] = Short::of_words([a, b, c, d, e]).map(direction);
            packed(MODEL.light(&ShortWorld::<129>::new(n, l, v)))
        }
    };
    (direct_fine $symbol:literal) => {
        shade!(direct $symbol);
    };
    (world $symbol:literal) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn shade(n: Vector<'_>, l: Vector<'_>, v: Vector<'_>) -> u64 {
            packed(MODEL.light(&World::new(direction(n), direction(l), direction(v))))
        }
    };
}

#[cfg(not(target_os = "none"))]
macro_rules! call {
    (frame $module:ident) => {
        Call::ShortPacked($module::shade)
    };
    (grey $module:ident) => {
        Call::ShortSingle($module::shade)
    };
    (direct $module:ident) => {
        Call::ShortsPacked($module::shade)
    };
    (direct_fine $module:ident) => {
        Call::ShortsPacked($module::shade)
    };
    (world $module:ident) => {
        Call::ShortWorldPacked($module::shade)
    };
}

#[cfg(not(target_os = "none"))]
macro_rules! variant {
    (world) => {
        "world space, gain in the table, 129 knots"
    };
    (direct_fine) => {
        "world space, gain in the table, no interpolation, 8192 cells"
    };
    (direct) => {
        "world space, gain in the table, no interpolation, 4096 cells"
    };
    ($other:ident) => {
        "gain in the table, 129 knots"
    };
}

exposed! {
    frame gold_20_k1 "q15_exposed_gold_20_k1": ExposedMetal = ExposedMetal::new(LOBE_20, &GOLD, grey(1.0)),
        "metal" "metal = \"gold\", exponent = 20" about 20.0, "1" 1.0;
    frame gold_20_kc "q15_exposed_gold_20_kc": ExposedMetal = ExposedMetal::new(LOBE_20, &GOLD, grey(lobe_peak(20.0))),
        "metal" "metal = \"gold\", exponent = 20" about 20.0, "c" lobe_peak(20.0);
    frame gold_500_k1 "q15_exposed_gold_500_k1": ExposedMetal = ExposedMetal::new(LOBE_500, &GOLD, grey(1.0)),
        "metal" "metal = \"gold\", exponent = 500" about 500.0, "1" 1.0;
    frame gold_500_kc "q15_exposed_gold_500_kc": ExposedMetal = ExposedMetal::new(LOBE_500, &GOLD, grey(lobe_peak(500.0))),
        "metal" "metal = \"gold\", exponent = 500" about 500.0, "c" lobe_peak(500.0);
    grey patch_k1 "q15_exposed_patch_k1": ExposedPatch = ExposedPatch::new(DISC, grey(1.0)),
        "patch" "radius = 0.3" about 11.1, "1" 1.0;
    grey patch_kc "q15_exposed_patch_kc": ExposedPatch = ExposedPatch::new(DISC, grey(DISC_PEAK)),
        "patch" "radius = 0.3" about 11.1, "c" DISC_PEAK;
    world phong_20_k1 "q15_exposed_world_metallic_phong_20_k1": ExposedPhong = ExposedPhong::new(LOBE_20, grey(1.0)),
        "metallic-phong" "exponent = 20" about 20.0, "1" 1.0;
    world phong_20_kc "q15_exposed_world_metallic_phong_20_kc": ExposedPhong = ExposedPhong::new(LOBE_20, grey(lobe_peak(20.0))),
        "metallic-phong" "exponent = 20" about 20.0, "c" lobe_peak(20.0);
    direct_fine direct_1_k1 "q15_direct_world_metallic_phong_1_k1": DirectPhong<8192> = DirectPhong::new(&FINE_1, grey(1.0)),
        "metallic-phong" "exponent = 1" about 1.0, "1" 1.0;
    direct direct_20_k1 "q15_direct_world_metallic_phong_20_k1": DirectPhong = DirectPhong::new(&FINE_20, grey(1.0)),
        "metallic-phong" "exponent = 20" about 20.0, "1" 1.0;
    direct direct_20_kc "q15_direct_world_metallic_phong_20_kc": DirectPhong = DirectPhong::new(&FINE_20, grey(lobe_peak(20.0))),
        "metallic-phong" "exponent = 20" about 20.0, "c" lobe_peak(20.0);
    direct direct_500_kc "q15_direct_world_metallic_phong_500_kc": DirectPhong = DirectPhong::new(&FINE_500, grey(lobe_peak(500.0))),
        "metallic-phong" "exponent = 500" about 500.0, "c" lobe_peak(500.0);
    direct_fine direct_5000_k1 "q15_direct_world_metallic_phong_5000_k1": DirectPhong<8192> = DirectPhong::new(&FINE_5000, grey(1.0)),
        "metallic-phong" "exponent = 5000" about 5000.0, "1" 1.0;
    world gold_20_kc_world "q15_exposed_world_gold_20_kc": ExposedMetal = ExposedMetal::new(LOBE_20, &GOLD, grey(lobe_peak(20.0))),
        "metal" "metal = \"gold\", exponent = 20" about 20.0, "c" lobe_peak(20.0);
}
