//! What tests need of an arithmetic, and the one list of those tested.

use fixed::types::{U32F32, U64F64};
use microbrdf::arithmetic::{Approximate, Float, Gain15, Gain31, Libm, Math, Q15, Q31};
use microbrdf::geometry::Direction;
use microbrdf_bits::Raw;
use microbrdf_reference as reference;
use microbrdf_scene::HostArithmetic;

/// Makes a `#[test]` in every arithmetic of each function that is generic
/// over it.
///
/// A new arithmetic is one line here.
#[macro_export]
macro_rules! in_every_arithmetic {
    ($($test:ident),+ $(,)?) => {
        $crate::in_arithmetic!(f32, microbrdf::arithmetic::F32, $($test),+);
        $crate::in_arithmetic!(micromath, microbrdf::arithmetic::Micromath, $($test),+);
        $crate::in_arithmetic!(q31, microbrdf::arithmetic::Q31, $($test),+);
        $crate::in_arithmetic!(q15, microbrdf::arithmetic::Q15, $($test),+);
    };
}

/// The tests of one arithmetic.
#[macro_export]
macro_rules! in_arithmetic {
    ($name:ident, $arithmetic:ty, $($test:ident),+) => {
        mod $name {
            $(
                #[test]
                fn $test() {
                    super::$test::<$arithmetic>();
                }
            )+
        }
    };
}

/// An arithmetic with what tests expect of it.
pub trait Tested: HostArithmetic<Unit: Raw, Value: Raw, Radiance: Raw, Scale: Raw> {
    /// Whether it takes exponents between 0 and 1.
    const FRACTIONAL_EXPONENTS: bool;
    /// Greatest error of a component of a unit vector by rounding.
    const COMPONENT_ERROR: f64;
    /// Greatest error of a stored lobe or profile, relative to its value.
    const LOBE_ERROR: f64;
    /// One step of a share near 1.
    const UNIT_STEP: f64;
    /// What is added to it, of a lobe's peak.
    const LOBE_FLOOR: f64;
    /// What is added to the error of a ratio of two cosines, `core`'s
    /// `table::reciprocal::tests`.
    const RATIO_FLOOR: f64;
    /// Greatest error of a product of two shares, relative to the first.
    const PRODUCT_ERROR: f64;
    /// Greatest error of a gain, relative to it.
    const GAIN_ERROR: f64;
    /// What exposure adds to it, of the gain.
    const EXPOSURE_STEP: f64;
    /// Greatest error of a code at K = 1: the widest such row of the table of
    /// tolerances.
    const CODE_ERROR: f64;
    /// Share of a lobe's shift by a rounded direction that the mean over a
    /// lobe's directions leaves.
    const DIRECTION_NOISE: f64;
    /// One step of a peak relative to it, or absolute, the greater counts.
    const SCALE_STEP: [f64; 2];

    /// A gain of 0.
    fn no_gain() -> Self::Gain;
    /// The peak's value.
    fn scale_value(scale: Self::Scale) -> f64;
    /// The BRDF's value.
    fn value_value(value: Self::Value) -> f64;
    /// The radiance's value.
    fn radiance_value(radiance: Self::Radiance) -> f64;
    /// Whether a BRDF value is the greatest that its type holds.
    fn is_greatest(value: Self::Value) -> bool;
    /// Whether a radiance is no greater than a peak, compared in their bits.
    fn at_most(radiance: Self::Radiance, peak: Self::Scale) -> bool;
}

/// Greatest errors of what an arithmetic takes from a library.
pub trait MathErrors {
    /// Of a lobe or profile, relative to its value.
    const LOBE_ERROR: f64;
    /// What is added to it, of the peak.
    const LOBE_FLOOR: f64;
    /// Of a code at K = 1.
    const CODE_ERROR: f64;
    /// Of a power of a cosine.
    const POWER_ERROR: f64;
}

impl MathErrors for Libm {
    const LOBE_ERROR: f64 = 4e-6;
    const LOBE_FLOOR: f64 = 0.0;
    const CODE_ERROR: f64 = 0.54;
    const POWER_ERROR: f64 = 1e-6;
}

impl MathErrors for Approximate {
    // Of `Micromath`'s documentation; held by `frames.rs` and `energy.rs`.
    const LOBE_ERROR: f64 = 4e-3;
    const LOBE_FLOOR: f64 = 2e-5;
    const CODE_ERROR: f64 = 0.71;
    const POWER_ERROR: f64 = 2.5e-3;
}

