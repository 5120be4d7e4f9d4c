//! Where the colour of a metal comes from.

use crate::ParameterError;
use crate::colour::{FresnelCurve, MetalName};
use crate::fresnel::Index;

/// The Fresnel reflectance of each channel.
#[derive(Debug, Clone, PartialEq)]
pub enum Tint {
    /// Of one index a channel.
    Indices([Index; 3]),
    /// Of a metal's measured spectrum, integrated to linear sRGB under D65; the channels are
    /// not clipped (see [`crate::colour::metal_rgb`]).
    Spectrum(FresnelCurve),
}

impl Tint {
    /// From the complex index η + ik of each channel.
    pub fn from_indices(eta: [f64; 3], k: [f64; 3]) -> Result<Self, ParameterError> {
        let [r, g, b] = [0, 1, 2].map(|i| Index::new(eta[i], k[i]));
        Ok(Self::Indices([r?, g?, b?]))
    }

    /// From a metal's measured spectrum.
    pub fn named(metal: MetalName) -> Self {
        Self::Spectrum(FresnelCurve::of_metal(metal))
    }

    /// F for each channel at the given cosine.
    pub fn at(&self, cos_theta: f64) -> [f64; 3] {
        match self {
            Self::Indices(indices) => indices.map(|i| i.reflectance(cos_theta)),
            Self::Spectrum(curve) => curve.at(cos_theta),
        }
    }

    /// Whether the channels can differ.
    pub fn is_coloured(&self) -> bool {
        match self {
            Self::Indices([r, g, b]) => r != g || r != b,
            Self::Spectrum(_) => true,
        }
    }
}

impl From<[Index; 3]> for Tint {
    fn from(indices: [Index; 3]) -> Self {
        Self::Indices(indices)
    }
}
