//! Diagrams: axes and curves, independent of how they are drawn.

/// How a diagram's points are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Points are (x, y).
    Cartesian,
    /// Points are (angle, radius): degrees from the normal, positive on the side of
    /// the mirror direction, −90 … 90.
    Polar,
}

/// An axis: what it shows, and from where to where.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The quantity with its unit.
    pub label: String,
    /// The left or lower end.
    pub from: f64,
    /// The right or upper end; below `from` where the axis runs backwards.
    pub to: f64,
    /// Whether equal steps are equal factors.
    pub logarithmic: bool,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            label: label.into(),
            from,
            to,
            logarithmic: false,
        }
    }

    /// A logarithmic axis; both ends must be above 0.
    pub fn logarithmic(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            logarithmic: true,
            ..Self::linear(label, from, to)
        }
    }

    /// An angle from the normal in degrees, 0 … 90.
    pub fn angle(label: &str) -> Self {
        Self::linear(label, 0.0, 90.0)
    }
}

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its name in the legend; curves without one belong to an earlier one of the same colour.
    pub name: String,
    /// Which colour of the palette, from 0.
    pub colour: usize,
    /// Whether it is drawn dashed.
    pub dashed: bool,
    /// Points in the order in which they are joined.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A solid curve.
    pub fn new(name: impl Into<String>, colour: usize, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            colour,
            dashed: false,
            points,
        }
    }

    /// The same, dashed.
    #[must_use]
    pub fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }

    /// The value at `x`, linear between the points next to it; nothing outside of them.
    pub fn at(&self, x: f64) -> Option<f64> {
        self.points.windows(2).find_map(|pair| {
            let ((a, ya), (b, yb)) = (pair[0], pair[1]);
            let within = (a.min(b)..=a.max(b)).contains(&x);
            within.then(|| {
                if a == b {
                    ya
                } else {
                    ya + (yb - ya) * (x - a) / (b - a)
                }
            })
        })
    }

    /// The greatest value of the curve's points, at least 0.
    pub fn greatest(&self) -> f64 {
        self.points.iter().map(|p| p.1).fold(0.0, f64::max)
    }
}

/// A diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its own title, where a figure has more than one.
    pub title: String,
    /// How the points are meant.
    pub kind: Kind,
    /// The horizontal axis; of a polar diagram the angle, always −90 … 90.
    pub x: Axis,
    /// The vertical axis; of a polar diagram the radius, from 0.
    pub y: Axis,
    /// The curves.
    pub series: Vec<Series>,
}

impl Panel {
    /// A diagram of (x, y).
    pub fn cartesian(title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            kind: Kind::Cartesian,
            x,
            y,
            series,
        }
    }

    /// A half disc of radius `radius.to` above the surface.
    pub fn polar(title: impl Into<String>, radius: Axis, series: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            kind: Kind::Polar,
            x: Axis::linear("angle from the normal [°]", -90.0, 90.0),
            y: radius,
            series,
        }
    }
}
