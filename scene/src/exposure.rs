//! Exposure by a grey sphere, as in the thesis' material editor (3.6).

use std::f64::consts::FRAC_1_PI;

use microbrdf_reference::Direction;
use microbrdf_reference::light::{Attenuation, Illumination, Light};

use crate::description::{Description, LightDescription, LightKind};
use crate::vector::{dot, length, sub};

/// Albedo of the sphere.
const ALBEDO: f64 = 0.5;
/// Relative luminance of L* = 50: ((50 + 16)/116)³.
const MIDDLE: f64 = (66.0 / 116.0) * (66.0 / 116.0) * (66.0 / 116.0);
/// Points across the sphere's disc.
const ACROSS: usize = 512;

impl Description {
    /// The exposure at which a matt sphere of albedo 0.5 comes out at
    /// L* = 50, the median over its visible disc, under the scene's own lights
    /// and sky. The sphere stands where the camera looks and is small beside
    /// the distance to any lamp. `None` where that median is black.
    #[must_use]
    pub fn grey_sphere_exposure(&self) -> Option<f64> {
        let target = self.camera.target;
        let ahead = sub(target, self.camera.eye);
        let back = ahead.map(|c| -c / length(ahead));
        let beams: Vec<_> = self
            .lights
            .iter()
            .filter_map(|light| match light.reference().at(target) {
                Illumination::Beam {
                    to_light: Direction { x, y, z },
                    normal_irradiance,
                } => Some(([x, y, z], luminance(normal_irradiance))),
                Illumination::Uniform { .. } => None,
            })
            .collect();
        let sky = self.daylight.map_or(0.0, luminance);
        let [right, up] = crate::prepare::plane_axes(back);
        let coordinate = |i: usize| (2 * i + 1) as f64 / ACROSS as f64 - 1.0;
        let mut radiances = Vec::with_capacity(ACROSS * ACROSS);
        for i in 0..ACROSS * ACROSS {
            let (x, y) = (coordinate(i % ACROSS), coordinate(i / ACROSS));
            let rest = 1.0 - x * x - y * y;
            if rest < 0.0 {
                continue;
            }
            let z = rest.sqrt();
            let normal = [0, 1, 2].map(|i| x * right[i] + y * up[i] + z * back[i]);
            let irradiance = beams
                .iter()
                .map(|(to_light, irradiance)| irradiance * dot(normal, *to_light).max(0.0))
                .sum::<f64>();
            radiances.push(ALBEDO * (sky + FRAC_1_PI * irradiance));
        }
        let middle = radiances.len() / 2;
        let (_, median, _) = radiances.select_nth_unstable_by(middle, f64::total_cmp);
        (*median > 0.0).then(|| MIDDLE / *median)
    }
}

impl LightDescription {
    /// The reference's light.
    ///
    /// # Panics
    /// Never: the ranges were checked when the scene was read.
    #[must_use]
    pub fn reference(&self) -> Light {
        const CHECKED: &str = "the ranges were checked when the scene was read";
        let direction = |[x, y, z]: [f64; 3]| Direction::new(x, y, z);
        let attenuation = Attenuation::InverseSquare;
        match self.kind {
            LightKind::Directional {
                direction: to_light,
            } => Light::directional(direction(to_light), self.color),
            LightKind::Point { position, .. } => Light::point(position, self.color, attenuation),
            LightKind::Flood {
                position,
                axis,
                exponent,
                ..
            } => Light::flood(position, self.color, attenuation, direction(axis), exponent),
        }
        .expect(CHECKED)
    }
}

/// Relative luminance of linear sRGB.
fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
