//! Light and colour: spectra to linear sRGB, encoding, colour difference.

mod difference;
mod gamut;
mod metals;
mod observer;
mod srgb;

pub use difference::{ciede2000, lab, lightness};
pub use gamut::to_gamut;
pub use metals::{FresnelCurve, MetalName, metal_index, metal_rgb};
pub use observer::{ILLUMINANT, Observer, WAVELENGTHS, spectrum_to_rgb};
pub use srgb::{decode_srgb, encode_srgb};
