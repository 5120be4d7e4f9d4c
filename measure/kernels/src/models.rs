//! The core's models, every one in every arithmetic, at K = 1 and K = c.

use microbrdf::arithmetic::{Arithmetic, Micromath, Q15, Q31};
use microbrdf::brdf::{
    Brdf, GeneralisedLambert, Lambert, Metal, MetallicPaint, MetallicPhong, PModel, Patch,
    PatchExponential, PatchMetal, PatchProfile, Phong, Plastic, PowerModel, RetroPhong,
};
use microbrdf::geometry::{ShadingFrame, World};
use microbrdf::{Rgb, constant};

#[cfg(not(target_os = "none"))]
use crate::call::Kernel;
use crate::call::Light;
use crate::glaze::GLAZE;
use crate::gold::GOLD;
use crate::moon;
use crate::profile::{self, PROFILE};

/// c_n = (n + 2)/2π (3.6).
pub(crate) const fn lobe_peak(n: f64) -> f64 {
    (n + 2.0) * core::f64::consts::FRAC_1_PI / 2.0
}

/// C(s) of e^(−s·m): 1/π times s²/2 over what the unit disc holds of the plane.
const PEAK_OF_SHARPNESS_4: f64 = 2.803_190_185_324_569;

/// The kernels of one arithmetic: a module of each material, with a function
/// for each exposure.
macro_rules! kernels {
    ($module:ident, $way:ident, $arithmetic:ty, $variant:literal;
     $($shape:ident $material:ident: $type:ty = $model:expr,
       $name:literal, $fields:literal, about $width:expr, c = $peak:expr;)+) => {
        pub(crate) mod $module {
            use super::*;
            use crate::ways::$way::{Vector, direction, gain, number, p, radius, share};

            type A = $arithmetic;

            /// Lobes that several materials share: built once.
            const LOBE_20: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(20.0)));
            const LOBE_500: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(500.0)));

            $(pub mod $material {
                use super::*;

                pub(super) const PEAK: f64 = $peak;
                static MODEL: $type = $model;

                kernel! { $shape k1, concat!(stringify!($module), "_", stringify!($material), "_k1"), 1.0 }
                kernel! { $shape kc, concat!(stringify!($module), "_", stringify!($material), "_kc"), PEAK }
            })+

            /// What they are.
            #[cfg(not(target_os = "none"))]
            pub(crate) const KERNELS: &[Kernel] = &[$(
                entry!($shape $module $way $material k1, "1", 1.0, $variant, $name, $fields, $width),
                entry!($shape $module $way $material kc, "c", $material::PEAK, $variant, $name, $fields, $width),
            )+];

            // Not every list of materials takes every kind of parameter.
            const _: () = {
                let _ = (number(1.0), p(0.5), radius(1.0), share(0.5), &LOBE_500);
            };
        }
    };
}

/// One exported function.
macro_rules! kernel {
    (grey $exposure:ident, $symbol:expr, $k:expr) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn $exposure(l: Vector<'_>, v: Vector<'_>) -> u32 {
            let pair = ShadingFrame::<A>::new(direction(l), direction(v));
            let gain = const { Rgb::grey(gain($k)) };
            A::linear(MODEL.shade(&gain, &pair)).to_raw()[0]
        }
    };
    (colour $exposure:ident, $symbol:expr, $k:expr) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn $exposure(l: Vector<'_>, v: Vector<'_>, light: &mut Light) {
            let pair = ShadingFrame::<A>::new(direction(l), direction(v));
            let gain = const { Rgb::grey(gain($k)) };
            *light = A::linear(MODEL.shade(&gain, &pair)).to_raw();
        }
    };
    (world $exposure:ident, $symbol:expr, $k:expr) => {
        #[doc = $symbol]
        #[allow(unsafe_code)]
        #[unsafe(export_name = $symbol)]
        pub extern "C" fn $exposure(
            n: Vector<'_>,
            l: Vector<'_>,
            v: Vector<'_>,
            light: &mut Light,
        ) {
            let frame = World::<A>::new(direction(n), direction(l), direction(v));
            let gain = const { Rgb::grey(gain($k)) };
            *light = A::linear(MODEL.shade(&gain, &frame)).to_raw();
        }
    };
}

