//! What is measured of a model for the documentation and the energy test.

use crate::albedo::directional_albedo_for;
use crate::brdf::Channel;
use crate::quadrature::{Accuracy, Estimate};
use crate::{Brdf, Direction};

/// A model's albedo where it is greatest, and near the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The greatest albedo of any channel, up to 89.9995°.
    pub greatest: Estimate,
    /// The angle of incidence in degrees at which it was found.
    pub degrees: f64,
    /// The azimuth of incidence in degrees.
    pub azimuth: f64,
    /// The albedo (luminance) at 89.9°, azimuth 0.
    pub grazing: Estimate,
}

/// Angles that are looked at before the search is refined.
const ANGLES: [f64; 18] = [
    0.0, 6.0, 12.0, 18.0, 24.0, 30.0, 37.0, 44.0, 52.0, 60.0, 68.0, 75.0, 81.0, 86.0, 89.0, 89.9,
    89.99, 89.9995,
];

/// Measures a model: every channel, a quarter of the azimuths, angles up to 89.9995°.
pub fn measure(model: &dyn Brdf) -> Measured {
    let channels = if model.is_coloured() { 3 } else { 1 };
    let azimuths: &[f64] = if model.is_isotropic() {
        &[0.0]
    } else {
        &[0.0, 45.0, 90.0]
    };
    // Enough for 1e-10 of every smooth model; tables and jumps get as far as they get, and
    // the estimates say how far.
    let accuracy = Accuracy {
        tolerance: 5e-11,
        outer_panels: 40,
        inner_panels: 20,
    };
    let mut best: Option<(Estimate, usize, f64, usize)> = None;
    let at = |channel: usize, degrees: f64, azimuth: f64| {
        let l = Direction::from_degrees(degrees, azimuth);
        directional_albedo_for(&Channel(model, channel), &l, accuracy)
    };
    for channel in 0..channels {
        for &azimuth in azimuths {
            for (i, &degrees) in ANGLES.iter().enumerate() {
                let a = at(channel, degrees, azimuth);
                // Beyond the estimated error: equal albedos count as the first one's.
                if best.is_none_or(|(b, ..)| a.value > b.value + a.error + b.error + 1e-12) {
                    best = Some((a, i, azimuth, channel));
                }
            }
        }
    }
    let (mut greatest, i, azimuth, channel) = best.expect("at least one angle");
    let mut degrees = ANGLES[i];
    // Golden-section search between the neighbours, if both exist.
    if i > 0 && i + 1 < ANGLES.len() {
        let ratio = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = (ANGLES[i - 1], ANGLES[i + 1]);
        for _ in 0..16 {
            let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
            if at(channel, a, azimuth).value > at(channel, b, azimuth).value {
                high = b;
            } else {
                low = a;
            }
        }
        let middle = 0.5 * (low + high);
        let a = at(channel, middle, azimuth);
        if a.value > greatest.value {
            (greatest, degrees) = (a, middle);
        }
    }
    let grazing = directional_albedo_for(model, &Direction::from_degrees(89.9, 0.0), accuracy);
    Measured {
        greatest,
        degrees,
        azimuth,
        grazing,
    }
}
