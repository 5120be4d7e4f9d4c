//! Lights: ambient, directional, point and flood (Szirmay-Kalos, section 3.6).

use crate::error::{above, channels_within, within};
use crate::{Brdf, Direction, ParameterError};

/// How a lamp's intensity falls off with the distance d.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attenuation {
    /// 1/d², what a point does.
    InverseSquare,
    /// 1/(a·d + b), which stays finite near the lamp.
    Linear {
        /// a, at least 0.
        a: f64,
        /// b, at least 0.
        b: f64,
    },
    /// 1/(a·dᵐ + b), for fog.
    Power {
        /// a, at least 0.
        a: f64,
        /// b, at least 0.
        b: f64,
        /// m, at least 0.
        m: f64,
    },
}

impl Attenuation {
    fn checked(self) -> Result<Self, ParameterError> {
        let (a, b, m) = match self {
            Self::InverseSquare => return Ok(self),
            Self::Linear { a, b } => (a, b, 1.0),
            Self::Power { a, b, m } => (a, b, m),
        };
        within("a", a, 0.0, f64::INFINITY)?;
        within("b", b, 0.0, f64::INFINITY)?;
        within("m", m, 0.0, 100.0)?;
        above("a + b", a + b, 0.0, f64::INFINITY)?;
        Ok(self)
    }

    /// The factor at distance d (at least 0), at most `f64::MAX`.
    pub fn at(self, d: f64) -> f64 {
        let denominator = match self {
            Self::InverseSquare => d * d,
            Self::Linear { a, b } => a * d + b,
            Self::Power { a, b, m } => a * d.powf(m) + b,
        };
        (1.0 / denominator).min(f64::MAX)
    }
}

/// A light in some frame of the caller's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    kind: Kind,
    /// Radiance, normal irradiance or intensity, by kind.
    colour: [f64; 3],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Ambient,
    Directional {
        to_light: Direction,
    },
    Point {
        position: [f64; 3],
        attenuation: Attenuation,
    },
    Flood {
        position: [f64; 3],
        attenuation: Attenuation,
        axis: Direction,
        exponent: f64,
    },
}

/// What a light does at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Illumination {
    /// The same radiance from everywhere.
    Uniform {
        /// Radiance of each channel.
        radiance: [f64; 3],
    },
    /// A collimated beam.
    Beam {
        /// Unit vector towards the light.
        to_light: Direction,
        /// Irradiance of a surface at right angles to the beam, for each channel.
        normal_irradiance: [f64; 3],
    },
}

impl Light {
    /// Uniform radiance from all directions, at least 0: daylight.
    pub fn ambient(radiance: [f64; 3]) -> Result<Self, ParameterError> {
        Ok(Self {
            kind: Kind::Ambient,
            colour: colour("radiance", radiance)?,
        })
    }

    /// A light at infinity in direction `to_light` (any length above 0), with the
    /// irradiance of a surface facing it.
    pub fn directional(
        to_light: Direction,
        normal_irradiance: [f64; 3],
    ) -> Result<Self, ParameterError> {
        above("to_light", to_light.length(), 0.0, f64::INFINITY)?;
        let colour = colour("normal_irradiance", normal_irradiance)?;
        Ok(Self {
            kind: Kind::Directional {
                to_light: to_light.normalised(),
            },
            colour,
        })
    }

    /// A lamp with the given intensity at a position.
    pub fn point(
        position: [f64; 3],
        intensity: [f64; 3],
        attenuation: Attenuation,
    ) -> Result<Self, ParameterError> {
        let attenuation = attenuation.checked()?;
        Ok(Self {
            kind: Kind::Point {
                position,
                attenuation,
            },
            colour: colour("intensity", intensity)?,
        })
    }

    /// A lamp whose intensity falls as cosⁿξ from its axis (3.62 of that text), 0 behind it.
    pub fn flood(
        position: [f64; 3],
        intensity: [f64; 3],
        attenuation: Attenuation,
        axis: Direction,
        exponent: f64,
    ) -> Result<Self, ParameterError> {
        above("axis", axis.length(), 0.0, f64::INFINITY)?;
        Ok(Self {
            kind: Kind::Flood {
                position,
                attenuation: attenuation.checked()?,
                axis: axis.normalised(),
                exponent: within("exponent", exponent, 0.0, 1e8)?,
            },
            colour: colour("intensity", intensity)?,
        })
    }

