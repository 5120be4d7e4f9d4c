//! Between f64 and an arithmetic's own numbers.

use fixed::types::{I2F30, I8F24, I24F40, U0F32, U1F31, U2F30, U32F32};
use microbrdf::ParameterError;
use microbrdf::Rgb;
use microbrdf::arithmetic::{F32, Gain31, Q31};
use microbrdf::brdf::{
    Axis, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, Plastic, PowerModel,
};
use microbrdf::shade::Tracing;

/// What a host adds to an arithmetic: conversion of every quantity, each
/// rounded once, and how its constants are written in Rust.
pub trait HostArithmetic:
    Tracing<
        Component: Send + Sync,
        Length: Send + Sync,
        Fine: Send + Sync,
        Gain: Send + Sync,
        Power: Send + Sync,
        Scale: Send + Sync,
        Unit: Send + Sync,
        Separation: Send + Sync,
        Profile: Send + Sync,
        CosinePower: Send + Sync,
    > + Send
    + Sync
{
    /// Its type, in generated Rust.
    const TYPE: &'static str;

    /// Rounds a component of a direction.
    fn component(value: f64) -> Self::Component;
    /// The component's value.
    fn component_value(component: Self::Component) -> f64;
    /// The component in decimal digits that read back exactly.
    fn component_text(component: Self::Component) -> String;
    /// Rounds a share.
    fn unit(value: f64) -> Self::Unit;
    /// The share's value.
    fn unit_value(unit: Self::Unit) -> f64;
    /// Rounds a peak.
    fn scale(value: f64) -> Self::Scale;
    /// Rounds a gain; the greatest that it holds is 4e9.
    fn gain(value: f64) -> Self::Gain;
    /// Rounds a length, of a magnitude below 128.
    fn length(value: f64) -> Self::Length;
    /// Rounds a camera's step.
    fn fine(value: f64) -> Self::Fine;
    /// A BRDF value in decimal digits that read back exactly.
    fn value_text(value: Self::Value) -> String;
    /// A radiance in decimal digits that read back exactly.
    fn radiance_text(radiance: Self::Radiance) -> String;

    /// Rounds a parameter as [`Self::lobe`] does with an exponent.
    fn exponent_value(value: f64) -> f64;
    /// Rounds a radius.
    fn radius_value(value: f64) -> f64;

    /// The lobe of an exponent, an axis and a foreshortening.
    ///
    /// # Errors
    /// An exponent that this arithmetic does not take.
    fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
        exponent: f64,
        foreshortening: P,
    ) -> Result<PhongLobe<Self, X, P>, ParameterError>;
    /// The p-model's foreshortening.
    ///
    /// # Errors
    /// A p outside (0, 1).
    fn power_model(p: f64) -> Result<PowerModel<Self>, ParameterError>;
    /// The basic patch.
    ///
    /// # Errors
    /// A radius outside its range.
    fn patch(radius: f64) -> Result<Patch<Self>, ParameterError>;
    /// The exponential mixture.
    ///
    /// # Errors
    /// A sharpness outside its range.
    fn patch_exponential(sharpness: f64) -> Result<PatchExponential<Self>, ParameterError>;
    /// The diffuser.
    ///
    /// # Errors
    /// An albedo outside its range.
    fn lambert(albedo: [f64; 3]) -> Result<Lambert<Self>, ParameterError>;
    /// The plastic.
    ///
    /// # Errors
    /// A parameter outside its range.
    fn plastic(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
    ) -> Result<Plastic<Self>, ParameterError>;

    /// A Rust expression for a component.
    fn component_code(component: Self::Component) -> String;
    /// A Rust expression for a gain.
    fn gain_code(value: f64) -> String;
    /// A Rust expression for a length.
    fn length_code(length: Self::Length) -> String;
    /// A Rust expression for a camera's step.
    fn fine_code(fine: Self::Fine) -> String;
    /// A Rust expression for an exponent or a sharpness.
    fn parameter_code(value: f64) -> String;
    /// A Rust expression for the p of the p-model.
    fn p_code(p: f64) -> String;
    /// A Rust expression for a radius.
    fn radius_code(radius: f64) -> String;
    /// A Rust expression for the share 1.
    fn one_code() -> &'static str;
}

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

fn f32_code(value: f32) -> String {
    format!("f32::from_bits({:#010x})", value.to_bits())
}

