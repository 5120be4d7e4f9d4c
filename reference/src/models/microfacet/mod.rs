//! What the microfacet models share: f = D G F/(4 NL·NV).

mod attenuation;
mod distribution;

pub use attenuation::Attenuation;
pub use distribution::Distribution;

use crate::brdf::luminance;
use crate::fresnel::Index;
use crate::geometry::below_horizon;
use crate::half::Half;
use crate::quadrature::Chart;
use crate::{Direction, ParameterError};

/// The reflectance of a single facet, taken at the angle between L and H.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Facet {
    /// F = 1.
    White,
    /// The same index for all channels.
    Grey(Index),
    /// One index for each channel.
    Coloured([Index; 3]),
}

impl Facet {
    fn reflectance(&self, cos: f64) -> [f64; 3] {
        match self {
            Self::White => [1.0; 3],
            Self::Grey(i) => [i.reflectance(cos); 3],
            Self::Coloured(i) => i.map(|i| i.reflectance(cos)),
        }
    }
}

/// A distribution of facets' normals, an attenuation and a facet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Microfacet {
    distribution: Distribution,
    attenuation: Attenuation,
    facet: Facet,
}

impl Microfacet {
    pub fn new(
        distribution: Distribution,
        attenuation: Attenuation,
        facet: Facet,
    ) -> Result<Self, ParameterError> {
        attenuation.check(&distribution)?;
        Ok(Self {
            distribution,
            attenuation,
            facet,
        })
    }

    pub fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if below_horizon(l, v) {
            return [0.0; 3];
        }
        let Some(h) = Half::of(l, v) else {
            return [f64::MAX; 3];
        };
        let d = self.distribution.density(&h);
        if d == 0.0 {
            return [0.0; 3];
        }
        // G/(NL·NV), formed so that it stays finite where G does the cancelling.
        let shade = self.attenuation.over_cosines(&self.distribution, &h, l, v);
        self.facet
            .reflectance(h.lh)
            .map(|f| (0.25 * d * shade * f).min(f64::MAX))
    }

    pub fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        let f = self.eval_rgb(l, v);
        if self.is_coloured() {
            luminance(f)
        } else {
            f[0]
        }
    }

    pub fn is_coloured(&self) -> bool {
        matches!(self.facet, Facet::Coloured(_))
    }

    pub fn chart(&self) -> Chart {
        self.distribution.chart()
    }

    pub fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.attenuation.creases(l, v, out);
    }

    pub fn is_isotropic(&self) -> bool {
        self.distribution.is_isotropic()
    }
}

/// Forwards the trait to a field that is a [`Microfacet`].
macro_rules! microfacet_brdf {
    ($model:ty) => {
        impl crate::Brdf for $model {
            fn eval(&self, l: &crate::Direction, v: &crate::Direction) -> f64 {
                self.0.eval(l, v)
            }
            fn eval_rgb(&self, l: &crate::Direction, v: &crate::Direction) -> [f64; 3] {
                self.0.eval_rgb(l, v)
            }
            fn is_coloured(&self) -> bool {
                self.0.is_coloured()
            }
            fn chart(&self, _l: &crate::Direction) -> crate::quadrature::Chart {
                self.0.chart()
            }
            fn creases(&self, l: &crate::Direction, v: &crate::Direction, out: &mut Vec<f64>) {
                self.0.creases(l, v, out);
            }
            fn is_isotropic(&self) -> bool {
                self.0.is_isotropic()
            }
        }
    };
}
pub(crate) use microfacet_brdf;
