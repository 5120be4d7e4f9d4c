//! A sheet: title, diagrams side by side, notes.

use microbrdf_reference::figures::{Kind, Panel};
use svg::Document;
use svg::node::element::{Group, Rectangle};

use super::cartesian::{BELOW, LEFT};
use super::pen::{Anchor, FAMILY, INK, LARGE, MEDIUM, SMALL, text, wrapped};
use super::{cartesian, legend, polar};

const MARGIN: f64 = 16.0;
const TITLE: f64 = 24.0;
const PANEL_TITLE: f64 = 26.0;
const NOTE: f64 = 17.0;

/// What is drawn.
#[derive(Debug)]
pub struct Sheet<'a> {
    /// Above everything.
    pub title: &'a str,
    /// Below everything, broken into lines.
    pub notes: &'a [String],
    /// From left to right.
    pub panels: &'a [Panel],
}

/// Width and height of a diagram's frame.
fn size(panel: &Panel, panels: usize) -> (f64, f64) {
    match (panel.kind, panels) {
        (Kind::Cartesian, 1) => (620.0, 420.0),
        (Kind::Cartesian, _) => (460.0, 380.0),
        (Kind::Polar, 1) => (760.0, 390.0),
        (Kind::Polar, _) => (560.0, 290.0),
    }
}

impl Sheet<'_> {
    /// The sheet as SVG; the same sheet gives the same text.
    #[must_use]
    pub fn svg(&self) -> String {
        let width = self.width();
        let inner = width - 2.0 * MARGIN;
        let mut drawn = Group::new();
        let mut top = MARGIN;
        for line in wrapped(self.title, LARGE, inner) {
            top += TITLE;
            drawn = drawn.add(text(&line, (MARGIN, top - 12.0), LARGE, Anchor::Start));
        }
        let titled = self.panels.iter().any(|panel| !panel.title.is_empty());
        top += if titled { PANEL_TITLE } else { 0.5 * MARGIN };
        let mut x = MARGIN;
        let mut bottom: f64 = top;
        for (i, panel) in self.panels.iter().enumerate() {
            let (width, height) = size(panel, self.panels.len());
            let id = format!("clip{i}");
            let left = left(panel);
            let diagram = match panel.kind {
                Kind::Cartesian => cartesian::draw(panel, (width, height), &id),
                Kind::Polar => polar::draw(panel, (width, height), &id),
            };
            let title = (0.5 * width, -10.0);
            let beside = (width + 14.0, 0.0);
            let placed = Group::new()
                .set("transform", format!("translate({},{top})", x + left))
                .add(diagram)
                .add(text(&panel.title, title, MEDIUM, Anchor::Middle))
                .add(legend::draw(&panel.series, beside));
            drawn = drawn.add(placed);
            x += left + width + legend::width(&panel.series) + MARGIN;
            bottom = bottom.max(top + height + BELOW);
        }
        for note in self.notes {
            for line in wrapped(note, SMALL, inner) {
                bottom += NOTE;
                drawn = drawn.add(text(&line, (MARGIN, bottom), SMALL, Anchor::Start));
            }
        }
        let height = (bottom + MARGIN).ceil();
        let paper = Rectangle::new()
            .set("width", width)
            .set("height", height)
            .set("fill", "white");
        Document::new()
            .set("width", width)
            .set("height", height)
            .set("viewBox", (0, 0, width, height))
            .set("font-family", FAMILY)
            .add(paper)
            .add(drawn.set("fill", INK))
            .to_string()
    }

    /// The diagrams' widths with their legends, and the margins.
    fn width(&self) -> f64 {
        let panels = self.panels.iter().map(|panel| {
            let (width, _) = size(panel, self.panels.len());
            left(panel) + width + legend::width(&panel.series)
        });
        (panels.sum::<f64>() + MARGIN * (1 + self.panels.len()) as f64).ceil()
    }
}

/// Room beside a diagram's frame, on the left.
fn left(panel: &Panel) -> f64 {
    match panel.kind {
        Kind::Cartesian => LEFT,
        Kind::Polar => 24.0,
    }
}