impl HostArithmetic for F32 {
    const TYPE: &'static str = "microbrdf::arithmetic::F32";

    fn component(value: f64) -> f32 {
        value as f32
    }
    fn component_value(component: f32) -> f64 {
        f64::from(component)
    }
    fn component_text(component: f32) -> String {
        f64::from(component).to_string()
    }
    fn unit(value: f64) -> f32 {
        value as f32
    }
    fn unit_value(unit: f32) -> f64 {
        f64::from(unit)
    }
    fn scale(value: f64) -> f32 {
        value as f32
    }
    fn gain(value: f64) -> f32 {
        value as f32
    }
    fn length(value: f64) -> f32 {
        value as f32
    }
    fn fine(value: f64) -> f32 {
        value as f32
    }
    fn value_text(value: f32) -> String {
        f64::from(value).to_string()
    }
    fn radiance_text(radiance: f32) -> String {
        f64::from(radiance).to_string()
    }
    fn exponent_value(value: f64) -> f64 {
        f64::from(value as f32)
    }
    fn radius_value(value: f64) -> f64 {
        f64::from(value as f32)
    }

    fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
        exponent: f64,
        foreshortening: P,
    ) -> Result<PhongLobe<Self, X, P>, ParameterError> {
        PhongLobe::<Self, X, P>::with_foreshortening(exponent as f32, foreshortening)
    }
    fn power_model(p: f64) -> Result<PowerModel<Self>, ParameterError> {
        PowerModel::<Self>::new(p as f32)
    }
    fn patch(radius: f64) -> Result<Patch<Self>, ParameterError> {
        Patch::<Self>::new(radius as f32)
    }
    fn patch_exponential(sharpness: f64) -> Result<PatchExponential<Self>, ParameterError> {
        PatchExponential::<Self>::new(sharpness as f32)
    }
    fn lambert(albedo: [f64; 3]) -> Result<Lambert<Self>, ParameterError> {
        Lambert::<Self>::new(Rgb::from_array(albedo.map(|channel| channel as f32)))
    }
    fn plastic(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
    ) -> Result<Plastic<Self>, ParameterError> {
        let rgb = |colour: [f64; 3]| Rgb::from_array(colour.map(|channel| channel as f32));
        Plastic::<Self>::new(rgb(albedo), rgb(specular), exponent as f32)
    }

    fn component_code(component: f32) -> String {
        f32_code(component)
    }
    fn gain_code(value: f64) -> String {
        f32_code(value as f32)
    }
    fn length_code(length: f32) -> String {
        f32_code(length)
    }
    fn fine_code(fine: f32) -> String {
        f32_code(fine)
    }
    fn parameter_code(value: f64) -> String {
        f32_code(value as f32)
    }
    fn p_code(p: f64) -> String {
        f32_code(p as f32)
    }
    fn radius_code(radius: f64) -> String {
        f32_code(radius as f32)
    }
    fn one_code() -> &'static str {
        "1.0"
    }
}

impl<const CELLS: usize> HostArithmetic for Q31<CELLS> {
    const TYPE: &'static str = "microbrdf::arithmetic::Q31";

    fn component(value: f64) -> I2F30 {
        I2F30::saturating_from_num(value)
    }
    fn component_value(component: I2F30) -> f64 {
        component.to_num()
    }
    fn component_text(component: I2F30) -> String {
        Self::component_value(component).to_string()
    }
    fn unit(value: f64) -> U1F31 {
        U1F31::saturating_from_num(value)
    }
    fn unit_value(unit: U1F31) -> f64 {
        unit.to_num()
    }
    fn scale(value: f64) -> U32F32 {
        U32F32::saturating_from_num(value)
    }
    fn gain(value: f64) -> Gain31 {
        Gain31::new(U32F32::saturating_from_num(value))
    }
    fn length(value: f64) -> I8F24 {
        I8F24::saturating_from_num(value)
    }
    fn fine(value: f64) -> I24F40 {
        I24F40::saturating_from_num(value)
    }
    fn value_text(value: fixed::types::U64F64) -> String {
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

    fn component_code(component: I2F30) -> String {
        format!("I2F30::from_bits({})", component.to_bits())
    }
    fn gain_code(value: f64) -> String {
        let bits = U32F32::saturating_from_num(value).to_bits();
        format!("Gain31::new(U32F32::from_bits({bits}))")
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