    /// What arrives at a point.
    pub fn at(&self, point: [f64; 3]) -> Illumination {
        let beam = |position: [f64; 3], attenuation: Attenuation| {
            let to = Direction::new(
                position[0] - point[0],
                position[1] - point[1],
                position[2] - point[2],
            );
            (to.normalised(), attenuation.at(to.length()))
        };
        let (to_light, factor) = match self.kind {
            Kind::Ambient => {
                return Illumination::Uniform {
                    radiance: self.colour,
                };
            }
            Kind::Directional { to_light } => (to_light, 1.0),
            Kind::Point {
                position,
                attenuation,
            } => beam(position, attenuation),
            Kind::Flood {
                position,
                attenuation,
                axis,
                exponent,
            } => {
                let (to, factor) = beam(position, attenuation);
                let cos = -axis.dot(to);
                (
                    to,
                    if cos > 0.0 {
                        factor * cos.powf(exponent)
                    } else {
                        0.0
                    },
                )
            }
        };
        Illumination::Beam {
            to_light,
            normal_irradiance: self.colour.map(|c| (c * factor).min(f64::MAX)),
        }
    }
}

fn colour(name: &'static str, c: [f64; 3]) -> Result<[f64; 3], ParameterError> {
    channels_within(name, c, 0.0, f64::INFINITY)
}

/// The radiance that a surface with normal +z reflects towards `v`.
///
/// A beam gives f·cosΘL times the normal irradiance (2.3); uniform light the albedo of
/// the whole model, each channel by itself, times the radiance (3.32).
pub fn reflected_radiance<B: Brdf + ?Sized>(
    brdf: &B,
    illumination: &Illumination,
    v: &Direction,
) -> [f64; 3] {
    match illumination {
        Illumination::Beam {
            to_light,
            normal_irradiance,
        } => {
            let r = brdf.reflect(to_light, v);
            [0, 1, 2].map(|i| r[i] * normal_irradiance[i])
        }
        Illumination::Uniform { radiance } => {
            let a = crate::directional_albedo_rgb(brdf, v.z);
            [0, 1, 2].map(|i| a[i].value * radiance[i])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Lambert, Metal};

    #[test]
    fn a_lamp_of_intensity_one_at_distance_one_gives_irradiance_one() {
        let lamp = Light::point([0.0, 0.0, 1.0], [1.0; 3], Attenuation::InverseSquare).unwrap();
        let Illumination::Beam {
            to_light,
            normal_irradiance,
        } = lamp.at([0.0; 3])
        else {
            panic!("a beam");
        };
        assert_eq!((to_light, normal_irradiance), (Direction::NORMAL, [1.0; 3]));
        let far = lamp.at([0.0, 0.0, -1.0]);
        assert_eq!(
            far,
            Illumination::Beam {
                to_light,
                normal_irradiance: [0.25; 3]
            }
        );
    }

    #[test]
    fn other_attenuations_and_floods() {
        assert_eq!(Attenuation::Linear { a: 2.0, b: 1.0 }.at(1.5), 0.25);
        assert_eq!(
            Attenuation::Power {
                a: 1.0,
                b: 1.0,
                m: 3.0
            }
            .at(2.0),
            1.0 / 9.0
        );
        let down = Direction::new(0.0, 0.0, -1.0);
        let flood = Light::flood(
            [0.0, 0.0, 1.0],
            [1.0; 3],
            Attenuation::InverseSquare,
            down,
            2.0,
        )
        .unwrap();
        let at = |p: [f64; 3]| match flood.at(p) {
            Illumination::Beam {
                normal_irradiance, ..
            } => normal_irradiance[0],
            Illumination::Uniform { .. } => panic!("a beam"),
        };
        assert_eq!(at([0.0; 3]), 1.0);
        // 45° off the axis at distance √2: ½ · ½.
        assert!((at([1.0, 0.0, 0.0]) - 0.25).abs() < 1e-15);
        assert_eq!(at([0.0, 0.0, 2.0]), 0.0);
        let bad = Attenuation::Linear { a: 0.0, b: 0.0 };
        assert!(Light::point([0.0; 3], [1.0; 3], bad).is_err());
    }

    #[test]
    fn daylight_is_the_albedo_of_the_whole_model_for_each_channel() {
        let v = Direction::from_degrees(40.0, 0.0);
        let sky = Light::ambient([2.0, 1.0, 0.5]).unwrap().at([0.0; 3]);
        let matt = Lambert::new([0.1, 0.5, 0.9]).unwrap();
        let r = reflected_radiance(&matt, &sky, &v);
        for (r, e) in r.into_iter().zip([0.2, 0.5, 0.45]) {
            assert!((r - e).abs() < 1e-10);
        }
        // F(Θ)·a(Θ) instead is far off for gold's blue at 89°.
        let gold = Metal::named(20.0, crate::MetalName::Gold).unwrap();
        let c = Direction::from_degrees(89.0, 0.0).z;
        let whole = crate::directional_albedo_rgb(&gold, c)[2].value;
        let shape = crate::models::PModel::new(20.0, 1.0, crate::Energy::Published).unwrap();
        let product = gold.fresnel(c)[2] * crate::directional_albedo(&shape, c).value;
        assert!((whole - product).abs() > 0.1, "{whole} {product}");
    }
}
