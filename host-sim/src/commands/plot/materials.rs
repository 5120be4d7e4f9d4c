//! `microbrdf plot --material`.

use std::sync::Arc;

use microbrdf_reference::brdf::Channel;
use microbrdf_reference::figures::{Axis, Kind, Panel, Series, density, inverse, of_model};
use microbrdf_reference::models::PatchExponential;
use microbrdf_reference::{Brdf, Direction};
use microbrdf_scene::Material;
use rayon::prelude::*;

use super::label::label;
use crate::cli::{Curve, Plot};
use crate::drawing::{self, Format, Sheet, rounded_up};
use crate::exit::{Failure, Outcome};
use crate::progress::Progress;

type Model = Arc<dyn Brdf + Send + Sync>;

/// A curve to compute: its name, its colour, and what gives its points.
struct Task {
    name: String,
    colour: usize,
    points: Box<dyn Fn() -> Vec<(f64, f64)> + Send + Sync>,
}

/// Draws a quantity of materials.
pub fn run(arguments: &Plot) -> Outcome<()> {
    let Some(output) = &arguments.output else {
        return Err(Failure::Usage("needs -o, the file to write".to_owned()));
    };
    let format = Format::of(output, "-o")?;
    let incidences = incidences(arguments)?;
    let mut materials = Vec::new();
    for argument in &arguments.material {
        materials.push(Material::from_argument(argument)?);
    }
    let quantity = arguments.quantity;
    let tasks = match quantity {
        Curve::Density | Curve::Inverse => mixture(&materials, quantity)?,
        _ => directional(&materials, quantity, &incidences),
    };
    let progress = Progress::new("curves", tasks.len());
    let series: Vec<_> = tasks
        .par_iter()
        .map(|task| {
            let series = Series::new(&task.name, task.colour, (task.points)());
            progress.step();
            series
        })
        .collect();
    drop(progress);
    let sheet = Sheet {
        title: &title(quantity, &incidences),
        notes: &[],
        panels: &[panel(quantity, &incidences, series)],
    };
    drawing::write(&sheet, format, output)
}

fn incidences(arguments: &Plot) -> Outcome<Vec<f64>> {
    let lobes = matches!(arguments.quantity, Curve::Lobe | Curve::Radiance);
    if !lobes && !arguments.incidence.is_empty() {
        return Err(Failure::Usage(
            "--incidence: goes with --quantity lobe and radiance".to_owned(),
        ));
    }
    for angle in &arguments.incidence {
        // At 90° itself f is unbounded.
        if !(0.0..=89.99).contains(angle) {
            return Err(Failure::Usage(format!(
                "--incidence {angle}: must be numbers from 0 to 89.99, in degrees"
            )));
        }
    }
    if lobes && arguments.incidence.is_empty() {
        return Ok(vec![45.0]);
    }
    Ok(arguments.incidence.clone())
}

/// Albedo, lobe or radiance: a curve for each material, channel and incidence.
fn directional(materials: &[Material], quantity: Curve, incidences: &[f64]) -> Vec<Task> {
    let mut models: Vec<(String, usize, Model)> = Vec::new();
    for material in materials {
        let name = label(material);
        let next = models.len();
        if material.is_coloured() {
            // Of the first such material they are red, green and blue in the palette, too.
            let channels = [("red", 1), ("green", 2), ("blue", 0)];
            for (i, (channel, colour)) in channels.into_iter().enumerate() {
                let model = Channel(material.reference(), i);
                models.push((format!("{name}, {channel}"), next + colour, Arc::new(model)));
            }
        } else {
            models.push((name, next, material.reference().into()));
        }
    }
    let one = models.len() == 1;
    let angles = if quantity == Curve::Albedo {
        &[0.0]
    } else {
        incidences
    };
    let mut tasks = Vec::new();
    for (name, colour, model) in models {
        for (k, &incidence) in angles.iter().enumerate() {
            // Incidences of a single model have colours of their own; those of
            // several share the model's.
            let (name, colour) = match (one && angles.len() > 1, k) {
                (true, _) => (format!("Θ = {incidence}°"), k),
                (false, 0) => (name.clone(), colour),
                (false, _) => (String::new(), colour),
            };
            let model = model.clone();
            let points = Box::new(move || points(&*model, quantity, incidence));
            tasks.push(Task {
                name,
                colour,
                points,
            });
        }
    }
    tasks
}

