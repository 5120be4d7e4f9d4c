//! The names of curves, beside a diagram.

use microbrdf_reference::figures::Series;
use svg::node::element::Group;

use super::pen::{self, Anchor, SMALL};

const SAMPLE: f64 = 26.0;
const ROW: f64 = 19.0;

/// How wide a legend is, the distance from the diagram included.
pub fn width(series: &[Series]) -> f64 {
    let names = series.iter().map(|s| pen::width(&s.name, SMALL));
    names.fold(0.0, f64::max) + SAMPLE + 24.0
}

/// Names and samples, from the upper left corner down; nameless curves are left out.
pub fn draw(series: &[Series], (x, y): (f64, f64)) -> Group {
    let mut group = Group::new();
    let named = series.iter().filter(|s| !s.name.is_empty());
    for (i, series) in named.enumerate() {
        let middle = y + ROW * (i as f64 + 0.5);
        let ends = [(x, middle), (x + SAMPLE, middle)];
        let below = (x + SAMPLE + 6.0, middle + 0.35 * SMALL);
        group = group
            .add(pen::curve(
                ends.into_iter(),
                pen::colour(series.colour),
                series.dashed,
            ))
            .add(pen::text(&series.name, below, SMALL, Anchor::Start));
    }
    group
}
