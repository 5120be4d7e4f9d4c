//! Directional and mean albedo by deterministic quadrature.

use crate::brdf::Channel;
use crate::quadrature::{Accuracy, Estimate, adaptive, hemisphere, hemisphere_all};
use crate::{Brdf, Direction};

/// The albedo a(L) (3.2) at the given cosine of the angle of incidence, 0 … 1,
/// in the plane y = 0, aimed at an error of 1e-11; Dirac part included.
///
/// Of a coloured model it is the luminance: see [`directional_albedo_rgb`].
pub fn directional_albedo<B: Brdf + ?Sized>(brdf: &B, cos_theta: f64) -> Estimate {
    directional_albedo_for(
        brdf,
        &Direction::from_cosine(cos_theta, 0.0),
        Accuracy::FINE,
    )
}

/// The albedo at an angle of incidence in degrees, 0 … 90; 90 is exactly the horizon.
pub fn directional_albedo_at<B: Brdf + ?Sized>(brdf: &B, degrees: f64) -> Estimate {
    directional_albedo_for(brdf, &Direction::from_degrees(degrees, 0.0), Accuracy::FINE)
}

/// The albedo for each channel.
pub fn directional_albedo_rgb<B: Brdf + ?Sized>(brdf: &B, cos_theta: f64) -> [Estimate; 3] {
    let l = Direction::from_cosine(cos_theta, 0.0);
    directional_albedo_rgb_for(brdf, &l, Accuracy::FINE)
}

/// The albedo for each channel, for any direction L, to any accuracy: one integral over
/// panels that suit all of them.
pub fn directional_albedo_rgb_for<B: Brdf + ?Sized>(
    brdf: &B,
    l: &Direction,
    accuracy: Accuracy,
) -> [Estimate; 3] {
    if !brdf.is_coloured() {
        return [directional_albedo_for(brdf, l, accuracy); 3];
    }
    let rest = hemisphere_all(
        l,
        &brdf.chart(l),
        brdf.is_isotropic(),
        accuracy,
        &|v, out| brdf.creases(l, v, out),
        &|v| brdf.eval_rgb(l, v),
    );
    let delta = brdf.delta_weight(l);
    [0, 1, 2].map(|i| {
        let (value, error) = (rest.values[i], rest.error);
        Estimate { value, error } + Estimate::exact(delta[i])
    })
}

/// The albedo for any direction L, to any accuracy.
pub fn directional_albedo_for<B: Brdf + ?Sized>(
    brdf: &B,
    l: &Direction,
    accuracy: Accuracy,
) -> Estimate {
    let chart = brdf.chart(l);
    let delta = crate::brdf::luminance(brdf.delta_weight(l));
    let rest = hemisphere(
        l,
        &chart,
        brdf.is_isotropic(),
        accuracy,
        &|v, out| brdf.creases(l, v, out),
        &|v| brdf.eval(l, v),
    );
    if delta == 0.0 {
        rest
    } else {
        rest + Estimate::exact(delta)
    }
}

/// The mean albedo (3.37), 2∫a(cosΘ) cosΘ dcosΘ, of an isotropic model.
pub fn mean_albedo<B: Brdf + ?Sized>(brdf: &B) -> Estimate {
    mean_albedo_to(brdf, 1e-9)
}

/// The mean albedo with the given absolute error aimed at (at least 1e-10).
pub fn mean_albedo_to<B: Brdf + ?Sized>(brdf: &B, tolerance: f64) -> Estimate {
    let accuracy = Accuracy {
        tolerance: (0.02 * tolerance).max(1e-12),
        ..Accuracy::FINE
    };
    let width = brdf.chart(&Direction::NORMAL).scale;
    mean_of(
        &|c| directional_albedo_for(brdf, &Direction::from_cosine(c, 0.0), accuracy),
        width,
        tolerance,
    )
}

