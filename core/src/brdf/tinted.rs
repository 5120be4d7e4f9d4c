//! Patches with Fresnel's factor: metals and metallic paints (4.51, 4.54).

use core::marker::PhantomData;

use super::Shape;
use super::patch_exponential::PatchExponential;
use crate::arithmetic::Arithmetic;
use crate::colour::Rgb;
use crate::geometry::Geometry;
use crate::table::CosineCurve;

/// f = shape · F(Θ) (4.51): any shape `S` with Fresnel's factor F tabulated for
/// red, green and blue, at the angle `I`.
///
/// The peak is that of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tinted<S, I> {
    shape: S,
    fresnel: CosineCurve,
    incidence: PhantomData<I>,
}

/// Metallic paint (4.54): the exponential patch with F at θ'.
///
/// Its constant is C(s) of (4.45), where (4.54) has s²/2π: 0.05 % less at
/// s = 10.
pub type MetallicPaint<A> = Tinted<PatchExponential<A>, ThetaPrime>;

/// A metal of patches: the exponential one, or another `S`, with F at Θmin as
/// in (3.29), which spares θ' its root. In the mirror direction both are the
/// angle of incidence.
pub type PatchMetal<S> = Tinted<S, ThetaMin>;

/// At which angle Fresnel's factor is taken.
pub trait Incidence {
    /// Its cosine, for directions above the horizon.
    fn cosine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Cosine;
}

/// At the smaller of both angles to the normal (3.29).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ThetaMin;

impl Incidence for ThetaMin {
    #[inline]
    fn cosine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Cosine {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        A::larger(n_dot_l, n_dot_v)
    }
}

/// At θ' with sinθ' half the distance of the projections of L and V on the
/// base plane (4.53).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ThetaPrime;

impl Incidence for ThetaPrime {
    #[inline]
    fn cosine<A: Arithmetic>(geometry: &impl Geometry<A>) -> A::Cosine {
        A::cos_theta_prime(geometry.separation(), geometry.cosines())
    }
}

impl<S, I> Tinted<S, I> {
    /// `shape`, coloured by `fresnel`, the reflectance over the cosine.
    #[must_use]
    pub const fn new(shape: S, fresnel: CosineCurve) -> Self
    where
        S: Copy,
    {
        Self {
            shape,
            fresnel,
            incidence: PhantomData,
        }
    }
}

impl<S: Shape, I: Incidence> Shape for Tinted<S, I> {
    type Arithmetic = S::Arithmetic;
    type Foreshortening = S::Foreshortening;

    #[inline]
    fn amplitude(&self) -> <S::Arithmetic as Arithmetic>::Scale {
        self.shape.amplitude()
    }

    #[inline]
    fn foreshortening(&self) -> &S::Foreshortening {
        self.shape.foreshortening()
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<S::Arithmetic>) -> <S::Arithmetic as Arithmetic>::Unit {
        self.shape.lobe(geometry)
    }

    #[inline]
    fn coloured(
        &self,
        share: <S::Arithmetic as Arithmetic>::Unit,
        geometry: &impl Geometry<S::Arithmetic>,
    ) -> Rgb<<S::Arithmetic as Arithmetic>::Unit> {
        S::Arithmetic::tint(share, &self.fresnel, I::cosine(geometry))
    }
}
