//! Figures 2.7, 3.1 and 3.2: the new model's albedo and radiance, and the p-model.

use super::{Axis, Figure, Panel, Series, of_model};
use crate::models::{MetallicPhong, PModel, Phong};
use crate::{Brdf, Direction, Energy, ParameterError};

/// Exponents of the albedo curves, which the thesis does not state.
const EXPONENTS: [(f64, &str); 7] = [
    (1.0, "n = 1"),
    (2.0, "n = 2"),
    (5.0, "n = 5"),
    (20.0, "n = 20"),
    (100.0, "n = 100"),
    (1000.0, "n = 1000"),
    (1e5, "n = 100 000"),
];

const CHOSEN: &str = "The exponents of the albedo curves are chosen here: the thesis does not state \
    its own.";

fn albedo_panel(title: &str) -> Result<Panel, ParameterError> {
    let mut series = Vec::new();
    for (i, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
        let model = MetallicPhong::new(exponent, Energy::Published)?;
        series.push(Series::new(name, i, of_model::albedo(&model, 1e-3)));
    }
    Ok(Panel::cartesian(
        title,
        Axis::angle("angle of incidence Θ [°]"),
        Axis::linear("albedo a(Θ)", 0.0, 1.1),
        series,
    ))
}

/// Figure 2.7.
pub fn albedo_and_radiance() -> Result<Figure, ParameterError> {
    let model = MetallicPhong::new(100.0, Energy::Published)?;
    let series = [0.0, 20.0, 40.0, 60.0, 80.0]
        .into_iter()
        .enumerate()
        .map(|(i, incidence)| {
            let points = of_model::radiance(&model, incidence, 0.02);
            Series::new(format!("Θ = {incidence}°"), i, points)
        })
        .collect();
    Ok(Figure {
        number: "2.7",
        title: "Albedo of the new model (2.22) and its reflected radiance (n = 100)",
        notes: vec![
            CHOSEN.to_owned(),
            "So are the angles of incidence of the radiance, which is that in the plane of incidence."
                .to_owned(),
        ],
        panels: vec![
            albedo_panel("albedo")?,
            Panel::cartesian(
                "reflected radiance, n = 100",
                Axis::linear("viewing angle, mirror side positive [°]", -90.0, 90.0),
                Axis::linear("f(L, V) cosΘL [1/sr]", 0.0, 20.0),
                series,
            ),
        ],
    })
}

/// Figure 3.1.
pub fn albedos() -> Result<Figure, ParameterError> {
    Ok(Figure {
        number: "3.1",
        title: "Albedo of the new model (3.7) for different exponents",
        notes: vec![
            CHOSEN.to_owned(),
            "At 90° it is (n + 2)/(2n + 2) (3.27); for n = 1 it exceeds 1 by 2.9e-4 near 13°."
                .to_owned(),
        ],
        panels: vec![albedo_panel("")?],
    })
}

/// Figure 3.2.
pub fn ratio_to_phong() -> Result<Figure, ParameterError> {
    const EXPONENT: f64 = 20.0;
    let phong = Phong::new(EXPONENT)?;
    let mut series = Vec::new();
    for (i, p) in [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().enumerate() {
        let model = PModel::new(EXPONENT, p, Energy::Published)?;
        let ratio = |degrees: f64| {
            let l = Direction::from_degrees(degrees, 0.0);
            let v = l.mirrored();
            model.eval(&l, &v) / phong.eval(&l, &v)
        };
        let points = super::curve(&[0.0, 85.0], 0.01, &mut |degrees| ratio(degrees));
        series.push(Series::new(format!("p = {p}"), i, points));
    }
    Ok(Figure {
        number: "3.2",
        title: "Ratio of the p-model (3.12) to Phong for different viewing angles",
        notes: vec![
            "For V at the mirror direction, where Θmin is the viewing angle; elsewhere the ratio is \
             the one at Θmin. It does not depend on the exponent."
                .to_owned(),
            "The values of p are chosen here: the thesis does not state its own.".to_owned(),
        ],
        panels: vec![Panel::cartesian(
            "",
            Axis::angle("viewing angle ΘV [°]"),
            Axis::linear("p-model / Phong", 0.0, 12.0),
            series,
        )],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn albedos_end_at_their_closed_form() {
        let figure = albedos().unwrap();
        for ((n, _), series) in EXPONENTS.iter().zip(&figure.panels[0].series) {
            let grazing = series.at(90.0).unwrap();
            assert!(
                (grazing - (n + 2.0) / (2.0 * n + 2.0)).abs() < 1e-6,
                "n = {n}: {grazing}"
            );
            assert!((series.at(0.0).unwrap() - 1.0).abs() < 1e-6, "n = {n}");
        }
        // n = 1 exceeds 1 by 2.886e-4 at 12.9°, which is no point of the curve.
        let excess = figure.panels[0].series[0].greatest() - 1.0;
        assert!((2.5e-4..2.886e-4).contains(&excess), "{excess}");
    }

    #[test]
    fn the_radiance_at_the_mirror_is_the_same_at_every_incidence() {
        let figure = albedo_and_radiance().unwrap();
        let peak = 102.0 / std::f64::consts::TAU;
        for (series, incidence) in figure.panels[1]
            .series
            .iter()
            .zip([0.0, 20.0, 40.0, 60.0, 80.0])
        {
            let at = series.at(incidence).unwrap();
            assert!((at / peak - 1.0).abs() < 1e-9, "{incidence}: {at}");
        }
    }

    #[test]
    fn the_ratio_is_a_power_of_the_cosine() {
        let figure = ratio_to_phong().unwrap();
        for (series, p) in figure.panels[0]
            .series
            .iter()
            .zip([0.0, 0.25, 0.5, 0.75, 1.0])
        {
            let at_60 = series
                .points
                .iter()
                .find(|q| (q.0 - 60.0).abs() < 2.0)
                .unwrap();
            let expected = at_60.0.to_radians().cos().powf(-p);
            assert!((at_60.1 / expected - 1.0).abs() < 1e-12, "p = {p}");
        }
    }
}
