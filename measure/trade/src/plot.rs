//! Error against cycles, one sheet a core.

use microbrdf_reference::figures::{Axis, Panel, Series};
use microbrdf_sim::drawing::Sheet;

use crate::row::Row;

/// What is shown: a model with its parameters at K = 1, in the shading frame.
const SUBJECTS: [(&str, &str, &str); 3] = [
    ("metallic-phong", "exponent = 20", "metallic Phong, n = 20"),
    (
        "metallic-phong",
        "exponent = 5000",
        "metallic Phong, n = 5000",
    ),
    ("metal", "metal = \"gold\", exponent = 20", "gold, n = 20"),
];

/// Colours of a palette; then it begins anew.
const COLOURS: usize = 8;

/// The file of a core's plot, in `docs`.
#[must_use]
pub fn file(core: &str) -> String {
    format!("trade-{core}.svg")
}

/// A core's plot, as SVG.
#[must_use]
pub fn svg(rows: &[Row], core: &str) -> String {
    let estimate = rows.iter().any(|row| row.core == core && row.estimate);
    let kind = if estimate { "estimated" } else { "exact" };
    let panels: Vec<_> = SUBJECTS
        .into_iter()
        .map(|(model, parameters, title)| {
            let of_subject = rows.iter().filter(|row| {
                row.core == core
                    && row.model == model
                    && row.parameters == parameters
                    && row.exposure == "1"
                    && !row.variant.starts_with("world")
            });
            panel(title, of_subject, kind)
        })
        .collect();
    Sheet {
        title: &format!("Error against cycles on {core}, one evaluation at K = 1"),
        notes: &[
            "Greatest arithmetic error of the 8-bit sRGB code within the lobe; 0.5 is perfect \
             rounding. Dashed: the front that nothing beats in both. Made by cargo xtask measure."
                .to_owned(),
        ],
        panels: &panels,
    }
    .svg()
}

fn panel<'a>(title: &str, rows: impl Iterator<Item = &'a Row>, kind: &str) -> Panel {
    let points: Vec<_> = rows
        .filter_map(|row| {
            let name = format!("{}, {}", row.arithmetic, row.variant);
            Some((name, row.cycles_mean, row.lsb_error_max?))
        })
        .collect();
    let x = Axis::logarithmic(format!("cycles ({kind})"), 30.0, 40_000.0);
    let y = Axis::logarithmic("greatest error [LSB]", 0.4, 300.0);
    let mut series: Vec<_> = points
        .iter()
        .enumerate()
        .map(|(colour, (name, cycles, error))| {
            let shape = if colour < COLOURS { "◇" } else { "+" };
            let name = format!("{shape} {name}");
            Series::new(name, colour, mark(*cycles, *error, colour))
        })
        .collect();
    series.push(Series::new("front", 6, front(&points)).dashed());
    Panel::cartesian(title, x, y, series)
}

/// A mark about a point: a diamond, or a cross where the palette begins anew.
fn mark(x: f64, y: f64, index: usize) -> Vec<(f64, f64)> {
    // A decade of cycles is a third longer than one of errors.
    let (dx, dy) = (1.13, 1.17);
    if index < COLOURS {
        vec![
            (x / dx, y),
            (x, y * dy),
            (x * dx, y),
            (x, y / dy),
            (x / dx, y),
        ]
    } else {
        vec![(x / dx, y), (x * dx, y), (x, y), (x, y * dy), (x, y / dy)]
    }
}

/// The steps along what nothing beats in both.
fn front(points: &[(String, f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<_> = points.iter().map(|(_, x, y)| (*x, *y)).collect();
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    let mut steps: Vec<(f64, f64)> = Vec::new();
    for (x, y) in sorted {
        match steps.last() {
            Some(&(_, best)) if y >= best => {}
            Some(&(_, best)) => steps.extend([(x, best), (x, y)]),
            None => steps.push((x, y)),
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_leaves_out_what_is_beaten() {
        let point = |x, y| (String::new(), x, y);
        let points = [point(10.0, 5.0), point(20.0, 6.0), point(30.0, 1.0)];
        assert_eq!(front(&points), [(10.0, 5.0), (30.0, 5.0), (30.0, 1.0)]);
    }
}
