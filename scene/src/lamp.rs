//! Lights in one arithmetic's numbers, chosen at run time.

use microbrdf::ParameterError;
use microbrdf::geometry::Direction;
use microbrdf::shade::{Dimmed, FloodLight, Light, PointLight};

use crate::description::{LightDescription, LightKind};
use crate::host::HostArithmetic;
use crate::vector::sub;

/// Any of the core's lights.
#[derive(Clone, Debug)]
pub enum AnyLight<A: HostArithmetic> {
    /// At infinity.
    Directional(Direction<A>),
    /// Alike in all directions.
    Point(PointLight<A>),
    /// About an axis.
    Flood(Box<Flood<A>>),
}

/// A flood, and what it is made of.
#[derive(Clone, Debug)]
pub struct Flood<A: HostArithmetic> {
    pub(crate) light: FloodLight<A>,
    pub(crate) lamp: PointLight<A>,
    pub(crate) back: Direction<A>,
    pub(crate) exponent: f64,
}

impl<A: HostArithmetic> Light<A> for AnyLight<A> {
    type Beam = Dimmed<A>;

    fn beam(&self, place: impl Fn() -> A::Place) -> Dimmed<A> {
        match self {
            Self::Directional(direction) => (*direction).into(),
            Self::Point(lamp) => lamp.beam(place),
            Self::Flood(flood) => flood.light.beam(place),
        }
    }

    fn lamp(&self) -> Option<&[A::Length; 3]> {
        match self {
            Self::Directional(direction) => direction.lamp(),
            Self::Point(lamp) => lamp.lamp(),
            Self::Flood(flood) => flood.light.lamp(),
        }
    }
}

impl LightDescription {
    /// The light in the numbers of `A`, as seen from the eye, and the factor
    /// from its colour to the normal irradiance that its gains are for.
    pub(crate) fn prepare<A: HostArithmetic>(
        &self,
        eye: [f64; 3],
    ) -> Result<(AnyLight<A>, f64), ParameterError> {
        let lamp = |position: [f64; 3], near: f64| {
            let lamp = PointLight {
                position: sub(position, eye).map(A::length),
                near: A::length(near),
            };
            // The arithmetic's own `near`, so that its rounding cancels.
            (lamp, A::length_value(lamp.near).powi(-2))
        };
        Ok(match self.kind {
            LightKind::Directional { direction } => {
                (AnyLight::Directional(rounded(direction)), 1.0)
            }
            LightKind::Point { position, near } => {
                let (lamp, factor) = lamp(position, near);
                (AnyLight::Point(lamp), factor)
            }
            LightKind::Flood {
                position,
                near,
                axis,
                exponent,
            } => {
                let (lamp, factor) = lamp(position, near);
                let back = rounded(axis.map(|c| -c));
                let light = A::flood(lamp, back, exponent)?;
                let flood = Flood {
                    light,
                    lamp,
                    back,
                    exponent,
                };
                (AnyLight::Flood(Box::new(flood)), factor)
            }
        })
    }
}

/// A unit vector, each component rounded.
pub(crate) fn rounded<A: HostArithmetic>(vector: [f64; 3]) -> Direction<A> {
    let [x, y, z] = vector.map(A::component);
    Direction::new(x, y, z)
}