/// The mean albedo for each channel.
pub fn mean_albedo_rgb<B: Brdf + ?Sized>(brdf: &B) -> [Estimate; 3] {
    if !brdf.is_coloured() {
        return [mean_albedo(brdf); 3];
    }
    [0, 1, 2].map(|i| mean_albedo(&Channel(brdf, i)))
}

/// 2∫a(c) c dc over 0 … 1, where a changes over a width `width` (0 … 1) above c = 0.
pub(crate) fn mean_of(albedo: &dyn Fn(f64) -> Estimate, width: f64, tolerance: f64) -> Estimate {
    let w = width.clamp(1e-9, 1.0);
    adaptive(
        &mut |q| {
            // c runs from 0 to 1 with half of the variable spent below `w`.
            let r = 1.0 + w - q;
            let c = (w * q / r).min(1.0);
            let slope = w * (1.0 + w) / (r * r);
            albedo(c).scaled(2.0 * c * slope)
        },
        &[0.0, 0.5, 1.0],
        tolerance,
        60,
    )
}

/// The cosine in 0 … 1 at which `albedo` is greatest, and its value there.
///
/// A scan by half degrees, then golden-section search around the best.
pub fn greatest(albedo: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let at = |degrees: f64| albedo(Direction::from_degrees(degrees, 0.0).z);
    let step = 0.5;
    let (mut best, mut value) = (0.0, at(0.0));
    for i in 1..=180 {
        let degrees = step * f64::from(i);
        let a = at(degrees);
        if a > value {
            (best, value) = (degrees, a);
        }
    }
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = ((best - step).max(0.0), (best + step).min(90.0));
    for _ in 0..40 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        if at(a) > at(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let middle = 0.5 * (low + high);
    let refined = at(middle);
    if refined > value {
        (best, value) = (middle, refined);
    }
    (Direction::from_degrees(best, 0.0).z, value)
}

/// The direction of incidence at which a model's albedo is greatest, and the albedo there.
///
/// A scan of the quarter between the axes (one azimuth for isotropic models), then
/// golden-section search over the angle. Of a coloured model the luminance counts.
pub fn greatest_albedo<B: Brdf + ?Sized>(brdf: &B) -> (Direction, Estimate) {
    let azimuths: &[f64] = if brdf.is_isotropic() {
        &[0.0]
    } else {
        &[0.0, 30.0, 60.0, 90.0]
    };
    let at = |degrees: f64, phi: f64, accuracy: Accuracy| {
        directional_albedo_for(brdf, &Direction::from_degrees(degrees, phi), accuracy)
    };
    let mut best = (0.0, 0.0, at(0.0, 0.0, Accuracy::COARSE).value);
    const STEP: f64 = 3.0;
    for &phi in azimuths {
        for i in 1..=30 {
            let degrees = STEP * f64::from(i);
            let a = at(degrees, phi, Accuracy::COARSE).value;
            if a > best.2 + 1e-9 {
                best = (degrees, phi, a);
            }
        }
    }
    let phi = best.1;
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = ((best.0 - STEP).max(0.0), (best.0 + STEP).min(90.0));
    for _ in 0..24 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        if at(a, phi, Accuracy::FINE).value > at(b, phi, Accuracy::FINE).value {
            high = b;
        } else {
            low = a;
        }
    }
    let candidates = [best.0, 0.5 * (low + high), 90.0, 0.0];
    candidates
        .into_iter()
        .map(|degrees| {
            (
                Direction::from_degrees(degrees, phi),
                at(degrees, phi, Accuracy::FINE),
            )
        })
        .max_by(|a, b| a.1.value.total_cmp(&b.1.value))
        .expect("four candidates")
}

/// The greatest constant by which a model may be multiplied and still conserve energy:
/// 1 over its greatest albedo.
pub fn greatest_constant<B: Brdf + ?Sized>(brdf: &B) -> f64 {
    1.0 / greatest_albedo(brdf).1.value
}
