//! The shapes of `scenes/meshes`: a teapot with normals in its file, and a
//! knot whose normals a reader computes.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use microbrdf_scene::vector::{cross, length, sub, unit};

/// Segments about the teapot's axis.
const ABOUT: usize = 40;

/// Files by name.
#[must_use]
pub fn files() -> [(&'static str, String); 2] {
    [("teapot.obj", teapot()), ("knot.obj", knot())]
}

/// A surface over a grid of points; in both directions a smooth one.
struct Patch {
    /// Rows of points.
    rows: Vec<Vec<[f64; 3]>>,
    /// Whether each row is a closed curve, and the rows together.
    closed: [bool; 2],
}

/// What is written, counting vertices.
struct Writer {
    text: String,
    count: usize,
    normals: bool,
}

impl Writer {
    fn new(title: &str, normals: bool) -> Self {
        let text = format!(
            "# {title}; +z is up.\n# Made by `cargo run -p microbrdf-tests --bin meshes`; changes are lost.\n"
        );
        Self {
            text,
            count: 0,
            normals,
        }
    }

    fn name(&mut self, name: &str) {
        let _ = writeln!(self.text, "usemtl {name}");
    }

    /// A patch's points, normals and faces; points that coincide along a row
    /// are a pole.
    fn patch(&mut self, patch: &Patch) {
        let (height, width) = (patch.rows.len(), patch.rows[0].len());
        let first = self.count + 1;
        for (j, row) in patch.rows.iter().enumerate() {
            for (i, point) in row.iter().enumerate() {
                self.vector("v", *point);
                if self.normals {
                    self.vector("vn", patch.normal(i, j));
                }
            }
        }
        self.count += width * height;
        let at = |i: usize, j: usize| first + j % height * width + i % width;
        let rings = if patch.closed[1] { height } else { height - 1 };
        let columns = if patch.closed[0] { width } else { width - 1 };
        for j in 0..rings {
            for i in 0..columns {
                let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let pole = |j: usize| patch.is_pole(j % height);
                match (pole(j), pole(j + 1)) {
                    (true, true) => {}
                    (true, false) => self.face(&[corners[0], corners[2], corners[3]]),
                    (false, true) => self.face(&corners[..3]),
                    (false, false) => self.face(&corners),
                }
            }
        }
    }

    fn vector(&mut self, kind: &str, v: [f64; 3]) {
        // Without a negative zero.
        let [x, y, z] = v.map(|c| (c * 1e4).round() / 1e4 + 0.0);
        let _ = writeln!(self.text, "{kind} {x} {y} {z}");
    }

    fn face(&mut self, corners: &[usize]) {
        self.text.push('f');
        for corner in corners {
            let _ = match self.normals {
                true => write!(self.text, " {corner}//{corner}"),
                false => write!(self.text, " {corner}"),
            };
        }
        self.text.push('\n');
    }
}

impl Patch {
    fn is_pole(&self, j: usize) -> bool {
        length(sub(self.rows[j][0], self.rows[j][1])) < 1e-9
    }

    /// The unit normal, by differences of the neighbours; at a pole by those
    /// of the next row's.
    fn normal(&self, i: usize, j: usize) -> [f64; 3] {
        let (height, width) = (self.rows.len(), self.rows[0].len());
        let step = |at: usize, by: isize, size: usize, closed: bool| {
            let moved = at as isize + by;
            if closed {
                moved.rem_euclid(size as isize) as usize
            } else {
                moved.clamp(0, size as isize - 1) as usize
            }
        };
        if self.is_pole(j) {
            let inner = if j == 0 { 1 } else { j - 1 };
            let ring = |i: usize| sub(self.rows[inner][i % width], self.rows[j][0]);
            let about = cross(ring(0), ring(width / 4));
            let sign = if j == 0 { -1.0 } else { 1.0 };
            return unit(about.map(|c| c * sign));
        }
        let across = |by| step(i, by, width, self.closed[0]);
        let along = |by| step(j, by, height, self.closed[1]);
        unit(cross(
            sub(self.rows[j][across(1)], self.rows[j][across(-1)]),
            sub(self.rows[along(1)][i], self.rows[along(-1)][i]),
        ))
    }
}

/// Body, lid with knob, spout and handle, each under its own name.
fn teapot() -> String {
    let mut writer = Writer::new("A teapot", true);
    writer.name("body");
    writer.patch(&lathe(
        &[
            [0.56, 0.0],
            [0.6, 0.03],
            [0.6, 0.09],
            [0.84, 0.26],
            [1.0, 0.58],
            [0.93, 0.92],
            [0.72, 1.12],
            [0.62, 1.18],
            [0.63, 1.23],
            [0.58, 1.25],
        ],
        3,
    ));
    writer.name("lid");
    writer.patch(&lathe(
        &[
            [0.6, 1.2],
            [0.59, 1.25],
            [0.47, 1.34],
            [0.28, 1.41],
            [0.1, 1.45],
            [0.07, 1.49],
        ],
        3,
    ));
    writer.name("knob");
    writer.patch(&lathe(
        &[
            [0.07, 1.47],
            [0.08, 1.52],
            [0.15, 1.59],
            [0.16, 1.67],
            [0.09, 1.73],
            [0.0, 1.745],
        ],
        3,
    ));
    writer.name("spout");
    let spout = [
        [0.55, 0.46, 0.27, 0.27],
        [0.97, 0.51, 0.25, 0.27],
        [1.28, 0.78, 0.16, 0.19],
        [1.42, 1.05, 0.115, 0.13],
        [1.62, 1.24, 0.11, 0.12],
        [1.7, 1.27, 0.105, 0.115],
    ];
    writer.patch(&tube(&spout, 4, 20));
    // The mouth: a lip that turns inwards.
    let mouth = [
        [1.7, 1.27, 0.105, 0.115],
        [1.712, 1.2745, 0.095, 0.105],
        [1.7, 1.27, 0.085, 0.095],
        [1.62, 1.24, 0.08, 0.09],
    ];
    writer.patch(&tube(&mouth, 1, 20));
    writer.name("handle");
    let handle = [
        [-0.8, 1.02, 0.07, 0.1],
        [-1.12, 1.14, 0.065, 0.095],
        [-1.42, 1.06, 0.06, 0.09],
        [-1.5, 0.8, 0.06, 0.09],
        [-1.36, 0.52, 0.06, 0.09],
        [-0.86, 0.32, 0.075, 0.1],
    ];
    writer.patch(&tube(&handle, 4, 16));
    writer.text
}

/// A closed tube about a torus knot that goes twice round while it turns
/// three times.
fn knot() -> String {
    const STEPS: usize = 128;
    const AROUND: usize = 14;
    let place = |t: f64| {
        let (three, two) = ((3.0 * t).sin_cos(), (2.0 * t).sin_cos());
        let radius = 1.0 + 0.42 * three.1;
        [radius * two.1, radius * two.0, 0.42 * three.0]
    };
    let mut rows = Vec::new();
    for step in 0..STEPS {
        let t = TAU * step as f64 / STEPS as f64;
        let ahead = unit(sub(place(t + 1e-4), place(t - 1e-4)));
        // Away from the axis of the torus that it lies upon.
        let centre = (2.0 * t).sin_cos();
        let out = sub(place(t), [centre.1, centre.0, 0.0]);
        let aside = unit(cross(ahead, out));
        let out = cross(aside, ahead);
        rows.push(ring(place(t), aside, out, [0.2, 0.2], AROUND));
    }
    let mut writer = Writer::new("A torus knot", false);
    writer.name("knot");
    writer.patch(&Patch {
        rows,
        closed: [true, true],
    });
    writer.text
}

/// A profile of radii and heights turned about the z axis.
fn lathe(profile: &[[f64; 2]], between: usize) -> Patch {
    let points: Vec<_> = profile.iter().map(|[r, z]| [*r, *z, 0.0, 0.0]).collect();
    let ring = |[radius, z, ..]: [f64; 4]| {
        (0..ABOUT)
            .map(|i| {
                let (sin, cos) = (TAU * i as f64 / ABOUT as f64).sin_cos();
                [radius * cos, radius * sin, z]
            })
            .collect()
    };
    Patch {
        rows: spline(&points, between).into_iter().map(ring).collect(),
        closed: [true, false],
    }
}

/// A tube in the plane y = 0 through points of x, z and two radii: within the
/// plane and across it.
fn tube(points: &[[f64; 4]], between: usize, around: usize) -> Patch {
    let line = spline(points, between);
    let rows = (0..line.len())
        .map(|j| {
            let [before, after] =
                [j.saturating_sub(1), (j + 1).min(line.len() - 1)].map(|j| line[j]);
            let ahead = unit([after[0] - before[0], 0.0, after[1] - before[1]]);
            let out = [-ahead[2], 0.0, ahead[0]];
            let [x, z, inside, across] = line[j];
            ring([x, 0.0, z], [0.0, 1.0, 0.0], out, [across, inside], around)
        })
        .collect();
    Patch {
        rows,
        closed: [true, false],
    }
}

/// Points of an ellipse.
fn ring(
    centre: [f64; 3],
    a: [f64; 3],
    b: [f64; 3],
    radii: [f64; 2],
    around: usize,
) -> Vec<[f64; 3]> {
    (0..around)
        .map(|i| {
            let (sin, cos) = (TAU * i as f64 / around as f64).sin_cos();
            [0, 1, 2].map(|k| centre[k] + radii[0] * cos * a[k] + radii[1] * sin * b[k])
        })
        .collect()
}

/// A curve through points, with so many between two (Catmull and Rom's).
fn spline(points: &[[f64; 4]], between: usize) -> Vec<[f64; 4]> {
    let last = points.len() - 1;
    let mut curve = Vec::new();
    for i in 0..last {
        let [p, q, r, s] = [i.saturating_sub(1), i, i + 1, (i + 2).min(last)].map(|i| points[i]);
        for step in 0..=between {
            let t = step as f64 / (between + 1) as f64;
            curve.push([0, 1, 2, 3].map(|k| {
                let slopes = [0.5 * (r[k] - p[k]), 0.5 * (s[k] - q[k])];
                let (u, square) = (1.0 - t, t * t);
                u * u * (1.0 + 2.0 * t) * q[k]
                    + square * (3.0 - 2.0 * t) * r[k]
                    + t * u * u * slopes[0]
                    - square * u * slopes[1]
            }));
        }
    }
    curve.push(points[last]);
    curve
}
