//! Which arithmetic and which size of table are the cheapest that are exact
//! enough: cost as it was measured, error as it is found for the material.

mod cost;
mod exposed;
mod pixels;

pub use cost::{Cost, costs};
use exposed::exposed_error;
pub use pixels::{PixelError, pixel_error};

use microbrdf::ParameterError;
use microbrdf::arithmetic::{F32, Micromath, Q15, Q31};
use microbrdf_scene::Material;

/// The pixel error of a material computed in a way; `None` for one that this
/// program was not built with.
pub fn error_of(
    way: &Cost,
    material: &Material,
    exposure: f64,
) -> Option<Result<PixelError, ParameterError>> {
    if way.exposed {
        return match (way.arithmetic.as_str(), way.size) {
            ("q15", Some(129)) => exposed_error(material, exposure),
            _ => None,
        };
    }
    Some(match (way.arithmetic.as_str(), way.size) {
        ("f32", None) => pixel_error::<F32>(material, exposure),
        ("micromath", None) => pixel_error::<Micromath>(material, exposure),
        ("q31", Some(1024)) => pixel_error::<Q31<1024>>(material, exposure),
        ("q31", Some(512)) => pixel_error::<Q31<512>>(material, exposure),
        ("q31", Some(256)) => pixel_error::<Q31<256>>(material, exposure),
        ("q31", Some(128)) => pixel_error::<Q31<128>>(material, exposure),
        ("q31", Some(64)) => pixel_error::<Q31<64>>(material, exposure),
        ("q15", Some(513)) => pixel_error::<Q15<513>>(material, exposure),
        ("q15", Some(257)) => pixel_error::<Q15<257>>(material, exposure),
        ("q15", Some(129)) => pixel_error::<Q15<129>>(material, exposure),
        ("q15", Some(65)) => pixel_error::<Q15<65>>(material, exposure),
        _ => return None,
    })
}
