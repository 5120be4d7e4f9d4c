//! Sampling of cosⁿα lobes (3.19 to 3.26).

use fixed::types::U32F32;

use super::{Drawn, Reciprocal, Sample, Sampling};
use crate::arithmetic::{F32, Q31};
use crate::brdf::{
    Axis, Flat, Foreshortening, Metallic, Mirror, PhongLobe, PowerModel, Retro, Shape,
};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::{Direction, ShadingFrame};
use crate::table::integer::{INVERSE_PI, divide};

/// Where a lobe's axis lies for a V.
pub trait LobeAxis: Axis {
    /// The axis.
    fn of<A: Sampling>(v: &Direction<A>) -> Direction<A>;
}

impl LobeAxis for Mirror {
    #[inline]
    fn of<A: Sampling>(v: &Direction<A>) -> Direction<A> {
        A::mirrored(v)
    }
}

impl LobeAxis for Retro {
    #[inline]
    fn of<A: Sampling>(v: &Direction<A>) -> Direction<A> {
        *v
    }
}

/// A cosⁿα lobe with what draws its directions: density (n + 1)/2π · cosⁿα
/// about the lobe's axis (3.19), weight (n + 2)/(n + 1) · cosΘL/cosᵖΘmin
/// (3.26).
///
/// What falls below the horizon is rejected: half of the lobe at 90°.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhongLobeSampler<A: Sampling, X, P> {
    pub(super) model: PhongLobe<A, X, P>,
    pub(super) lobe: Lobe<A>,
}

/// What drawing from a lobe takes, whatever its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lobe<A: Sampling> {
    concentration: A::Concentration,
    /// (n + 1)/2π.
    density: A::Scale,
    /// The peak over that.
    pub(super) gain: A::Scale,
}

/// Sampler of [`MetallicPhong`](crate::brdf::MetallicPhong).
pub type MetallicPhongSampler<A> = PhongLobeSampler<A, Mirror, Metallic>;
/// Sampler of [`Phong`](crate::brdf::Phong).
pub type PhongSampler<A> = PhongLobeSampler<A, Mirror, Flat>;
/// Sampler of [`PModel`](crate::brdf::PModel).
pub type PModelSampler<A> = PhongLobeSampler<A, Mirror, PowerModel<A>>;
/// Sampler of [`RetroPhong`](crate::brdf::RetroPhong).
pub type RetroPhongSampler<A> = PhongLobeSampler<A, Retro, Metallic>;

impl<A: Sampling, X: Axis, P: Foreshortening<A>> PhongLobeSampler<A, X, P> {
    /// The model that is sampled.
    #[must_use]
    pub const fn model(&self) -> &PhongLobe<A, X, P> {
        &self.model
    }

    /// The same with another peak in sr⁻¹, as [`PhongLobe::with_peak`].
    #[must_use]
    pub fn with_peak(self, peak: A::Scale) -> Self {
        Self {
            model: self.model.with_peak(peak),
            lobe: Lobe {
                gain: A::quotient(peak, self.lobe.density),
                ..self.lobe
            },
        }
    }
}

impl<X: Axis, P: Foreshortening<F32>> PhongLobeSampler<F32, X, P> {
    /// The lobe with exponent `n` from 0 to 1e8 and a foreshortening.
    ///
    /// # Errors
    /// `n` outside its range or not a number.
    pub const fn with_foreshortening(n: f32, foreshortening: P) -> Result<Self, ParameterError>
    where
        P: Copy,
    {
        match PhongLobe::<F32, X, P>::with_foreshortening(n, foreshortening) {
            Ok(model) => Ok(Self {
                model,
                lobe: Lobe {
                    concentration: 1.0 / (n + 1.0),
                    density: (n + 1.0) / core::f32::consts::TAU,
                    gain: (n + 2.0) / (n + 1.0),
                },
            }),
            Err(error) => Err(error),
        }
    }
}

impl<const CELLS: usize, X: Axis, P: Foreshortening<Q31<CELLS>>>
    PhongLobeSampler<Q31<CELLS>, X, P>
{
    /// The lobe with exponent `n`, 0 or from 1 to 1e8, and a foreshortening.
    ///
    /// # Errors
    /// `n` outside its range.
    pub const fn with_foreshortening(n: U32F32, foreshortening: P) -> Result<Self, ParameterError>
    where
        P: Copy,
    {
        let model = match PhongLobe::<Q31<CELLS>, X, P>::with_foreshortening(n, foreshortening) {
            Ok(model) => model,
            Err(error) => return Err(error),
        };
        // In range, so nothing overflows.
        let n = n.to_bits() as u128;
        let (above, next) = (n + (1 << 32), n + (2 << 32));
        Ok(Self {
            model,
            lobe: Lobe {
                concentration: Reciprocal::new(above as u64),
                density: U32F32::from_bits(((above * INVERSE_PI) >> 65) as u64),
                gain: U32F32::from_bits(divide(next << 32, above) as u64),
            },
        })
    }
}

macro_rules! plain_constructors {
    ($($foreshortening:ident),*) => {$(
        impl<X: Axis> PhongLobeSampler<F32, X, $foreshortening> {
            /// The lobe with exponent `n` from 0 to 1e8.
            ///
            /// # Errors
            /// `n` outside its range or not a number.
            pub const fn new(n: f32) -> Result<Self, ParameterError> {
                Self::with_foreshortening(n, $foreshortening)
            }
        }

        impl<const CELLS: usize, X: Axis> PhongLobeSampler<Q31<CELLS>, X, $foreshortening> {
            /// The lobe with exponent `n`, 0 or from 1 to 1e8.
            ///
            /// # Errors
            /// `n` outside its range.
            pub const fn new(n: U32F32) -> Result<Self, ParameterError> {
                Self::with_foreshortening(n, $foreshortening)
            }
        }
    )*};
}

plain_constructors!(Flat, Metallic);

impl<A: Sampling> Lobe<A> {
    /// A direction above the horizon, or `None`.
    #[inline]
    pub(super) fn draw<X: LobeAxis>(
        &self,
        v: &Direction<A>,
        random: [A::Uniform; 2],
    ) -> Option<Direction<A>> {
        if !A::above_horizon(v.cosine(), v.cosine()) {
            return None;
        }
        let [u, turn] = random;
        let l = A::about(&X::of(v), A::cap(&self.concentration, u), turn);
        A::above_horizon(l.cosine(), v.cosine()).then_some(l)
    }

    /// The density of drawing L about the axis of `model`'s lobe.
    #[inline]
    pub(super) fn pdf<X: Axis, P: Foreshortening<A>>(
        &self,
        model: &PhongLobe<A, X, P>,
        l: &Direction<A>,
        v: &Direction<A>,
    ) -> A::Radiance {
        let share = if A::above_horizon(l.cosine(), v.cosine()) {
            model.lobe(&ShadingFrame::new(*l, *v))
        } else {
            A::ZERO
        };
        A::radiance(self.density, share)
    }
}

impl<A: Sampling, X: LobeAxis, P: Foreshortening<A>> Sample<A> for PhongLobeSampler<A, X, P> {
    #[inline]
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>> {
        let direction = self.lobe.draw::<X>(v, random)?;
        let foreshortening = self.model.foreshortening();
        let ratio = foreshortening.attenuate(A::ONE, direction.cosine(), v.cosine());
        Some(Drawn {
            direction,
            weight: Rgb::grey(A::radiance(self.lobe.gain, ratio)),
        })
    }

    #[inline]
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance {
        self.lobe.pdf(&self.model, l, v)
    }
}
