//! The core's models from f64.

use microbrdf::ParameterError;
use microbrdf::arithmetic::Arithmetic;
use microbrdf::brdf::{
    Axis, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, PowerModel,
};

/// An arithmetic whose models can be made of parameters in f64.
pub trait HostModels: Arithmetic {
    /// Rounds a peak.
    fn scale(value: f64) -> Self::Scale;
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
}
