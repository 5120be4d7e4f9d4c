//! Sampling of Lambert's law.

use super::{Drawn, Sample, Sampling};
use crate::brdf::{Lambert, Shape};
use crate::colour::Rgb;
use crate::geometry::{Direction, ShadingFrame};

/// Density cosΘL/π, uniform points of the base circle; the weight is the
/// albedo, and nothing is rejected.
impl<A: Sampling> Sample<A> for Lambert<A> {
    #[inline]
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>> {
        if !A::above_horizon(v.cosine(), v.cosine()) {
            return None;
        }
        let direction = cosine(random)?;
        let frame = ShadingFrame::new(direction, *v);
        // The lobe is 1, or 0 for a V that is not finite.
        let albedo = self.coloured(self.lobe(&frame), &frame);
        Some(Drawn {
            direction,
            weight: albedo.map(|albedo| A::radiance(A::SCALE_ONE, albedo)),
        })
    }

    #[inline]
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance {
        let share = if A::above_horizon(l.cosine(), v.cosine()) {
            A::foreshorten(A::ONE, l.cosine())
        } else {
            A::ZERO
        };
        A::radiance(self.amplitude(), share)
    }
}

/// A direction of density cosΘ/π.
#[inline]
pub(super) fn cosine<A: Sampling>([u, turn]: [A::Uniform; 2]) -> Option<Direction<A>> {
    let direction = A::raised(A::circle(A::root(A::COSINE_ONE, u), turn));
    // Not so only where a number of f32 was none.
    A::above_horizon(direction.cosine(), direction.cosine()).then_some(direction)
}

/// The weight 1.
#[inline]
pub(super) fn whole<A: Sampling>() -> Rgb<A::Radiance> {
    Rgb::grey(A::radiance(A::SCALE_ONE, A::ONE))
}
