//! Single precision.

use microbrdf::arithmetic::{Approximate, Float, Libm, Math};
use microbrdf::brdf::{
    Axis, Foreshortening, Lambert, Patch, PatchExponential, PhongLobe, Plastic, PowerModel,
};
use microbrdf::geometry::Direction;
use microbrdf::shade::{FloodLight, PointLight};
use microbrdf::{ParameterError, Rgb};

use super::{HostArithmetic, HostModels, Native};

/// How generated Rust names an arithmetic.
trait Named: Math + Send + Sync {
    const TYPE: &'static str;
}

impl Named for Libm {
    const TYPE: &'static str = "microbrdf::arithmetic::F32";
}

/// On a microcontroller it is libm's.
impl Named for Native {
    const TYPE: &'static str = Libm::TYPE;
}

impl Named for Approximate {
    const TYPE: &'static str = "microbrdf::arithmetic::Micromath";
}

fn f32_code(value: f32) -> String {
    format!("f32::from_bits({:#010x})", value.to_bits())
}

impl<M: Named> HostModels for Float<M> {
    fn scale(value: f64) -> f32 {
        value as f32
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
}

impl<M: Named> HostArithmetic for Float<M> {
    const TYPE: &'static str = M::TYPE;

    fn component(value: f64) -> f32 {
        value as f32
    }
    fn component_value(component: f32) -> f64 {
        f64::from(component)
    }
    fn cosine_value(cosine: f32) -> f64 {
        f64::from(cosine)
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
    fn gain(value: f64) -> f32 {
        value as f32
    }
    fn length(value: f64) -> f32 {
        value as f32
    }
    fn length_value(length: f32) -> f64 {
        f64::from(length)
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

    fn plastic(
        albedo: [f64; 3],
        specular: [f64; 3],
        exponent: f64,
    ) -> Result<Plastic<Self>, ParameterError> {
        let rgb = |colour: [f64; 3]| Rgb::from_array(colour.map(|channel| channel as f32));
        Plastic::<Self>::new(rgb(albedo), rgb(specular), exponent as f32)
    }

    fn flood(
        lamp: PointLight<Self>,
        back: Direction<Self>,
        exponent: f64,
    ) -> Result<FloodLight<Self>, ParameterError> {
        FloodLight::<Self>::new(lamp, back, exponent as f32)
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
