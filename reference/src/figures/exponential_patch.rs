//! Figures 4.12 to 4.15: the exponential mixture of patches.

use super::specular_models::light;
use super::{Axis, Figure, Panel, Series, curve, of_model};
use crate::models::PatchExponential;
use crate::{Brdf as _, ParameterError};

/// Sharpnesses, which the thesis does not state for its figures; from its Table 4.1.
const SHARPNESSES: [f64; 7] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0];
const CHOSEN: &str = "The sharpnesses s are chosen here, from Table 4.1: the thesis does not state those of the figure.";

fn each(
    points: impl Fn(&PatchExponential) -> Vec<(f64, f64)>,
) -> Result<Vec<Series>, ParameterError> {
    let series = SHARPNESSES.into_iter().enumerate().map(|(i, s)| {
        let model = PatchExponential::new(s)?;
        Ok(Series::new(format!("s = {s}"), i, points(&model)))
    });
    series.collect()
}

/// Figure 4.12.
pub fn densities() -> Result<Figure, ParameterError> {
    Ok(Figure {
        number: "4.12",
        title: "Probability density p(R) (4.47) for different sharpnesses s",
        notes: vec![
            CHOSEN.to_owned(),
            "Its mass is 1 − a_Diffuse; the rest is a jump at R = 2, which a density can't show."
                .to_owned(),
        ],
        panels: vec![Panel::cartesian(
            "",
            Axis::linear("radius R", 0.0, 2.0),
            Axis::linear("p(R)", 0.0, 5.0),
            each(density)?,
        )],
    })
}

/// p(R) over R of 0 … 2.
pub fn density(model: &PatchExponential) -> Vec<(f64, f64)> {
    let top = 2.0 / model.sharpness().max(2.0);
    let mut breaks = vec![0.0, top, 1.0, 2.0];
    breaks.dedup();
    let height = model.density(top).max(model.density(1.0));
    curve(&breaks, 1e-3 * height, &mut |r| model.density(r))
}

/// Figure 4.13.
pub fn inverses() -> Result<Figure, ParameterError> {
    Ok(Figure {
        number: "4.13",
        title: "Inverse F⁻¹(r) of the probability distribution for different sharpnesses s",
        notes: vec![
            CHOSEN.to_owned(),
            "Beyond r = 1 − a_Diffuse it is 2, the Lambertian patch.".to_owned(),
        ],
        panels: vec![Panel::cartesian(
            "",
            Axis::linear("r", 0.0, 1.0),
            Axis::linear("radius R = F⁻¹(r)", 0.0, 2.2),
            each(inverse)?,
        )],
    })
}

/// F⁻¹(r) over r of 0 … 1.
pub fn inverse(model: &PatchExponential) -> Vec<(f64, f64)> {
    // At most 1: rounding can put it just above.
    let jump = model.cumulative(2.0).min(1.0);
    let mut breaks = vec![0.0, model.cumulative(1.0), jump, 1.0];
    breaks.dedup();
    curve(&breaks, 2e-3, &mut |r| model.inverse(r))
}

/// Figure 4.14.
pub fn albedos() -> Result<Figure, ParameterError> {
    Ok(Figure {
        number: "4.14",
        title: "Albedo of the exponential mixture (4.46) for different sharpnesses s",
        notes: vec![CHOSEN.to_owned()],
        panels: vec![Panel::cartesian(
            "",
            Axis::angle("angle of incidence Θ [°]"),
            Axis::linear("albedo a(Θ)", 0.0, 1.1),
            each(|model| of_model::albedo(model, 1e-3))?,
        )],
    })
}

/// Figure 4.15.
pub fn lobes() -> Result<Figure, ParameterError> {
    let panel = |incidence: f64| -> Result<Panel, ParameterError> {
        let mut series = each(|model| {
            let peak = model.peak();
            let mut points = of_model::lobe(model, incidence, 2e-3 * peak);
            points.iter_mut().for_each(|p| p.1 /= peak);
            points
        })?;
        series.push(light(incidence, 1.0));
        Ok(Panel::polar(
            format!("incidence {incidence}°"),
            Axis::linear("f(L, V) / C", 0.0, 1.0),
            series,
        ))
    };
    Ok(Figure {
        number: "4.15",
        title: "Lobes of the BRDF with exponential weights (4.46), f/C = exp(−s·m)",
        notes: vec![
            CHOSEN.to_owned(),
            "So are the angles of incidence. Cuts in the plane of incidence through what the \
             thesis may show in space."
                .to_owned(),
        ],
        panels: vec![panel(40.0)?, panel(80.0)?],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// C of (4.45).
    fn constant(s: f64) -> f64 {
        s * s / (TAU * (1.0 - (1.0 + s) * (-s).exp()))
    }

    #[test]
    fn densities_have_their_mass_and_their_top() {
        let figure = densities().unwrap();
        for (series, s) in figure.panels[0].series.iter().zip(SHARPNESSES) {
            let mass: f64 = (series.points.windows(2))
                .map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0))
                .sum();
            let diffuse = 0.5 * TAU * constant(s) * (-2.0 * s).exp();
            assert!((mass + diffuse - 1.0).abs() < 2e-3, "s = {s}: {mass}");
            let top = (series.points.iter())
                .max_by(|a, b| a.1.total_cmp(&b.1))
                .unwrap();
            let expected = if s > 2.0 { 2.0 / s } else { 1.0 };
            assert!((top.0 - expected).abs() < 1e-9, "s = {s}: {top:?}");
            assert!(top.1 <= figure.panels[0].y.to);
        }
    }

    #[test]
    fn inverses_end_at_two_and_begin_at_nought() {
        let figure = inverses().unwrap();
        for (series, s) in figure.panels[0].series.iter().zip(SHARPNESSES) {
            assert_eq!(series.points.last().unwrap(), &(1.0, 2.0));
            assert!(series.at(0.0).unwrap().abs() < 1e-3, "s = {s}");
            assert!(
                series.points.windows(2).all(|p| p[0].1 <= p[1].1),
                "s = {s}"
            );
            let model = PatchExponential::new(s).unwrap();
            let (r, radius) = series.points[series.points.len() / 3];
            if radius < 2.0 {
                assert!((model.cumulative(radius) - r).abs() < 1e-9, "s = {s}");
            }
        }
    }

    #[test]
    fn lobes_are_exponentials_of_the_metric() {
        let figure = lobes().unwrap();
        for (panel, incidence) in figure.panels.iter().zip([40.0f64, 80.0]) {
            for (series, s) in panel.series.iter().zip(SHARPNESSES) {
                assert!((series.at(incidence).unwrap() - 1.0).abs() < 1e-12);
                // At V = N, m is the sine of the incidence.
                let m = incidence.to_radians().sin();
                let normal = series.at(0.0).unwrap();
                assert!((normal - (-s * m).exp()).abs() < 3e-3, "s = {s}: {normal}");
            }
        }
    }

    #[test]
    fn albedos_are_one_at_the_normal_and_fall() {
        let figure = albedos().unwrap();
        for series in &figure.panels[0].series {
            assert!((series.at(0.0).unwrap() - 1.0).abs() < 1e-6);
            assert!(series.points.windows(2).all(|p| p[1].1 <= p[0].1 + 1e-6));
        }
    }
}
