//! Sampling of the basic patch (4.2.4).

use fixed::types::{I2F30, U2F30};

use super::lambert::{cosine, whole};
use super::{Drawn, Sample, Sampling};
use crate::arithmetic::{F32, Q31};
use crate::brdf::{Brdf, Patch};
use crate::error::ParameterError;
use crate::geometry::{Direction, ShadingFrame};

/// A basic patch with what draws its directions: uniform points of the
/// smaller of disc and base circle, rejected outside the larger. The density
/// is f·cosΘL and every weight 1; the mass that is rejected is 1 less the
/// albedo.
///
/// In `q31` a direction that is drawn lies within the patch, exactly; in
/// `f32` it can lie outside by as much as the patch's edge is uncertain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchSampler<A: Sampling> {
    model: Patch<A>,
    /// That of the disc; `None` where the base circle is smaller.
    radius: Option<A::Component>,
}

impl PatchSampler<F32> {
    /// The disc of radius `radius`, from 1e-4 to 2.
    ///
    /// # Errors
    /// `radius` outside its range or not a number.
    pub const fn new(radius: f32) -> Result<Self, ParameterError> {
        match Patch::<F32>::new(radius) {
            Ok(model) => Ok(Self {
                model,
                radius: if radius < 1.0 { Some(radius) } else { None },
            }),
            Err(error) => Err(error),
        }
    }
}

impl<const CELLS: usize> PatchSampler<Q31<CELLS>> {
    /// The disc of radius `radius`, from 1e-4 to 2.
    ///
    /// # Errors
    /// `radius` outside its range.
    pub const fn new(radius: U2F30) -> Result<Self, ParameterError> {
        match Patch::<Q31<CELLS>>::new(radius) {
            Ok(model) => Ok(Self {
                model,
                radius: if radius.to_bits() < 1 << 30 {
                    Some(I2F30::from_bits(radius.to_bits() as i32))
                } else {
                    None
                },
            }),
            Err(error) => Err(error),
        }
    }
}

impl<A: Sampling> PatchSampler<A> {
    /// The model that is sampled.
    #[must_use]
    pub const fn model(&self) -> &Patch<A> {
        &self.model
    }
}

impl<A: Sampling> Sample<A> for PatchSampler<A> {
    #[inline]
    fn sample(&self, v: &Direction<A>, random: [A::Uniform; 2]) -> Option<Drawn<A>> {
        if !A::above_horizon(v.cosine(), v.cosine()) {
            return None;
        }
        let direction = if let Some(radius) = self.radius {
            let [u, turn] = random;
            A::beside(v, A::circle(A::root(radius, u), turn))?
        } else {
            let direction = cosine(random)?;
            if self.model.share(&ShadingFrame::new(direction, *v)).r == A::ZERO {
                return None;
            }
            direction
        };
        Some(Drawn {
            direction,
            weight: whole::<A>(),
        })
    }

    #[inline]
    fn pdf(&self, l: &Direction<A>, v: &Direction<A>) -> A::Radiance {
        self.model.reflect(&ShadingFrame::new(*l, *v)).r
    }
}
