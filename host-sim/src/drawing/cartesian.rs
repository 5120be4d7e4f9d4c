//! A diagram of y over x.

use microbrdf_reference::figures::Panel;
use svg::node::element::{ClipPath, Definitions, Group};

use super::axis::{place, ticks};
use super::pen::{self, Anchor, FAINT, INK, MEDIUM, SMALL};

/// Room for the y axis's labels.
pub const LEFT: f64 = 70.0;
/// Room for the x axis's labels.
pub const BELOW: f64 = 52.0;

/// Draws the panel with the upper left corner of its frame at the origin; `id` must be
/// its own within the sheet.
pub fn draw(panel: &Panel, (width, height): (f64, f64), id: &str) -> Group {
    let mut group = Group::new();
    for tick in ticks(&panel.x, 7) {
        let x = tick.place * width;
        group = group
            .add(pen::line((x, 0.0), (x, height), FAINT))
            .add(pen::text(
                &tick.label,
                (x, height + 19.0),
                SMALL,
                Anchor::Middle,
            ));
    }
    for tick in ticks(&panel.y, 8) {
        let y = (1.0 - tick.place) * height;
        group = group
            .add(pen::line((0.0, y), (width, y), FAINT))
            .add(pen::text(&tick.label, (-7.0, y + 4.0), SMALL, Anchor::End));
    }
    let below = (0.5 * width, height + 42.0);
    // Turned about the origin, x runs upwards.
    let beside = (-0.5 * height, -LEFT + 18.0);
    group = group
        .add(pen::text(&panel.x.label, below, MEDIUM, Anchor::Middle))
        .add(
            pen::text(&panel.y.label, beside, MEDIUM, Anchor::Middle)
                .set("transform", "rotate(-90)"),
        );
    let clip = ClipPath::new()
        .set("id", id)
        .add(pen::frame((0.0, 0.0), width, height));
    let mut curves = Group::new().set("clip-path", format!("url(#{id})"));
    for series in &panel.series {
        let points = series.points.iter().map(|&(x, y)| {
            let (x, y) = (place(&panel.x, x), place(&panel.y, y));
            (x * width, (1.0 - y) * height)
        });
        curves = curves.add(pen::curve(
            points,
            pen::colour(series.colour),
            series.dashed,
        ));
    }
    group
        .add(Definitions::new().add(clip))
        .add(curves)
        .add(pen::frame((0.0, 0.0), width, height).set("stroke", INK))
}

#[cfg(test)]
mod tests {
    use super::*;
    use microbrdf_reference::figures::{Axis, Series};

    #[test]
    fn x_runs_to_the_right_and_y_upwards() {
        let points = vec![(2.0, 0.0), (4.0, 5.0), (6.0, 20.0)];
        let (x, y) = (Axis::linear("x", 2.0, 6.0), Axis::linear("y", 0.0, 20.0));
        let panel = Panel::cartesian("", x, y, vec![Series::new("s", 0, points)]);
        let svg = draw(&panel, (200.0, 100.0), "clip7").to_string();
        assert!(svg.contains(r#"points="0,100 100,75 200,0""#), "{svg}");
        assert!(svg.contains(r#"clip-path="url(#clip7)""#), "{svg}");
    }

    #[test]
    fn names_are_escaped() {
        let axis = || Axis::linear("a < b & c", 0.0, 1.0);
        let panel = Panel::cartesian("", axis(), axis(), Vec::new());
        let svg = draw(&panel, (200.0, 100.0), "c").to_string();
        assert!(svg.contains("a &lt; b &amp; c"), "{svg}");
    }
}
