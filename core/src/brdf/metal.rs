//! Metals: cosⁿα / g(Θmin) (3.29).

use super::Shape;
use super::foreshortening::Metallic;
use super::phong::MetallicPhong;
use crate::arithmetic::Arithmetic;
use crate::colour::Rgb;
use crate::geometry::Geometry;
use crate::table::CosineCurve;

/// f = cosⁿα / g(Θmin) = c_n · F(Θmin) · cosⁿα / cosΘmin (3.29), with
/// Fresnel's factor F tabulated for red, green and blue.
///
/// 1/g is unbounded at grazing, so cosΘmin/g = c_n·F is what is stored, and
/// the ratio of cosines is formed apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal<A: Arithmetic> {
    lobe: MetallicPhong<A>,
    fresnel: CosineCurve,
}

impl<A: Arithmetic> Metal<A> {
    /// The lobe of `lobe`, coloured by `fresnel`, the reflectance over
    /// cosΘmin.
    #[must_use]
    pub const fn new(lobe: MetallicPhong<A>, fresnel: CosineCurve) -> Self {
        Self { lobe, fresnel }
    }

    /// Its lobe.
    #[inline]
    pub(crate) fn lobe(&self) -> &MetallicPhong<A> {
        &self.lobe
    }

    /// F at cosΘmin.
    #[inline]
    pub(crate) fn reflectance(&self, cosine: A::Cosine) -> Rgb<A::Unit> {
        A::curve(&self.fresnel, cosine)
    }
}

impl<A: Arithmetic> Shape for Metal<A> {
    type Arithmetic = A;
    type Foreshortening = Metallic;

    #[inline]
    fn amplitude(&self) -> A::Scale {
        self.lobe.amplitude()
    }

    #[inline]
    fn foreshortening(&self) -> &Metallic {
        self.lobe.foreshortening()
    }

    #[inline]
    fn lobe(&self, geometry: &impl Geometry<A>) -> A::Unit {
        self.lobe.lobe(geometry)
    }

    #[inline]
    fn coloured(&self, share: A::Unit, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        let (n_dot_l, n_dot_v) = geometry.cosines();
        A::tint(share, &self.fresnel, A::larger(n_dot_l, n_dot_v))
    }
}
