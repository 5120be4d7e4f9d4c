//! Metals with a light's exposure in their curve.

use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{ExposedMetal, MetallicPhong};
use microbrdf::geometry::ShadingFrame;
use microbrdf::{Rgb, constant};

#[cfg(not(target_os = "none"))]
use crate::call::{Call, Kernel};
use crate::gold::GOLD;
use crate::models::lobe_peak;
use crate::ways::q15::{Vector, direction, number};

macro_rules! exposed {
    ($($module:ident $symbol:literal $n:literal $fields:literal $exposure:literal $k:expr;)+) => {
        $(mod $module {
            use super::*;

            const LOBE: MetallicPhong<Q15> = constant!(MetallicPhong::<Q15>::new(number($n)));
            static MODEL: ExposedMetal =
                constant!(ExposedMetal::new(LOBE, &GOLD, Rgb::grey(number($k))));

            #[doc = $symbol]
            #[allow(unsafe_code)]
            #[unsafe(export_name = $symbol)]
            pub extern "C" fn shade(l: Vector<'_>, v: Vector<'_>) -> u64 {
                let pair = ShadingFrame::new(direction(l), direction(v));
                let light = MODEL.shade(&pair);
                u64::from(light.r) | u64::from(light.g) << 16 | u64::from(light.b) << 32
            }
        })+

        /// What they are.
        #[cfg(not(target_os = "none"))]
        pub(crate) const KERNELS: &[Kernel] = &[$(Kernel {
            name: $symbol,
            arithmetic: "q15",
            variant: "core, 129 knots, exposed curve of 64 cells",
            model: "metal",
            fields: $fields,
            width: $n,
            exposure: $exposure,
            k: $k,
            call: Call::ShortPacked($module::shade),
        }),+];
    };
}

exposed! {
    gold_20_k1 "q15_exposed_gold_20_k1" 20.0 "metal = \"gold\", exponent = 20" "1" 1.0;
    gold_20_kc "q15_exposed_gold_20_kc" 20.0 "metal = \"gold\", exponent = 20" "c" lobe_peak(20.0);
    gold_500_k1 "q15_exposed_gold_500_k1" 500.0 "metal = \"gold\", exponent = 500" "1" 1.0;
    gold_500_kc "q15_exposed_gold_500_kc" 500.0 "metal = \"gold\", exponent = 500" "c" lobe_peak(500.0);
}
