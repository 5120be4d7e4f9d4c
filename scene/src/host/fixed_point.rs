//! Fixed point.

use fixed::types::{I2F14, I2F30, I8F24, I24F40, U0F32, U1F31, U2F30, U32F32, U64F64};
use microbrdf::arithmetic::{Arithmetic, Gain15, Gain31, Q15, Q31};
use microbrdf::brdf::{
    Axis, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, Plastic, PowerModel,
};
use microbrdf::geometry::Direction;
use microbrdf::shade::{FloodLight, PointLight};
use microbrdf::{ParameterError, Rgb};

use super::{HostArithmetic, HostModels};

/// `value`/2^`bits` with all its decimals, of which there are at most `bits`:
/// it reads back exactly into any type that holds it. (The digits that `fixed`
/// itself prints read back only into the same type.)
fn exact(value: u128, bits: u32) -> String {
    let mask = (1 << bits) - 1;
    let mut text = (value >> bits).to_string();
    let mut rest = value & mask;
    if rest != 0 {
        text.push('.');
    }
    while rest != 0 {
        rest *= 10;
        text.push(char::from(b'0' + (rest >> bits) as u8));
        rest &= mask;
    }
    text
}

macro_rules! fixed_point {
    ($arithmetic:ident, $component:ident, $cosine:expr, $gain:ident) => {
        impl<const SIZE: usize> HostModels for $arithmetic<SIZE> {
            fn scale(value: f64) -> U32F32 {
                U32F32::saturating_from_num(value)
            }
            fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
                exponent: f64,
                foreshortening: P,
            ) -> Result<PhongLobe<Self, X, P>, ParameterError> {
                let exponent = U32F32::saturating_from_num(exponent);
                PhongLobe::<Self, X, P>::with_foreshortening(exponent, foreshortening)
            }
            fn power_model(p: f64) -> Result<PowerModel<Self>, ParameterError> {
                PowerModel::<Self>::new(U0F32::saturating_from_num(p))
            }
            fn patch(radius: f64) -> Result<Patch<Self>, ParameterError> {
                Patch::<Self>::new(U2F30::saturating_from_num(radius))
            }
            fn patch_exponential(sharpness: f64) -> Result<PatchExponential<Self>, ParameterError> {
                PatchExponential::<Self>::new(U32F32::saturating_from_num(sharpness))
            }
            fn lambert(albedo: [f64; 3]) -> Result<Lambert<Self>, ParameterError> {
                Lambert::<Self>::new(Rgb::from_array(albedo.map(Self::unit)))
            }
        }

        impl<const SIZE: usize> HostArithmetic for $arithmetic<SIZE> {
            const TYPE: &'static str = concat!("microbrdf::arithmetic::", stringify!($arithmetic));

            fn component(value: f64) -> $component {
                $component::saturating_from_num(value)
            }
            fn component_value(component: $component) -> f64 {
                component.to_num()
            }
            fn cosine_value(cosine: <Self as Arithmetic>::Cosine) -> f64 {
                $cosine(cosine)
            }
            fn component_text(component: $component) -> String {
                Self::component_value(component).to_string()
            }
            fn unit(value: f64) -> U1F31 {
                U1F31::saturating_from_num(value)
            }
            fn unit_value(unit: U1F31) -> f64 {
                unit.to_num()
            }
            fn gain(value: f64) -> $gain {
                $gain::new(U32F32::saturating_from_num(value))
            }
            fn length(value: f64) -> I8F24 {
                I8F24::saturating_from_num(value)
            }
            fn length_value(length: I8F24) -> f64 {
                length.to_num()
            }
            fn fine(value: f64) -> I24F40 {
                I24F40::saturating_from_num(value)
            }
            fn value_text(value: U64F64) -> String {
                exact(value.to_bits(), 64)
            }
            fn radiance_text(radiance: U32F32) -> String {
                exact(radiance.to_bits().into(), 32)
            }
            fn exponent_value(value: f64) -> f64 {
                U32F32::saturating_from_num(value).to_num()
            }
            fn radius_value(value: f64) -> f64 {
                U2F30::saturating_from_num(value).to_num()
            }

            fn plastic(
                albedo: [f64; 3],
                specular: [f64; 3],
                exponent: f64,
            ) -> Result<Plastic<Self>, ParameterError> {
                let rgb = |colour: [f64; 3]| Rgb::from_array(colour.map(Self::unit));
                Plastic::<Self>::new(
                    rgb(albedo),
                    rgb(specular),
                    U32F32::saturating_from_num(exponent),
                )
            }

            fn flood(
                lamp: PointLight<Self>,
                back: Direction<Self>,
                exponent: f64,
            ) -> Result<FloodLight<Self>, ParameterError> {
                FloodLight::<Self>::new(lamp, back, U32F32::saturating_from_num(exponent))
            }

            fn component_code(component: $component) -> String {
                format!(
                    concat!(stringify!($component), "::from_bits({})"),
                    component.to_bits()
                )
            }
            fn gain_code(value: f64) -> String {
                let bits = U32F32::saturating_from_num(value).to_bits();
                format!(
                    concat!(stringify!($gain), "::new(U32F32::from_bits({}))"),
                    bits
                )
            }
            fn length_code(length: I8F24) -> String {
                format!("I8F24::from_bits({})", length.to_bits())
            }
            fn fine_code(fine: I24F40) -> String {
                format!("I24F40::from_bits({})", fine.to_bits())
            }
            fn parameter_code(value: f64) -> String {
                format!(
                    "U32F32::from_bits({})",
                    U32F32::saturating_from_num(value).to_bits()
                )
            }
            fn p_code(p: f64) -> String {
                format!(
                    "U0F32::from_bits({})",
                    U0F32::saturating_from_num(p).to_bits()
                )
            }
            fn radius_code(radius: f64) -> String {
                format!(
                    "U2F30::from_bits({})",
                    U2F30::saturating_from_num(radius).to_bits()
                )
            }
            fn one_code() -> &'static str {
                "U1F31::ONE"
            }
        }
    };
}

fixed_point!(Q31, I2F30, I2F30::to_num, Gain31);
fixed_point!(Q15, I2F14, |bits| I2F30::from_bits(bits).to_num(), Gain15);
