//! Pixel error where one light's gain is in the tables.

use microbrdf::arithmetic::Q15;
use microbrdf::brdf::{ExposedMetal, ExposedPatch, MetallicPhong, Patch};
use microbrdf::fixed::types::{U2F30, U32F32};
use microbrdf::geometry::ShadingFrame;
use microbrdf::shade::srgb8;
use microbrdf::{ParameterError, Rgb};
use microbrdf_scene::Material;

use super::pixels::{PixelError, graded};

/// The pixel error of a metal with 129 knots of its lobe and 65 of its colour,
/// or of a patch; `None` for other materials.
pub(super) fn exposed_error(
    material: &Material,
    exposure: f64,
) -> Option<Result<PixelError, ParameterError>> {
    let gain = Rgb::grey(U32F32::saturating_from_num(exposure));
    match material {
        Material::Metal {
            exponent,
            reflectance,
        } => Some(
            MetallicPhong::<Q15>::new(U32F32::saturating_from_num(*exponent))
                .and_then(|lobe| ExposedMetal::<129, 65>::new(lobe, &reflectance.curve(), gain))
                .map(|model| error(material, exposure, |pair| model.shade(pair))),
        ),
        Material::Patch { radius } => Some(
            Patch::<Q15>::new(U2F30::saturating_from_num(*radius))
                .and_then(|patch| ExposedPatch::<129>::new(patch, gain))
                .map(|model| error(material, exposure, |pair| model.shade(pair))),
        ),
        _ => None,
    }
}

fn error(
    material: &Material,
    exposure: f64,
    light: impl Fn(&ShadingFrame<Q15>) -> Rgb<u16>,
) -> PixelError {
    // The middle of a step of 16 bits, with 24.
    let code = |light: u16| srgb8(u32::from(light) << 8 | 0x80);
    graded(material, exposure, |pair| light(pair).map(code).to_array())
}
