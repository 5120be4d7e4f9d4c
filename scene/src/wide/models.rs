//! Models of parameters in single precision.

use microbrdf::ParameterError;
use microbrdf::Rgb;
use microbrdf::arithmetic::F32;
use microbrdf::brdf::{
    Axis, Brdf, Flat, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, PowerModel,
};

use super::lanes::One;
use super::{Lanes, Wide};
use crate::host::HostModels;

impl HostModels for Wide {
    fn scale(value: f64) -> f32 {
        One::scale(value)
    }
    fn lobe<X: Axis, P: Foreshortening<Self> + Copy>(
        exponent: f64,
        foreshortening: P,
    ) -> Result<PhongLobe<Self, X, P>, ParameterError> {
        let single: PhongLobe<F32, X, Flat> = F32::lobe(exponent, Flat)?;
        let power = exponent as f32;
        Ok(PhongLobe::from_stored(power, single.peak(), foreshortening))
    }
    fn power_model(p: f64) -> Result<PowerModel<Self>, ParameterError> {
        One::power_model(p)?;
        Ok(PowerModel::from_stored(1.0 - p as f32))
    }
    fn patch(radius: f64) -> Result<Patch<Self>, ParameterError> {
        let single = One::patch(radius)?;
        let square = Lanes::all(single.radius_squared());
        Ok(Patch::from_stored(square, single.peak()))
    }
    fn patch_exponential(sharpness: f64) -> Result<PatchExponential<Self>, ParameterError> {
        let single = One::patch_exponential(sharpness)?;
        Ok(PatchExponential::from_stored(
            sharpness as f32,
            single.peak(),
        ))
    }
    fn lambert(albedo: [f64; 3]) -> Result<Lambert<Self>, ParameterError> {
        let single = One::lambert(albedo)?;
        let albedo = Rgb::from_array(albedo.map(|channel| Lanes::all(channel as f32)));
        Ok(Lambert::from_stored(albedo, single.peak()))
    }
}
