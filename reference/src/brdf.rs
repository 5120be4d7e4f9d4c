//! What every model offers.

use crate::Direction;
use crate::quadrature::Chart;

/// Weights of linear sRGB's channels in luminance (Rec. 709).
pub const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// A reflectance model with its parameters.
///
/// f(L, V) is in sr⁻¹ and does not contain the cosine. Both directions point
/// away from the surface; one below the horizon (cosine < 0) gives 0. Models
/// with a Dirac part give its weight by [`Brdf::delta_weight`], and only the rest here.
pub trait Brdf {
    /// f(L, V) in sr⁻¹; of a coloured model the luminance of [`Brdf::eval_rgb`].
    ///
    /// Where f is unbounded (both cosines 0, with a lobe there) the result is `f64::MAX`.
    fn eval(&self, l: &Direction, v: &Direction) -> f64;

    /// f(L, V) for red, green and blue; three times the same unless the model is coloured.
    fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        [self.eval(l, v); 3]
    }

    /// Whether the channels can differ.
    fn is_coloured(&self) -> bool {
        false
    }

    /// The peak c that is split off f·cosΘL: `reflect` = `peak` · `rho`.
    ///
    /// It is the constant in front of the lobe, and 1 for models without such a bound.
    fn peak(&self) -> f64 {
        1.0
    }

    /// ρ = lobe · ratio (· Fresnel): f·cosΘL / c without forming the unbounded f.
    ///
    /// In [0, 1] for the models that give their own peak, but for a coloured
    /// metal's channels outside sRGB's gamut.
    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        if crate::geometry::below_horizon(l, v) || l.z == 0.0 {
            return [0.0; 3];
        }
        let scale = l.z / self.peak();
        self.eval_rgb(l, v).map(|f| f * scale)
    }

    /// Reflected radiance f·cosΘL for unit normal irradiance, in sr⁻¹.
    fn reflect(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        let c = self.peak();
        self.rho(l, v).map(|r| c * r)
    }

    /// The weight of the Dirac part about the mirror direction: the share of the
    /// radiance from R that is reflected unchanged. 0 for most models.
    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        let _ = l;
        [0.0; 3]
    }

    /// Where the model is large and how fast it changes: guides the quadrature,
    /// and never changes its result beyond its error estimate.
    fn chart(&self, l: &Direction) -> Chart {
        let _ = l;
        Chart::cosine()
    }

    /// Functions of the pair that are 0 where f has a crease, appended to `out`
    /// in a fixed order. The horizon need not be named.
    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        let _ = (l, v, out);
    }

    /// Whether f depends on the azimuths of L and V by their difference alone,
    /// and not on its sign.
    fn is_isotropic(&self) -> bool {
        true
    }
}

/// A pointer to a model is that model.
macro_rules! pointer_brdf {
    ($pointer:ty) => {
        impl<T: Brdf + ?Sized> Brdf for $pointer {
            fn eval(&self, l: &Direction, v: &Direction) -> f64 {
                (**self).eval(l, v)
            }
            fn eval_rgb(&self, l: &Direction, v: &Direction) -> [f64; 3] {
                (**self).eval_rgb(l, v)
            }
            fn is_coloured(&self) -> bool {
                (**self).is_coloured()
            }
            fn peak(&self) -> f64 {
                (**self).peak()
            }
            fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
                (**self).rho(l, v)
            }
            fn reflect(&self, l: &Direction, v: &Direction) -> [f64; 3] {
                (**self).reflect(l, v)
            }
            fn delta_weight(&self, l: &Direction) -> [f64; 3] {
                (**self).delta_weight(l)
            }
            fn chart(&self, l: &Direction) -> Chart {
                (**self).chart(l)
            }
            fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
                (**self).creases(l, v, out);
            }
            fn is_isotropic(&self) -> bool {
                (**self).is_isotropic()
            }
        }
    };
}

pointer_brdf!(&T);
pointer_brdf!(Box<T>);

/// One channel of a coloured model, as a grey model.
#[derive(Debug, Clone, Copy)]
pub struct Channel<B>(pub B, pub usize);

impl<B: Brdf> Brdf for Channel<B> {
    fn eval(&self, l: &Direction, v: &Direction) -> f64 {
        self.0.eval_rgb(l, v)[self.1]
    }
    fn peak(&self) -> f64 {
        self.0.peak()
    }
    fn rho(&self, l: &Direction, v: &Direction) -> [f64; 3] {
        [self.0.rho(l, v)[self.1]; 3]
    }
    fn delta_weight(&self, l: &Direction) -> [f64; 3] {
        [self.0.delta_weight(l)[self.1]; 3]
    }
    fn chart(&self, l: &Direction) -> Chart {
        self.0.chart(l)
    }
    fn creases(&self, l: &Direction, v: &Direction, out: &mut Vec<f64>) {
        self.0.creases(l, v, out);
    }
    fn is_isotropic(&self) -> bool {
        self.0.is_isotropic()
    }
}

/// The luminance of three channels.
pub fn luminance(rgb: [f64; 3]) -> f64 {
    rgb[0] * LUMINANCE[0] + rgb[1] * LUMINANCE[1] + rgb[2] * LUMINANCE[2]
}
