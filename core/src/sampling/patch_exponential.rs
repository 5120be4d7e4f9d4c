//! Sampling of the exponential mixture of patches (4.4).

use fixed::types::U32F32;

use super::{Drawn, Sample, Sampling, Spread31};
use crate::arithmetic::{F32, Q31};
use crate::brdf::{PatchExponential, Shape};
use crate::colour::Rgb;
use crate::error::ParameterError;
use crate::geometry::{Direction, Geometry, ShadingFrame};

/// An exponential mixture with what draws its directions, rejecting none.
///
/// C(s) makes 2π·C·∫₀¹ m·e^(−s·m) dm = 1 (4.43), so that points about the
/// projection of R whose distance m has the density ∝ m·e^(−s·m) on [0, 1]
/// have the density f·cosΘL as long as they lie within the base circle. A
/// point outside is mirrored at the middle between that projection and N's,
/// which swaps its distances from the two and brings it into the base circle,
/// where m > 1, which no other point reaches. The density is therefore
/// C·e^(−s·m)·cosΘL where m ≤ 1, and with the distance from N's projection in
/// place of m elsewhere; its integral is 1. The weight is 1 in the first
/// case, and at most 1 in the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchExponentialSampler<A: Sampling> {
    model: PatchExponential<A>,
    spread: A::Spread,
}

impl PatchExponentialSampler<F32> {
    /// The mixture of sharpness `s`, from 0 to 4096.
    ///
    /// # Errors
    /// `s` outside its range or not a number.
    pub const fn new(s: f32) -> Result<Self, ParameterError> {
        match PatchExponential::<F32>::new(s) {
            Ok(model) => Ok(Self {
                model,
                spread: super::f32::Spread::new(s),
            }),
            Err(error) => Err(error),
        }
    }
}

impl<const CELLS: usize> PatchExponentialSampler<Q31<CELLS>> {
    /// The mixture of sharpness `s`, from 0 to 4096.
    ///
    /// # Errors
    /// `s` outside its range.
    pub const fn new(s: U32F32) -> Result<Self, ParameterError> {
        match PatchExponential::<Q31<CELLS>>::new(s) {
            Ok(model) => Ok(Self {
                model,
                spread: Spread31::new(s),
            }),
            Err(error) => Err(error),
        }
    }
}

impl<A: Sampling> PatchExponentialSampler<A> {
    /// The model that is sampled.
    #[must_use]
    pub const fn model(&self) -> &PatchExponential<A> {
        &self.model
    }
}

/// Squared distance of a direction's projection from N's.
#[inline]
fn from_normal<A: Sampling>(l: &Direction<A>) -> A::Separation {
    let alone = |component| A::sum(component, A::COMPONENT_ZERO);
    A::square([alone(l.x), alone(l.y)])
}

impl<A: Sampling> Sample<A> for PatchExponentialSampler<A> {
    #[inline]
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>> {
        if !A::above_horizon(v.cosine(), v.cosine()) {
            return None;
        }
        let [u, turn] = random;
        let offset = A::circle(A::spread(&self.spread, u), turn);
        if let Some(direction) = A::beside(v, offset) {
            return Some(Drawn {
                direction,
                weight: Rgb::grey(A::radiance(A::SCALE_ONE, A::ONE)),
            });
        }
        // R's projection − (R's projection + offset).
        let direction = A::mirrored(&A::raised(offset));
        if !A::above_horizon(direction.cosine(), v.cosine()) {
            return None;
        }
        let m = ShadingFrame::new(direction, *v).separation();
        let excess = A::step_back(m, from_normal(&direction));
        Some(Drawn {
            direction,
            weight: Rgb::grey(A::radiance(A::SCALE_ONE, self.model.profile(excess))),
        })
    }

    #[inline]
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance {
        let share = if A::above_horizon(l.cosine(), v.cosine()) {
            let m = ShadingFrame::new(*l, *v).separation();
            let distance = if m <= A::SEPARATION_ONE {
                m
            } else {
                from_normal(l)
            };
            A::foreshorten(self.model.profile(distance), l.cosine())
        } else {
            A::ZERO
        };
        A::radiance(self.model.amplitude(), share)
    }
}
