//! Elements of a drawing: lines, curves, text. Lengths are in SVG units (CSS pixels).

use std::fmt::Write as _;

use svg::node::element::{Line, Polyline, Rectangle, Text};

/// Family of the embedded font, and what a viewer of the SVG takes instead.
pub const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Size of legends, tick labels and notes.
pub const SMALL: f64 = 12.0;
/// Size of axis labels and panel titles.
pub const MEDIUM: f64 = 13.0;
/// Size of the sheet's title.
pub const LARGE: f64 = 15.0;

pub const INK: &str = "#222222";
pub const FAINT: &str = "#dddddd";

/// Colours that colour-blind people, too, can tell apart (after Okabe and Ito).
const PALETTE: [&str; 8] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#222222", "#888888",
];

/// A colour of the palette, which repeats.
pub fn colour(index: usize) -> &'static str {
    PALETTE[index % PALETTE.len()]
}

/// How wide a text is at most, about: the font's letters are 0.6 em wide on average.
pub fn width(text: &str, size: f64) -> f64 {
    0.6 * size * text.chars().count() as f64
}

/// Where a text's given point is.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// A text whose baseline passes through the point.
pub fn text(content: &str, (x, y): (f64, f64), size: f64, anchor: Anchor) -> Text {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    Text::new(content)
        .set("x", number(x))
        .set("y", number(y))
        .set("font-size", size)
        .set("text-anchor", anchor)
}

/// A straight line.
pub fn line((x1, y1): (f64, f64), (x2, y2): (f64, f64), colour: &str) -> Line {
    Line::new()
        .set("x1", number(x1))
        .set("y1", number(y1))
        .set("x2", number(x2))
        .set("y2", number(y2))
        .set("stroke", colour)
}

/// A frame without filling.
pub fn frame((x, y): (f64, f64), width: f64, height: f64) -> Rectangle {
    Rectangle::new()
        .set("x", number(x))
        .set("y", number(y))
        .set("width", number(width))
        .set("height", number(height))
        .set("fill", "none")
}

/// A curve through points.
pub fn curve(points: impl Iterator<Item = (f64, f64)>, colour: &str, dashed: bool) -> Polyline {
    let mut list = String::new();
    for (x, y) in points {
        // Writing to a String can't fail.
        let _ = write!(list, "{},{} ", number(x), number(y));
    }
    let curve = Polyline::new()
        .set("points", list.trim_end())
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", 1.6)
        .set("stroke-linejoin", "round");
    if dashed {
        curve.set("stroke-dasharray", "6 4")
    } else {
        curve
    }
}

/// A coordinate to a hundredth, which no eye sees, kept near the sheet: what lies
/// further out is cut off all the same.
fn number(value: f64) -> f64 {
    (value.clamp(-1e5, 1e5) * 100.0).round() / 100.0
}

/// Lines of at most `limit` units' width, broken between words.
pub fn wrapped(text: &str, size: f64, limit: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.len() - 1;
        let line = &mut lines[last];
        if line.is_empty() {
            line.push_str(word);
        } else if width(line, size) + width(word, size) + size > limit {
            lines.push(word.to_owned());
        } else {
            line.push(' ');
            line.push_str(word);
        }
    }
    lines
}
