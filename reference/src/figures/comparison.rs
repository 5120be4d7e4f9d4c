//! Figures 3.5 and 3.6: Phong and the new model, n = 100, at three angles of incidence.

use super::{Axis, Figure, Panel, Series, of_model};
use crate::models::{MetallicPhong, Phong};
use crate::{Brdf, Direction, Energy, ParameterError};

const EXPONENT: f64 = 100.0;
/// Incidence in degrees, as the text gives it.
const INCIDENCES: [f64; 3] = [0.0, 40.0, 80.0];

/// Figure 3.5.
pub fn brdfs() -> Result<Figure, ParameterError> {
    let series = both(|model, incidence| {
        let scale = 1.0 / model.eval(&Direction::NORMAL, &Direction::NORMAL);
        let mut points = of_model::lobe(model, incidence, 5e-3 / scale);
        points.iter_mut().for_each(|p| p.1 *= scale);
        points
    })?;
    Ok(Figure {
        number: "3.5",
        title: "BRDFs of Phong and the new model (n = 100) at 0°, 40° and 80° of incidence",
        notes: vec!["Divided by f(N, N), as in the thesis; in the plane of incidence.".to_owned()],
        panels: vec![panel("f(L, V) / f(N, N)", 6.0, series)],
    })
}

/// Figure 3.6.
pub fn radiances() -> Result<Figure, ParameterError> {
    let series = both(|model, incidence| of_model::radiance(model, incidence, 0.02))?;
    Ok(Figure {
        number: "3.6",
        title: "Radiance that Phong and the new model (n = 100) reflect, incidence 0°, 40° and 80°",
        notes: vec![
            "In the plane of incidence, for unit normal irradiance. The thesis' text gives the \
             angles for figure 3.5 and none for this one: the same are taken."
                .to_owned(),
        ],
        panels: vec![panel("f(L, V) cosΘL [1/sr]", 20.0, series)],
    })
}

fn both(points: impl Fn(&dyn Brdf, f64) -> Vec<(f64, f64)>) -> Result<Vec<Series>, ParameterError> {
    let phong = Phong::new(EXPONENT)?;
    let new = MetallicPhong::new(EXPONENT, Energy::Published)?;
    let models: [(&str, usize, &dyn Brdf); 2] = [("new model", 1, &new), ("Phong", 0, &phong)];
    let mut series = Vec::new();
    for (name, colour, model) in models {
        for (k, incidence) in INCIDENCES.into_iter().enumerate() {
            let name = if k == 0 { name } else { "" };
            series.push(Series::new(name, colour, points(model, incidence)));
        }
    }
    // At 0° both are the same: dashes let the other show.
    Ok(series
        .into_iter()
        .map(|s| if s.colour == 0 { s.dashed() } else { s })
        .collect())
}

fn panel(y: &str, to: f64, series: Vec<Series>) -> Panel {
    Panel::cartesian(
        "",
        Axis::linear("viewing angle, mirror side positive [°]", -90.0, 90.0),
        Axis::linear(y, 0.0, to),
        series,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_at_the_mirror_direction() {
        let (brdf, radiance) = (brdfs().unwrap(), radiances().unwrap());
        let peak = (EXPONENT + 2.0) / std::f64::consts::TAU;
        for (k, incidence) in INCIDENCES.into_iter().enumerate() {
            let cosine = incidence.to_radians().cos();
            let at = |figure: &Figure, i: usize| figure.panels[0].series[i].at(incidence).unwrap();
            assert!((at(&brdf, k) * cosine - 1.0).abs() < 1e-9);
            assert!((at(&brdf, 3 + k) - 1.0).abs() < 1e-9);
            assert!((at(&radiance, k) / peak - 1.0).abs() < 1e-9);
            assert!((at(&radiance, 3 + k) / (peak * cosine) - 1.0).abs() < 1e-9);
        }
    }
}
