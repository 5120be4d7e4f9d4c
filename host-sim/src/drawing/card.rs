//! The test card's sheet: labels as SVG, the panels' pixels one to one.

use svg::Document;
use svg::node::element::{Group, Rectangle};

use super::pen::{self, Anchor, FAMILY, INK, LARGE, MEDIUM, SMALL};
use super::png::rasterised;
use crate::chart::{Across, Band, HEIGHT, Panel, Plane, WIDTH, error_colour};
use crate::exit::{Failure, Outcome};
use crate::picture::Picture;

/// Pixels for each unit of the SVG.
const SCALE: usize = 2;
// All in pixels.
const LEFT: usize = 450;
const TOP: usize = 270;
const GAP: usize = 56;
const BETWEEN: usize = 66;
const MARGIN: usize = 32;

/// Left edge of a column of panels: value and error in each plane.
fn column(index: usize) -> usize {
    LEFT + index * (WIDTH + GAP)
}

/// Upper edge of a band.
fn row(index: usize) -> usize {
    TOP + index * (HEIGHT + BETWEEN)
}

/// A length in units of the SVG.
fn units(pixels: usize) -> f64 {
    pixels as f64 / SCALE as f64
}

/// What the errors' colours mean: an error within each, and its name.
const KEY: [(f64, &str); 6] = [
    (0.5, "to 0.5 LSB: perfect rounding"),
    (0.6, "to 0.6"),
    (0.75, "to 0.75"),
    (1.0, "to 1"),
    (2.0, "to 2"),
    (3.0, "above"),
];

/// The card of an arithmetic: for each band its panels in both planes.
///
/// # Errors
/// If the labels can't be drawn.
pub fn card(arithmetic: &str, exposure: f64, bands: &[(Band, [Panel; 2])]) -> Outcome<Picture> {
    let (width, height) = (column(4) - GAP + MARGIN, row(bands.len()));
    let mut group = Group::new().add(header(arithmetic, exposure));
    for (index, (band, panels)) in bands.iter().enumerate() {
        group = group.add(labels(band, panels, row(index)));
    }
    let document = Document::new()
        .set("width", units(width))
        .set("height", units(height))
        .set("font-family", FAMILY)
        .add(
            Rectangle::new()
                .set("width", units(width))
                .set("height", units(height))
                .set("fill", "white"),
        )
        .add(group.set("fill", INK));
    let mut sheet = rasterised(&document.to_string())
        .map_err(|reason| Failure::Incomplete(format!("the card's labels: {reason}")))?;
    for (index, (_, panels)) in bands.iter().enumerate() {
        for (plane, panel) in panels.iter().enumerate() {
            paste(&mut sheet, &panel.value, column(2 * plane), row(index));
            paste(&mut sheet, &panel.error, column(2 * plane + 1), row(index));
        }
    }
    Ok(sheet)
}

fn header(arithmetic: &str, exposure: f64) -> Group {
    let left = units(MARGIN);
    let mut group = Group::new()
        .add(pen::text(
            &format!("Test card of {arithmetic} at exposure K = {exposure}"),
            (left, 28.0),
            LARGE,
            Anchor::Start,
        ))
        .add(pen::text(
            "Each pixel is a pair of directions: across, how far V lies from R; down, the larger \
             cosine, from 1 to 1e-8 (16 rows a decade). The middle column is exactly the mirror \
             direction.",
            (left, 50.0),
            SMALL,
            Anchor::Start,
        ))
        .add(pen::text(
            "Arithmetic error of the sRGB code, against double precision at the same rounded \
             directions. Striped: no two directions are so far apart there. Dark blue: one lies \
             below the horizon.",
            (left, 67.0),
            SMALL,
            Anchor::Start,
        ));
    let mut x = left;
    for (error, name) in KEY {
        let [r, g, b] = error_colour(error);
        group = group
            .add(
                Rectangle::new()
                    .set("x", x)
                    .set("y", 79)
                    .set("width", 14)
                    .set("height", 12)
                    .set("fill", format!("rgb({r},{g},{b})")),
            )
            .add(pen::text(name, (x + 19.0, 89.0), SMALL, Anchor::Start));
        x += 40.0 + pen::width(name, SMALL);
    }
    let titles = ["value", "error"];
    for index in 0..4 {
        let plane = match Plane::ALL[index / 2] {
            Plane::Incidence => "in the plane of incidence (left: L lower, right: V lower)",
            Plane::Sideways => "sideways",
        };
        let middle = units(column(index) + WIDTH / 2);
        group = group.add(pen::text(
            titles[index % 2],
            (middle, units(TOP) - 7.0),
            MEDIUM,
            Anchor::Middle,
        ));
        if index % 2 == 0 {
            let middle = units(column(index) + WIDTH + GAP / 2);
            group = group.add(pen::text(
                plane,
                (middle, units(TOP) - 24.0),
                MEDIUM,
                Anchor::Middle,
            ));
        }
    }
    group
}

/// What stands about a band's panels.
fn labels(band: &Band, panels: &[Panel; 2], top: usize) -> Group {
    let mut group = Group::new().add(pen::text(
        band.label,
        (units(MARGIN), units(top) + 14.0),
        MEDIUM,
        Anchor::Start,
    ));
    let worst = panels
        .iter()
        .map(|panel| panel.worst.lsb)
        .fold(0.0, f64::max);
    let across = format!("across: {}", band.across.name());
    for (line, text) in [across, format!("at most {worst:.2} LSB")]
        .iter()
        .enumerate()
    {
        let y = units(top) + 31.0 + 16.0 * line as f64;
        group = group.add(pen::text(text, (units(MARGIN), y), SMALL, Anchor::Start));
    }
    for (row, name) in [(0, "1"), (64, "1e−4"), (128, "1e−8")] {
        let y = units(top + row) + 4.0;
        group = group.add(pen::text(name, (units(LEFT) - 5.0, y), SMALL, Anchor::End));
    }
    let reach = band.across.reach();
    let half = match band.across {
        Across::Radius(_) => WIDTH as f64 / 2.0 - 1.0,
        _ => (WIDTH / 2) as f64,
    };
    for index in 0..4 {
        for share in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            let x = (column(index) as f64 + (WIDTH / 2) as f64 + share * half) / SCALE as f64;
            let name = format!("{}", share * reach).replace('-', "−");
            let bottom = units(top + HEIGHT);
            group = group
                .add(pen::line((x, bottom), (x, bottom + 3.0), INK))
                .add(pen::text(&name, (x, bottom + 14.0), SMALL, Anchor::Middle));
        }
    }
    group
}

fn paste(sheet: &mut Picture, panel: &Picture, left: usize, top: usize) {
    for (y, line) in panel.pixels.chunks(panel.width).enumerate() {
        let from = (top + y) * sheet.width + left;
        sheet.pixels[from..from + panel.width].copy_from_slice(line);
    }
}
