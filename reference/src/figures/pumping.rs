//! Figures 2.3 to 2.6: albedo pumping-up of Phong and Blinn, n = 20.

use super::{Axis, Figure, Panel, Series, of_model};
use crate::models::{Blinn, Phong, PumpRule, Pumped};
use crate::{Brdf, ParameterError};

const EXPONENT: f64 = 20.0;
/// Steps, which the thesis does not state.
const STEPS: usize = 3;
/// Cells of the albedo tables: least albedos come out within 2e-4 (tested).
const CELLS: usize = 120;
/// Incidence of the radiance curves, in degrees.
const INCIDENCES: [f64; 3] = [0.0, 40.0, 80.0];

/// Models with the names of their curves.
type Models = Vec<(String, Box<dyn Brdf>)>;

/// Figure 2.3.
pub fn phong() -> Result<Figure, ParameterError> {
    uncontrolled(
        "2.3",
        "Albedo and reflected radiance of reciprocal Phong and its pumped-up versions (n = 20)",
        Phong::new(EXPONENT)?,
        6.0,
    )
}

/// Figure 2.4.
pub fn blinn() -> Result<Figure, ParameterError> {
    uncontrolled(
        "2.4",
        "Albedo and reflected radiance of reciprocal Blinn and its pumped-up versions (n = 20)",
        Blinn::new(EXPONENT)?,
        10.0,
    )
}

/// Figure 2.5.
pub fn phong_controlled() -> Result<Figure, ParameterError> {
    controlled(
        "2.5",
        "Controlled pumping-up of reciprocal Phong (n = 20)",
        Phong::new(EXPONENT)?,
        4.0,
    )
}

/// Figure 2.6.
pub fn blinn_controlled() -> Result<Figure, ParameterError> {
    let mut figure = controlled(
        "2.6",
        "Controlled pumping-up of reciprocal Blinn (n = 20)",
        Blinn::new(EXPONENT)?,
        1.5,
    )?;
    let same = "The curves of 1, 2 and 3 steps coincide to the eye.";
    figure.notes.push(same.to_owned());
    Ok(figure)
}

fn uncontrolled<B: Brdf + Copy + 'static>(
    number: &'static str,
    title: &'static str,
    base: B,
    brightest: f64,
) -> Result<Figure, ParameterError> {
    let mut notes = vec![chosen()];
    notes.push("g1 = max(a(L), a(V)) (2.20); step 0 is the model itself.".to_owned());
    let models = pumped(base, PumpRule::Full)?;
    Ok(figure(number, title, notes, &models, Vec::new(), brightest))
}

fn controlled<B: Brdf + Copy + 'static>(
    number: &'static str,
    title: &'static str,
    base: B,
    brightest: f64,
) -> Result<Figure, ParameterError> {
    let models = pumped(base, PumpRule::ControlledFloored)?;
    let literal = Pumped::with_cells(base, PumpRule::Controlled, STEPS, CELLS)?;
    let literal = Series::new("3 steps of (2.21) as it stands", 4, albedo(&literal)).dashed();
    let notes = vec![
        chosen(),
        "Solid: the product of all divisors is floored at max(NL, NV), which gives what the text \
         says of the iteration. (2.21) as it stands (dashed) tends to an albedo of 1 instead."
            .to_owned(),
    ];
    Ok(figure(
        number,
        title,
        notes,
        &models,
        vec![literal],
        brightest,
    ))
}

fn chosen() -> String {
    format!(
        "Chosen here, as the thesis does not state it: 0 to {STEPS} steps, incidence at 0°, 40° and 80° for \
         the radiance in the plane of incidence."
    )
}

/// The model itself, and after 1 … [`STEPS`] steps.
fn pumped<B: Brdf + Copy + 'static>(base: B, rule: PumpRule) -> Result<Models, ParameterError> {
    let mut models: Models = vec![("the model itself".to_owned(), Box::new(base))];
    for k in 1..=STEPS {
        let name = if k == 1 {
            "1 step".to_owned()
        } else {
            format!("{k} steps")
        };
        models.push((name, Box::new(Pumped::with_cells(base, rule, k, CELLS)?)));
    }
    Ok(models)
}

fn albedo(model: &dyn Brdf) -> Vec<(f64, f64)> {
    of_model::albedo(model, 1e-3)
}

fn figure(
    number: &'static str,
    title: &'static str,
    notes: Vec<String>,
    models: &Models,
    more: Vec<Series>,
    brightest: f64,
) -> Figure {
    let mut albedos: Vec<_> = (models.iter().enumerate())
        .map(|(i, (name, model))| Series::new(name, i, albedo(model.as_ref())))
        .collect();
    albedos.extend(more);
    let mut radiances = Vec::new();
    for (i, (name, model)) in models.iter().enumerate() {
        for (k, &incidence) in INCIDENCES.iter().enumerate() {
            let points = of_model::radiance(model, incidence, 2e-3 * brightest);
            radiances.push(Series::new(if k == 0 { name } else { "" }, i, points));
        }
    }
    Figure {
        number,
        title,
        notes,
        panels: vec![
            Panel::cartesian(
                "albedo",
                Axis::angle("angle of incidence Θ [°]"),
                Axis::linear("albedo a(Θ)", 0.0, 1.1),
                albedos,
            ),
            Panel::cartesian(
                "reflected radiance, incidence at 0°, 40° and 80°",
                Axis::linear("viewing angle, mirror side positive [°]", -90.0, 90.0),
                Axis::linear("f(L, V) cosΘL [1/sr]", 0.0, brightest),
                radiances,
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least(series: &Series) -> f64 {
        series
            .points
            .iter()
            .map(|p| p.1)
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn albedos_are_those_of_the_iteration_and_radiance_grows() {
        // Least albedos after 0 to 3 steps; last, where controlled, (2.21) as it stands.
        for (figure, expected) in [
            (phong(), vec![0.0881, 0.374_53, 0.595_32, 0.711_58]),
            (blinn(), vec![0.05, 0.1551, 0.2902, 0.403_09]),
            (
                phong_controlled(),
                vec![0.0881, 0.374_53, 0.4804, 0.5055, 0.711_58],
            ),
            (
                blinn_controlled(),
                vec![0.05, 0.105_29, 0.105_71, 0.105_71, 0.420_59],
            ),
        ] {
            let figure = figure.unwrap();
            let [albedo, radiance] = &figure.panels[..] else {
                panic!("two diagrams");
            };
            assert_eq!(albedo.series.len(), expected.len());
            for (series, expected) in albedo.series.iter().zip(expected) {
                let got = least(series);
                assert!(
                    (got - expected).abs() < 2e-4,
                    "{}, {}: {got} {expected}",
                    figure.number,
                    series.name
                );
            }
            assert_eq!(radiance.series.len(), (STEPS + 1) * INCIDENCES.len());
            let greatest = radiance.series.iter().map(Series::greatest);
            let greatest = greatest.fold(0.0, f64::max);
            assert!(
                greatest <= radiance.y.to && greatest > 0.5 * radiance.y.to,
                "{}: {greatest}",
                figure.number
            );
            let at_80 = |step: usize| radiance.series[3 * step + 2].greatest();
            assert!(at_80(1) > 1.5 * at_80(0), "{}", figure.number);
        }
    }
}
