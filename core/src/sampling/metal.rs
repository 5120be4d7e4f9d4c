//! Sampling of metals.

use super::phong::{Lobe, MetallicPhongSampler};
use super::{Drawn, Sample, Sampling};
use crate::brdf::{Metal, Mirror};
use crate::geometry::Direction;
use crate::table::CosineCurve;

/// A [`Metal`] with what draws its directions: those of its lobe, weighted
/// with the reflectance F(Θmin) of each channel, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetalSampler<A: Sampling> {
    model: Metal<A>,
    lobe: Lobe<A>,
}

impl<A: Sampling> MetalSampler<A> {
    /// The lobe of `lobe`, coloured by `fresnel`, the reflectance over
    /// cosΘmin.
    #[must_use]
    pub const fn new(lobe: MetallicPhongSampler<A>, fresnel: CosineCurve) -> Self {
        Self {
            model: Metal::new(lobe.model, fresnel),
            lobe: lobe.lobe,
        }
    }

    /// The model that is sampled.
    #[must_use]
    pub const fn model(&self) -> &Metal<A> {
        &self.model
    }
}

impl<A: Sampling> Sample<A> for MetalSampler<A> {
    #[inline]
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>> {
        let direction = self.lobe.draw::<Mirror>(v, random)?;
        let ratio = A::ratio(direction.cosine(), v.cosine());
        let cos_min = A::larger(direction.cosine(), v.cosine());
        let reflectance = self.model.reflectance(cos_min);
        Some(Drawn {
            direction,
            weight: reflectance.map(|channel| {
                let channel = ratio.map_or(channel, |ratio| A::attenuate(channel, ratio));
                A::radiance(self.lobe.gain, channel)
            }),
        })
    }

    #[inline]
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance {
        self.lobe.pdf(self.model.lobe(), l, v)
    }
}
