//! What the checksum needs of an arithmetic: its constructors, fed with
//! integers.

use fixed::types::{I2F14, I2F30, U0F32, U1F31, U2F30, U32F32};
use microbrdf::arithmetic::{Arithmetic, Float, Gain15, Gain31, Math, Q15, Q31};
use microbrdf::brdf::{
    Axis, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, Plastic, PowerModel,
};
use microbrdf::{ParameterError, Rgb};

use crate::raw::Raw;

/// An arithmetic whose results can be summed up. Every parameter has 16
/// fraction bits.
pub trait Sampled: Arithmetic<Unit: Raw, Value: Raw, Radiance: Raw, Scale: Raw> {
    /// A component from one with 30 fraction bits, rounded.
    fn component(bits: i32) -> Self::Component;
    /// A gain.
    fn gain(bits: u64) -> Self::Gain;
    /// The lobe of an exponent.
    ///
    /// # Errors
    /// The core's.
    fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
        exponent: u64,
        foreshortening: P,
    ) -> Result<PhongLobe<Self, X, P>, ParameterError>;
    /// The p-model's foreshortening.
    ///
    /// # Errors
    /// The core's.
    fn power_model(p: u16) -> Result<PowerModel<Self>, ParameterError>;
    /// A basic patch.
    ///
    /// # Errors
    /// The core's.
    fn patch(radius: u32) -> Result<Patch<Self>, ParameterError>;
    /// An exponential mixture.
    ///
    /// # Errors
    /// The core's.
    fn patch_exponential(sharpness: u64) -> Result<PatchExponential<Self>, ParameterError>;
    /// A diffuser.
    ///
    /// # Errors
    /// The core's.
    fn lambert(albedo: [u32; 3]) -> Result<Lambert<Self>, ParameterError>;
    /// A plastic.
    ///
    /// # Errors
    /// The core's.
    fn plastic(
        albedo: [u32; 3],
        specular: [u32; 3],
        exponent: u64,
    ) -> Result<Plastic<Self>, ParameterError>;
}

const ONE: f32 = 65_536.0;

impl<M: Math> Sampled for Float<M> {
    fn component(bits: i32) -> f32 {
        bits as f32 / (1 << 30) as f32
    }
    fn gain(bits: u64) -> f32 {
        bits as f32 / ONE
    }
    fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
        exponent: u64,
        foreshortening: P,
    ) -> Result<PhongLobe<Self, X, P>, ParameterError> {
        PhongLobe::<Self, X, P>::with_foreshortening(exponent as f32 / ONE, foreshortening)
    }
    fn power_model(p: u16) -> Result<PowerModel<Self>, ParameterError> {
        PowerModel::<Self>::new(f32::from(p) / ONE)
    }
    fn patch(radius: u32) -> Result<Patch<Self>, ParameterError> {
        Patch::<Self>::new(radius as f32 / ONE)
    }
    fn patch_exponential(sharpness: u64) -> Result<PatchExponential<Self>, ParameterError> {
        PatchExponential::<Self>::new(sharpness as f32 / ONE)
    }
    fn lambert(albedo: [u32; 3]) -> Result<Lambert<Self>, ParameterError> {
        Lambert::<Self>::new(Rgb::from_array(albedo.map(|c| c as f32 / ONE)))
    }
    fn plastic(
        albedo: [u32; 3],
        specular: [u32; 3],
        exponent: u64,
    ) -> Result<Plastic<Self>, ParameterError> {
        let rgb = |colour: [u32; 3]| Rgb::from_array(colour.map(|c| c as f32 / ONE));
        Plastic::<Self>::new(rgb(albedo), rgb(specular), exponent as f32 / ONE)
    }
}

macro_rules! fixed_point {
    ($arithmetic:ident, $component:ident, $gain:ident, $from:expr) => {
        impl<const SIZE: usize> Sampled for $arithmetic<SIZE> {
            fn component(bits: i32) -> $component {
                $component::from_bits($from(bits))
            }
            fn gain(bits: u64) -> $gain {
                $gain::new(U32F32::from_bits(bits << 16))
            }
            fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
                exponent: u64,
                foreshortening: P,
            ) -> Result<PhongLobe<Self, X, P>, ParameterError> {
                let exponent = U32F32::from_bits(exponent << 16);
                PhongLobe::<Self, X, P>::with_foreshortening(exponent, foreshortening)
            }
            fn power_model(p: u16) -> Result<PowerModel<Self>, ParameterError> {
                PowerModel::<Self>::new(U0F32::from_bits(u32::from(p) << 16))
            }
            fn patch(radius: u32) -> Result<Patch<Self>, ParameterError> {
                Patch::<Self>::new(U2F30::from_bits(radius << 14))
            }
            fn patch_exponential(sharpness: u64) -> Result<PatchExponential<Self>, ParameterError> {
                PatchExponential::<Self>::new(U32F32::from_bits(sharpness << 16))
            }
            fn lambert(albedo: [u32; 3]) -> Result<Lambert<Self>, ParameterError> {
                Lambert::<Self>::new(Rgb::from_array(albedo.map(|c| U1F31::from_bits(c << 15))))
            }
            fn plastic(
                albedo: [u32; 3],
                specular: [u32; 3],
                exponent: u64,
            ) -> Result<Plastic<Self>, ParameterError> {
                let rgb =
                    |colour: [u32; 3]| Rgb::from_array(colour.map(|c| U1F31::from_bits(c << 15)));
                Plastic::<Self>::new(
                    rgb(albedo),
                    rgb(specular),
                    U32F32::from_bits(exponent << 16),
                )
            }
        }
    };
}

fixed_point!(Q31, I2F30, Gain31, core::convert::identity);
// Rounded, as a host rounds.
fixed_point!(Q15, I2F14, Gain15, |bits: i32| {
    (bits.saturating_add(1 << 15) >> 16) as i16
});
