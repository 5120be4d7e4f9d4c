//! Figures 4.5 and 4.6: the albedo of the basic patch, and its mean.

use super::{Axis, Figure, Panel, Series, curve};
use crate::albedo::mean_of;
use crate::models::Patch;
use crate::{Direction, Estimate, ParameterError};

/// Radii of the albedo curves, which the thesis does not state.
const RADII: [f64; 8] = [0.1, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0];

/// Figure 4.5.
pub fn albedos() -> Result<Figure, ParameterError> {
    let mut series = Vec::new();
    for (i, radius) in RADII.into_iter().enumerate() {
        let patch = Patch::new(radius)?;
        let points = curve(&[0.0, 90.0], 1e-3, &mut |degrees| {
            patch.exact_albedo(Direction::from_degrees(degrees, 0.0).z)
        });
        series.push(Series::new(format!("R = {radius}"), i, points));
    }
    Ok(Figure {
        number: "4.5",
        title: "Albedo of the basic BRDF (4.8) for different radii R",
        notes: vec![
            "The radii are chosen here: the thesis does not state its own. The least albedo of \
             all, 2/3 − √3/(2π) = 0.391, is at 90° for R = 1."
                .to_owned(),
        ],
        panels: vec![Panel::cartesian(
            "",
            Axis::angle("angle of incidence Θ [°]"),
            Axis::linear("albedo a(Θ)", 0.0, 1.1),
            series,
        )],
    })
}

/// Figure 4.6.
pub fn mean_albedo() -> Result<Figure, ParameterError> {
    let mean = |radius: f64| match Patch::new(radius) {
        Ok(patch) => {
            let albedo = |c: f64| Estimate::exact(patch.exact_albedo(c));
            mean_of(&albedo, radius, 1e-7).value
        }
        // R = 0 is a mirror.
        Err(_) => 1.0,
    };
    let points = curve(&[0.0, 1.0, 2.0], 5e-4, &mut |radius| mean(radius));
    Ok(Figure {
        number: "4.6",
        title: "Mean albedo of the basic BRDF (4.11) over the radius R",
        notes: vec!["Least at R = 1: 1 − 3√3/(4π) = 0.5865.".to_owned()],
        panels: vec![Panel::cartesian(
            "",
            Axis::linear("radius R", 0.0, 2.0),
            Axis::linear("mean albedo", 0.0, 1.1),
            vec![Series::new("mean albedo", 0, points)],
        )],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_least_albedo_is_at_the_horizon_for_radius_one() {
        let figure = albedos().unwrap();
        let grazing = |s: &Series| s.at(90.0).unwrap();
        let bound = 2.0 / 3.0 - 3f64.sqrt() / (2.0 * PI);
        for (series, radius) in figure.panels[0].series.iter().zip(RADII) {
            assert!((series.at(0.0).unwrap() - 1.0).abs() < 1e-12);
            let a = grazing(series);
            assert!(
                if radius == 1.0 {
                    (a - bound).abs() < 1e-12
                } else {
                    a > bound
                },
                "{radius}"
            );
        }
    }

    #[test]
    fn the_mean_albedo_is_that_of_two_random_points_of_a_disc() {
        // The mean albedo is the chance that two points of a disc, both drawn
        // uniformly, lie within R of each other, over min(1, R²): disc line picking.
        let figure = mean_albedo().unwrap();
        for &(r, a) in &figure.panels[0].series[0].points {
            if r == 0.0 {
                assert_eq!(a, 1.0);
                continue;
            }
            let chance = 1.0 + 2.0 / PI * (r * r - 1.0) * (0.5 * r).acos()
                - r / PI * (1.0 + 0.5 * r * r) * (1.0 - 0.25 * r * r).sqrt();
            let exact = chance / (r * r).min(1.0);
            assert!((a - exact).abs() < 2e-6, "R = {r}: {a} {exact}");
        }
    }
}