impl<M: Math + MathErrors> Tested for Float<M>
where
    Self: HostArithmetic<Unit = f32, Value = f32, Radiance = f32, Scale = f32, Gain = f32>,
{
    const FRACTIONAL_EXPONENTS: bool = true;
    // Half of the spacing in [1/2, 1].
    const COMPONENT_ERROR: f64 = 1.0 / (1u64 << 25) as f64;
    const LOBE_ERROR: f64 = M::LOBE_ERROR;
    const UNIT_STEP: f64 = 1.0 / (1u64 << 24) as f64;
    const LOBE_FLOOR: f64 = M::LOBE_FLOOR;
    const RATIO_FLOOR: f64 = 0.0;
    const PRODUCT_ERROR: f64 = M::POWER_ERROR;
    const GAIN_ERROR: f64 = 2e-7;
    const EXPOSURE_STEP: f64 = 0.0;
    const CODE_ERROR: f64 = M::CODE_ERROR;
    const DIRECTION_NOISE: f64 = 0.02;
    const SCALE_STEP: [f64; 2] = [1.2e-7, 0.0];

    fn no_gain() -> f32 {
        0.0
    }
    fn scale_value(scale: f32) -> f64 {
        f64::from(scale)
    }
    fn value_value(value: f32) -> f64 {
        f64::from(value)
    }
    fn radiance_value(radiance: f32) -> f64 {
        f64::from(radiance)
    }
    fn is_greatest(value: f32) -> bool {
        value == f32::MAX
    }
    fn at_most(radiance: f32, peak: f32) -> bool {
        radiance <= peak
    }
}

macro_rules! fixed_point {
    ($arithmetic:ident, $gain:ident, $component:literal, $lobe:literal, $unit:literal, $ratio:literal, $product:literal, $gain_error:literal, $code:literal, $noise:literal) => {
        impl<const SIZE: usize> Tested for $arithmetic<SIZE> {
            const FRACTIONAL_EXPONENTS: bool = false;
            const COMPONENT_ERROR: f64 = 1.0 / (1u64 << $component) as f64;
            // The table's: `tests/tables.rs` for q31, `table::scaled::tests` for q15.
            const LOBE_ERROR: f64 = $lobe;
            const UNIT_STEP: f64 = 1.0 / (1u64 << $unit) as f64;
            const LOBE_FLOOR: f64 = 0.0;
            const RATIO_FLOOR: f64 = $ratio;
            const PRODUCT_ERROR: f64 = $product;
            const GAIN_ERROR: f64 = $gain_error;
            // Those that truncate lose the last of a share's 31 bits.
            const EXPOSURE_STEP: f64 = if $gain_error > 1e-6 {
                2.0 / (1u64 << 31) as f64
            } else {
                0.0
            };
            const CODE_ERROR: f64 = $code;
            const DIRECTION_NOISE: f64 = $noise;
            const SCALE_STEP: [f64; 2] = [0.0, 1.0 / (1u64 << 32) as f64];

            fn no_gain() -> $gain {
                $gain::new(U32F32::ZERO)
            }
            fn scale_value(scale: U32F32) -> f64 {
                scale.to_num()
            }
            fn value_value(value: U64F64) -> f64 {
                value.to_num()
            }
            fn radiance_value(radiance: U32F32) -> f64 {
                radiance.to_num()
            }
            fn is_greatest(value: U64F64) -> bool {
                value == U64F64::MAX
            }
            fn at_most(radiance: U32F32, peak: U32F32) -> bool {
                radiance <= peak
            }
        }
    };
}

fixed_point!(Q31, Gain31, 31, 1.9e-4, 31, 0.0, 1e-6, 2e-7, 0.54, 0.02);
fixed_point!(Q15, Gain15, 15, 2.3e-3, 24, 1e-5, 1.6e-5, 1.6e-5, 0.73, 0.7);

/// A direction, each component rounded once.
pub fn rounded<A: HostArithmetic>([x, y, z]: [f64; 3]) -> Direction<A> {
    Direction::new(A::component(x), A::component(y), A::component(z))
}

/// The value of a rounded direction.
pub fn value_of<A: HostArithmetic>(direction: &Direction<A>) -> reference::Direction {
    reference::Direction::new(
        A::component_value(direction.x),
        A::component_value(direction.y),
        A::component_value(direction.z),
    )
}

/// Raw bits, for comparison to the last of them: -0.0 is not 0.0 here.
pub fn bits<T: Raw>(results: [T; 3]) -> Vec<u8> {
    let mut all = Vec::new();
    for result in &results {
        result.bytes(&mut |bytes| all.extend_from_slice(bytes));
    }
    all
}