fn points(model: &dyn Brdf, quantity: Curve, incidence: f64) -> Vec<(f64, f64)> {
    if quantity == Curve::Albedo {
        return of_model::albedo(model, 1e-3);
    }
    let l = Direction::from_degrees(incidence, 0.0);
    let height = [l.mirrored(), l, Direction::NORMAL]
        .iter()
        .map(|v| model.eval(&l, v))
        .fold(0.0, f64::max);
    if quantity == Curve::Lobe {
        of_model::lobe(model, incidence, 1e-3 * height)
    } else {
        of_model::radiance(model, incidence, 1e-3 * height * l.z)
    }
}

/// p(R) or its inverse: of mixtures alone.
fn mixture(materials: &[Material], quantity: Curve) -> Outcome<Vec<Task>> {
    let mut tasks = Vec::new();
    for (colour, material) in materials.iter().enumerate() {
        let Material::PatchExponential { sharpness } = material else {
            return Err(Failure::Usage(format!(
                "--material {}: only patch-exponential has a density p(R)",
                label(material)
            )));
        };
        let model = PatchExponential::new(*sharpness)
            .map_err(|error| Failure::Usage(format!("--material: {error}")))?;
        if *sharpness == 0.0 {
            return Err(Failure::Usage(
                "--material: sharpness 0 is Lambert, all of whose weight is at R = 2".to_owned(),
            ));
        }
        let curve = if quantity == Curve::Density {
            density
        } else {
            inverse
        };
        tasks.push(Task {
            name: label(material),
            colour,
            points: Box::new(move || curve(&model)),
        });
    }
    Ok(tasks)
}

fn title(quantity: Curve, incidences: &[f64]) -> String {
    let angles: Vec<_> = incidences.iter().map(|angle| format!("{angle}°")).collect();
    let at = format!("in the plane of incidence, light at {}", angles.join(", "));
    match quantity {
        Curve::Albedo => "Albedo".to_owned(),
        Curve::Lobe => format!("BRDF {at}"),
        Curve::Radiance => format!("Reflected radiance {at}, for unit normal irradiance"),
        Curve::Density => "Density p(R) of the patches' radius (4.47)".to_owned(),
        Curve::Inverse => "Inverse F⁻¹(r) of the distribution of the patches' radius".to_owned(),
    }
}

fn panel(quantity: Curve, incidences: &[f64], mut series: Vec<Series>) -> Panel {
    let greatest = series.iter().map(Series::greatest).fold(0.0, f64::max);
    let to = rounded_up(greatest);
    let view = || Axis::linear("viewing angle, mirror side positive [°]", -90.0, 90.0);
    match quantity {
        Curve::Albedo => Panel::cartesian(
            "",
            Axis::angle("angle of incidence Θ [°]"),
            Axis::linear("albedo a(Θ)", 0.0, to.max(1.1)),
            series,
        ),
        Curve::Lobe => {
            for &angle in incidences {
                let ray = vec![(-angle, to), (-angle, 0.0)];
                let name = if angle == incidences[0] { "light" } else { "" };
                series.push(Series::new(name, 7, ray).dashed());
            }
            Panel {
                kind: Kind::Polar,
                ..Panel::cartesian("", view(), Axis::linear("f(L, V) [1/sr]", 0.0, to), series)
            }
        }
        Curve::Radiance => Panel::cartesian(
            "",
            view(),
            Axis::linear("f(L, V) cosΘL [1/sr]", 0.0, to),
            series,
        ),
        Curve::Density => Panel::cartesian(
            "",
            Axis::linear("radius R", 0.0, 2.0),
            Axis::linear("p(R)", 0.0, to),
            series,
        ),
        Curve::Inverse => Panel::cartesian(
            "",
            Axis::linear("r", 0.0, 1.0),
            Axis::linear("radius R = F⁻¹(r)", 0.0, 2.2),
            series,
        ),
    }
}