/// What is known of one.
#[cfg(not(target_os = "none"))]
macro_rules! entry {
    (grey $($rest:tt)+) => { entry!(@ Grey "" $($rest)+) };
    (colour $($rest:tt)+) => { entry!(@ Colour "" $($rest)+) };
    (world $($rest:tt)+) => { entry!(@ World "world space, " $($rest)+) };
    (@ $call:ident $space:literal $module:ident $way:ident $material:ident $function:ident,
     $exposure:literal, $k:expr, $variant:literal, $name:literal, $fields:literal, $width:expr) => {
        Kernel {
            name: concat!(stringify!($module), "_", stringify!($material), "_", stringify!($function)),
            arithmetic: stringify!($way),
            variant: concat!($space, $variant),
            model: $name,
            fields: $fields,
            width: $width,
            exposure: $exposure,
            k: $k,
            call: crate::ways::$way::$call($material::$function),
        }
    };
}

/// Every model.
macro_rules! all {
    ($module:ident, $way:ident, $arithmetic:ty, $variant:literal) => {
        kernels! { $module, $way, $arithmetic, $variant;
            grey lambert: Lambert<A> = constant!(Lambert::<A>::new(Rgb::grey(share(0.8)))),
                "lambert", "albedo = 0.8", about 0.5, c = core::f64::consts::FRAC_1_PI;
            grey phong_20: Phong<A> = constant!(Phong::<A>::new(number(20.0))),
                "phong", "exponent = 20", about 20.0, c = lobe_peak(20.0);
            grey p_model_20: PModel<A> = constant!(PModel::<A>::with_foreshortening(
                    number(20.0), constant!(PowerModel::<A>::new(p(0.5))))),
                "phong", "exponent = 20, p = 0.5", about 20.0, c = lobe_peak(20.0);
            grey metallic_phong_1: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(1.0))),
                "metallic-phong", "exponent = 1", about 1.0, c = lobe_peak(1.0);
            grey metallic_phong_20: MetallicPhong<A> = LOBE_20,
                "metallic-phong", "exponent = 20", about 20.0, c = lobe_peak(20.0);
            grey metallic_phong_500: MetallicPhong<A> = LOBE_500,
                "metallic-phong", "exponent = 500", about 500.0, c = lobe_peak(500.0);
            grey metallic_phong_5000: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(5000.0))),
                "metallic-phong", "exponent = 5000", about 5000.0, c = lobe_peak(5000.0);
            grey retro_phong_20: RetroPhong<A> = constant!(RetroPhong::<A>::new(number(20.0))),
                "retro-phong", "exponent = 20", about 20.0, c = lobe_peak(20.0);
            grey patch: Patch<A> = constant!(Patch::<A>::new(radius(0.3))),
                "patch", "radius = 0.3", about 11.1, c = core::f64::consts::FRAC_1_PI / 0.09;
            grey patch_exponential: PatchExponential<A> = constant!(PatchExponential::<A>::new(number(4.0))),
                "patch-exponential", "sharpness = 4", about 2.0, c = PEAK_OF_SHARPNESS_4;
            grey patch_profile: PatchProfile<A> = PatchProfile::new(PROFILE, number(profile::PEAK)),
                "profile", "points = [[0, 1], [0.25, 0.375], [1, 0]]", about 8.0, c = profile::PEAK;
            colour gold_20: Metal<A> = Metal::new(LOBE_20, GOLD),
                "metal", "metal = \"gold\", exponent = 20", about 20.0, c = lobe_peak(20.0);
            colour gold_500: Metal<A> = Metal::new(LOBE_500, GOLD),
                "metal", "metal = \"gold\", exponent = 500", about 500.0, c = lobe_peak(500.0);
            colour plastic_20: Plastic<A> = constant!(Plastic::<A>::new(
                    Rgb { r: share(0.6), g: share(0.2), b: share(0.1) }, Rgb::grey(share(0.3)), number(20.0))),
                "plastic", "albedo = [0.6, 0.2, 0.1], specular = 0.3, exponent = 20", about 20.0,
                c = 0.6 * core::f64::consts::FRAC_1_PI + 0.3 * lobe_peak(20.0);
            colour ceramic_20: Plastic<A, Metal<A>> = constant!(Plastic::<A>::new(
                    Rgb { r: share(0.6), g: share(0.2), b: share(0.1) }, Rgb::grey(share(0.3)), number(20.0)))
                    .with_fresnel(GLAZE),
                "plastic", "albedo = [0.6, 0.2, 0.1], specular = 0.3, exponent = 20, index = 1.5", about 20.0,
                c = 0.6 * core::f64::consts::FRAC_1_PI + 0.3 * lobe_peak(20.0);
            colour generalised_lambert: GeneralisedLambert<A> = GeneralisedLambert::new(
                    constant!(Lambert::<A>::new(Rgb { r: share(0.6), g: share(0.2), b: share(0.1) })),
                    moon::PROFILE, number(moon::PEAK)),
                "generalised-lambert", "albedo = [0.6, 0.2, 0.1], smoothness = 1", about 0.5,
                c = moon::PEAK;
            colour patch_metal: PatchMetal<PatchExponential<A>> = PatchMetal::new(
                    constant!(PatchExponential::<A>::new(number(4.0))), GOLD),
                "patch-metal", "metal = \"gold\", sharpness = 4", about 2.0, c = PEAK_OF_SHARPNESS_4;
            colour metallic_paint: MetallicPaint<A> = MetallicPaint::new(
                    constant!(PatchExponential::<A>::new(number(4.0))), GOLD),
                "metallic-paint", "metal = \"gold\", sharpness = 4", about 2.0, c = PEAK_OF_SHARPNESS_4;
            world world_metallic_phong_20: MetallicPhong<A> = LOBE_20,
                "metallic-phong", "exponent = 20", about 20.0, c = lobe_peak(20.0);
            world world_gold_20: Metal<A> = Metal::new(LOBE_20, GOLD),
                "metal", "metal = \"gold\", exponent = 20", about 20.0, c = lobe_peak(20.0);
        }
    };
}

