//! Between f64 and an arithmetic's own numbers.

mod fixed_point;
mod floating_point;
mod models;
mod native;

pub use models::HostModels;
pub use native::Native;

use microbrdf::ParameterError;
use microbrdf::brdf::Plastic;
use microbrdf::geometry::Direction;
use microbrdf::shade::{FloodLight, Placing, PointLight};

/// What a host adds to an arithmetic: conversion of every quantity, each
/// rounded once, and how its constants are written in Rust.
pub trait HostArithmetic:
    HostModels
    + Placing<
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
    /// The cosine's value.
    fn cosine_value(cosine: Self::Cosine) -> f64;
    /// The component in decimal digits that read back exactly.
    fn component_text(component: Self::Component) -> String;
    /// Rounds a share.
    fn unit(value: f64) -> Self::Unit;
    /// The share's value.
    fn unit_value(unit: Self::Unit) -> f64;
    /// Rounds a gain; the greatest that it holds is 4e9.
    fn gain(value: f64) -> Self::Gain;
    /// Rounds a length, of a magnitude below 128.
    fn length(value: f64) -> Self::Length;
    /// The length's value.
    fn length_value(length: Self::Length) -> f64;
    /// Rounds a camera's step.
    fn fine(value: f64) -> Self::Fine;
    /// A BRDF value in decimal digits that read back exactly.
    fn value_text(value: Self::Value) -> String;
    /// A radiance in decimal digits that read back exactly.
    fn radiance_text(radiance: Self::Radiance) -> String;

    /// Rounds a parameter as [`HostModels::lobe`] does with an exponent.
    fn exponent_value(value: f64) -> f64;
    /// Rounds a radius.
    fn radius_value(value: f64) -> f64;

    /// The plastic.
    ///
    /// # Errors
    /// A parameter outside its range.
    fn plastic(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
    ) -> Result<Plastic<Self>, ParameterError>;

    /// The lamp about an axis.
    ///
    /// # Errors
    /// An exponent outside its range.
    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        exponent: f64,
    ) -> Result<FloodLight<Self>, ParameterError>;

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
