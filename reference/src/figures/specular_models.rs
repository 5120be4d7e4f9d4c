//! Figures 2.1, 3.3 and 3.4: Phong, the new model, Cook–Torrance and Ward side by side.

use super::{Axis, Figure, Panel, Series, of_model};
use crate::fresnel::Index;
use crate::models::microfacet::{Attenuation, Distribution, Facet};
use crate::models::{CookTorrance, MetallicPhong, Phong, Ward};
use crate::{Brdf, Direction, Energy, ParameterError};

const WITHOUT_HE_TORRANCE: &str = "Without the He–Torrance curve of the thesis: its text names \
     that model and does not define it in full.";

/// Named models, each with its colour of the palette.
type Models = Vec<(&'static str, usize, Box<dyn Brdf>)>;

fn classics() -> Result<Models, ParameterError> {
    Ok(vec![
        ("Phong, n = 150", 0, Box::new(Phong::new(150.0)?)),
        (
            "Cook–Torrance, m = 0.1",
            2,
            Box::new(CookTorrance::beckmann(0.1)?),
        ),
        ("Ward, m = 0.1", 3, Box::new(Ward::new(0.1)?)),
    ])
}

/// Figure 2.1.
pub fn albedos_of_classics() -> Result<Figure, ParameterError> {
    Ok(albedos(
        "2.1",
        "Albedo of the Phong (n = 150), Cook–Torrance (m = 0.1) and Ward (m = 0.1) models, F = 1",
        &classics()?,
    ))
}

/// Figure 3.4.
pub fn albedos_with_the_new_model() -> Result<Figure, ParameterError> {
    let mut models = classics()?;
    let new = MetallicPhong::new(150.0, Energy::Published)?;
    models.insert(1, ("new model, n = 150", 1, Box::new(new)));
    Ok(albedos(
        "3.4",
        "Albedo of the Phong and new (n = 150), Cook–Torrance and Ward (m = 0.1) models, F = 1",
        &models,
    ))
}

fn albedos(number: &'static str, title: &'static str, models: &Models) -> Figure {
    let whole = |(name, colour, model): &(&str, usize, Box<dyn Brdf>)| {
        // Ward's albedo has no value at the horizon itself.
        let mut points = of_model::albedo(model, 1e-3);
        points.retain(|p| p.0 < 90.0 || p.1 < 10.0);
        Series::new(*name, *colour, points)
    };
    let near = |(name, colour, model): &(&str, usize, Box<dyn Brdf>)| {
        let points = of_model::albedo_near_the_horizon(model, 10.0, 1e-4, 1e-3);
        Series::new(*name, *colour, points)
    };
    Figure {
        number,
        title,
        notes: vec![
            WITHOUT_HE_TORRANCE.to_owned(),
            "The thesis says that Cook–Torrance diverges here, too. With the geometry factor \
             (2.10) it stays below 1 and tends to 1; Ward does diverge, within 0.01° of the horizon."
                .to_owned(),
            "The right-hand diagram is added: it shows what happens at the very horizon.".to_owned(),
        ],
        panels: vec![
            Panel::cartesian(
                "all angles",
                Axis::angle("angle of incidence Θ [°]"),
                Axis::linear("albedo a(Θ)", 0.0, 1.2),
                models.iter().map(whole).collect(),
            ),
            Panel::cartesian(
                "towards the horizon",
                Axis::logarithmic("elevation 90° − Θ [°]", 10.0, 1e-4),
                Axis::linear("albedo a(Θ)", 0.0, 4.0),
                models.iter().map(near).collect(),
            ),
        ],
    }
}

/// Figure 3.3.
pub fn lobes() -> Result<Figure, ParameterError> {
    const INCIDENCE: f64 = 42.0;
    let cook = CookTorrance::new(
        Distribution::beckmann(0.1)?,
        Attenuation::VCavity,
        Facet::Grey(Index::new(5.0, 0.0)?),
    )?;
    let new = MetallicPhong::new(20.0, Energy::Published)?;
    let models: Models = vec![
        ("Phong, n = 20", 0, Box::new(Phong::new(20.0)?)),
        ("new model, n = 20", 1, Box::new(new)),
        ("Cook–Torrance, m = 0.1, index 5", 2, Box::new(cook)),
    ];
    let mut series: Vec<_> = models
        .iter()
        .map(|(name, colour, model)| {
            let scale = 1.0 / model.eval(&Direction::NORMAL, &Direction::NORMAL);
            let mut points = of_model::lobe(model, INCIDENCE, 1e-3 / scale);
            points.iter_mut().for_each(|p| p.1 *= scale);
            Series::new(*name, *colour, points)
        })
        .collect();
    series.push(light(INCIDENCE, 2.0));
    Ok(Figure {
        number: "3.3",
        title: "Specular lobes at 42° of incidence: Phong and new model (n = 20), \
            Cook–Torrance (m = 0.1, index 5)",
        notes: vec![
            WITHOUT_HE_TORRANCE.to_owned(),
            "The thesis calibrates the models at perpendicular illumination and does not say how. \
             Here each is divided by its own f(N, N)."
                .to_owned(),
        ],
        panels: vec![Panel::polar(
            "",
            Axis::linear("f(L, V) / f(N, N)", 0.0, 2.0),
            series,
        )],
    })
}

/// A dashed line from the light to the surface.
pub(super) fn light(incidence: f64, radius: f64) -> Series {
    Series::new("light", 7, vec![(-incidence, radius), (-incidence, 0.0)]).dashed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::MetallicPhong;

    fn ends(panel: &Panel, name: &str) -> (f64, f64) {
        let series = panel.series.iter().find(|s| s.name.starts_with(name));
        let points = &series.expect("a curve of that name").points;
        (points[0].1, points[points.len() - 1].1)
    }

    #[test]
    fn ends_of_the_albedo_curves() {
        let figure = albedos_with_the_new_model().unwrap();
        let [whole, near] = &figure.panels[..] else {
            panic!("two diagrams");
        };
        let (normal, grazing) = ends(whole, "new model");
        assert!((normal - 1.0).abs() < 1e-6);
        assert!((grazing - MetallicPhong::grazing_albedo(150.0)).abs() < 1e-6);
        // Cook–Torrance tends to 1, Ward as 0.01096/√cosΘ beyond all bounds.
        assert!((ends(near, "Cook").1 - 1.0).abs() < 1e-4);
        // At 89.9° it is 0.99834 for m = 0.1.
        let cook = near.series.iter().find(|s| s.name.starts_with("Cook"));
        let at_89_9 = cook.and_then(|s| s.at(0.1)).unwrap();
        assert!((at_89_9 - 0.998_34).abs() < 2e-4, "{at_89_9}");
        let cosine = 1e-4f64.to_radians();
        assert!((ends(near, "Ward").1 * cosine.sqrt() / 0.010_96 - 1.0).abs() < 5e-3);
        assert!(ends(near, "Ward").1 > near.y.to, "it leaves the diagram");
        assert_eq!(albedos_of_classics().unwrap().panels[0].series.len(), 3);
    }

    #[test]
    fn lobes_are_calibrated_and_he_torrance_is_named_as_missing() {
        let figure = lobes().unwrap();
        let series = &figure.panels[0].series;
        let at = |i: usize| series[i].at(42.0).unwrap();
        assert!((at(0) - 1.0).abs() < 1e-9);
        assert!((at(1) - 1.0 / 42f64.to_radians().cos()).abs() < 1e-9);
        assert!(at(2) > 1.0 && at(2) < 2.0, "{}", at(2));
        assert!(figure.notes[0].contains("He–Torrance"));
        assert!(
            figure.panels[0]
                .series
                .iter()
                .all(|s| s.greatest() <= figure.panels[0].y.to)
        );
    }
}
