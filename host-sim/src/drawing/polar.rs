//! A lobe diagram: a half disc over the surface, angles from the normal.

use microbrdf_reference::figures::Panel;
use svg::node::element::{ClipPath, Definitions, Group, Path, path::Data};

use super::axis::{place, ticks};
use super::pen::{self, Anchor, FAINT, INK, MEDIUM, SMALL};

/// Draws the panel into a box of twice its height, its upper left corner at the
/// origin; `id` must be its own within the sheet.
pub fn draw(panel: &Panel, (width, height): (f64, f64), id: &str) -> Group {
    let greatest = (0.5 * width - 20.0).min(height - 20.0);
    let centre = (0.5 * width, height);
    let at = |degrees: f64, share: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let r = share * greatest;
        (centre.0 + r * sine, centre.1 - r * cosine)
    };
    let mut group = Group::new();
    for degrees in (-90..=90).step_by(15).map(f64::from) {
        group = group.add(pen::line(centre, at(degrees, 1.0), FAINT));
        if degrees % 30.0 == 0.0 {
            let label = format!("{degrees}°").replace('-', "−");
            let anchor = match degrees {
                d if d < 0.0 => Anchor::End,
                0.0 => Anchor::Middle,
                _ => Anchor::Start,
            };
            let (x, y) = at(degrees, 1.0 + 6.0 / greatest);
            group = group.add(pen::text(&label, (x, y + 2.0), SMALL, anchor));
        }
    }
    for tick in ticks(&panel.y, 5) {
        let (x, y) = at(90.0, tick.place);
        group = group
            .add(half_circle(centre, tick.place * greatest).set("stroke", FAINT))
            .add(pen::text(&tick.label, (x, y + 17.0), SMALL, Anchor::Middle));
    }
    let below = (centre.0 + 0.5 * greatest, height + 38.0);
    let clip = half_circle(centre, greatest);
    let clip = ClipPath::new().set("id", id).add(clip);
    let mut curves = Group::new().set("clip-path", format!("url(#{id})"));
    for series in &panel.series {
        let points = rounded(&series.points)
            .into_iter()
            .map(|(degrees, r)| at(degrees, place(&panel.y, r)));
        curves = curves.add(pen::curve(
            points,
            pen::colour(series.colour),
            series.dashed,
        ));
    }
    group
        .add(Definitions::new().add(clip))
        .add(curves)
        .add(half_circle(centre, greatest).set("stroke", INK))
        .add(pen::line(at(-90.0, 1.0), at(90.0, 1.0), INK))
        .add(pen::text(&panel.y.label, below, MEDIUM, Anchor::Middle))
}

/// The points with others between them, so that what joins them looks round: a
/// straight step in angle and radius is an arc here.
fn rounded(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut all = points.get(..1).unwrap_or_default().to_vec();
    for pair in points.windows(2) {
        let ((from, a), (to, b)) = (pair[0], pair[1]);
        let parts = (to - from).abs().ceil().max(1.0);
        all.extend((1..=parts as usize).map(|i| {
            let t = i as f64 / parts;
            (from + t * (to - from), a + t * (b - a))
        }));
    }
    all
}

fn half_circle((x, y): (f64, f64), radius: f64) -> Path {
    let data = Data::new().move_to((x - radius, y)).elliptical_arc_to((
        radius,
        radius,
        0,
        0,
        1,
        x + radius,
        y,
    ));
    Path::new().set("d", data).set("fill", "none")
}

#[cfg(test)]
mod tests {
    use super::*;
    use microbrdf_reference::figures::{Axis, Series};

    #[test]
    fn the_normal_is_up_and_the_mirror_side_on_the_right() {
        let ray = |degrees| Series::new("ray", 0, vec![(degrees, 0.0), (degrees, 5.0)]);
        let radius = Axis::linear("r", 0.0, 10.0);
        let panel = Panel::polar("", radius, [0.0, 90.0, -90.0].map(ray).to_vec());
        // The disc has a radius of 200 about (220, 220).
        let svg = draw(&panel, (440.0, 220.0), "c").to_string();
        for points in ["220,220 220,120", "220,220 320,220", "220,220 120,220"] {
            assert!(
                svg.contains(&format!(r#"points="{points}""#)),
                "{points}: {svg}"
            );
        }
    }

    #[test]
    fn steps_over_angles_are_arcs() {
        let points = rounded(&[(0.0, 1.0), (10.0, 2.0), (10.0, 3.0)]);
        assert_eq!(points.len(), 12);
        assert_eq!(points[5], (5.0, 1.5));
        assert_eq!(points[10..], [(10.0, 2.0), (10.0, 3.0)]);
        assert!(rounded(&[]).is_empty());
    }
}