/// What shows a table's size.
macro_rules! sized {
    ($module:ident, $way:ident, $arithmetic:ty, $variant:literal) => {
        kernels! { $module, $way, $arithmetic, $variant;
            grey metallic_phong_1: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(1.0))),
                "metallic-phong", "exponent = 1", about 1.0, c = lobe_peak(1.0);
            grey metallic_phong_20: MetallicPhong<A> = LOBE_20,
                "metallic-phong", "exponent = 20", about 20.0, c = lobe_peak(20.0);
            grey metallic_phong_500: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(500.0))),
                "metallic-phong", "exponent = 500", about 500.0, c = lobe_peak(500.0);
            grey metallic_phong_5000: MetallicPhong<A> = constant!(MetallicPhong::<A>::new(number(5000.0))),
                "metallic-phong", "exponent = 5000", about 5000.0, c = lobe_peak(5000.0);
            grey patch_exponential: PatchExponential<A> = constant!(PatchExponential::<A>::new(number(4.0))),
                "patch-exponential", "sharpness = 4", about 2.0, c = PEAK_OF_SHARPNESS_4;
            colour gold_20: Metal<A> = Metal::new(LOBE_20, GOLD),
                "metal", "metal = \"gold\", exponent = 20", about 20.0, c = lobe_peak(20.0);
        }
    };
}

all!(f32, f32, microbrdf::arithmetic::F32, "core");
all!(micromath, micromath, Micromath, "core");
all!(q31, q31, Q31, "core, 1024 cells");
sized!(q31_256, q31, Q31<256>, "core, 256 cells");
sized!(q31_128, q31, Q31<128>, "core, 128 cells");
sized!(q31_64, q31, Q31<64>, "core, 64 cells");

all!(q15, q15, Q15, "core, 129 knots");
sized!(q15_257, q15, Q15<257>, "core, 257 knots");
sized!(q15_65, q15, Q15<65>, "core, 65 knots");

/// All of them.
#[cfg(not(target_os = "none"))]
pub(crate) const KERNELS: &[&[Kernel]] = &[
    f32::KERNELS,
    micromath::KERNELS,
    q31::KERNELS,
    q31_256::KERNELS,
    q31_128::KERNELS,
    q31_64::KERNELS,
    q15::KERNELS,
    q15_257::KERNELS,
    q15_65::KERNELS,
];
